// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/device_check.h"
#include "cli/text_table.h"
#include "devices/api/device_descriptor.h"
#include "devices/driver_catalogue.h"
#include "mechanisms/friction_identification.h"
#include "mechanisms/scripted_motion.h"
#include "session/delay_measurement.h"
#include "session/friction_felt.h"
#include "session/station.h"

#include <QJsonArray>
#include <QJsonObject>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace chiron::cli {

namespace {

core::Result<CommandOutput> list(const Arguments&) {
    QJsonArray drivers;
    TextTable table({QStringLiteral("driver"), QStringLiteral("class"), QStringLiteral("title"),
                     QStringLiteral("needs")});
    TextTable plugged({QStringLiteral("driver"), QStringLiteral("connected"), QStringLiteral("serial number"),
                       QStringLiteral("address")});
    bool any = false;
    for (const devices::Driver* entry : devices::driverCatalogue()) {
        const devices::Driver& driver = *entry;
        const QString id = QString::fromStdString(std::string(driver.id));
        const QString title = QString::fromStdString(std::string(driver.title));
        const QString needs = QString::fromStdString(std::string(driver.needs));
        const QString kind = driver.deviceClass == devices::DeviceClass::felt ? QStringLiteral("felt")
                                                                              : QStringLiteral("shown");
        QJsonArray connected;
        for (const devices::FoundDevice& found : driver.discover()) {
            if (found.address.empty())
                continue; // always there
            const QString model = QString::fromStdString(found.model);
            const QString address = QString::fromStdString(found.address);
            connected.append(QJsonObject{{QStringLiteral("model"), model},
                                         {QStringLiteral("serial_number"), serialJson(found.serialNumber)},
                                         {QStringLiteral("address"), address}});
            plugged.add({id, model, serialWords(found.serialNumber), address});
        }
        drivers.append(QJsonObject{{QStringLiteral("id"), id},
                                   {QStringLiteral("title"), title},
                                   {QStringLiteral("class"), kind},
                                   {QStringLiteral("needs"), needs},
                                   {QStringLiteral("connected"), connected}});
        any = any || !connected.isEmpty();
        table.add({id, kind, title, needs});
    }
    return CommandOutput{QJsonDocument(drivers),
                         table.toText() + (any ? QStringLiteral("\n") + plugged.toText() : QString()), 0};
}

/// Id of the only driver that the check supports: that of the simulated mechanisms.
std::string checkedDriver() {
    return std::string(devices::usualDriver(devices::MovedBy::scriptedOperator).id);
}

/// Refuses every driver but checkedDriver().
core::Result<void> refuseOtherDrivers(const QString& driver) {
    if (driver.isEmpty() || driver.toStdString() == checkedDriver())
        return {};
    if (devices::findDriver(driver.toStdString()) == nullptr)
        return wrongUse(
            QStringLiteral("--driver: %1: unknown; see chiron-cli device list").arg(quoted(driver)));
    return core::fail(core::ErrorCode::device, "--driver: " + driver.toStdString() +
                                                   ": it has no motors that could be checked; expected " +
                                                   checkedDriver());
}

core::Result<CommandOutput> checkFingertip(const Arguments& arguments, std::optional<double> damping) {
    const auto seed = arguments.seed(QStringLiteral("seed"), 1);
    mechanisms::FingertipVerificationSettings settings;
    const auto frequency = arguments.number(QStringLiteral("frequency"), 0.05, 5.0, settings.frequency_Hz);
    const auto poses = arguments.integer(QStringLiteral("poses"), 1, 10000, settings.poses);
    CHIRON_TRY(seed);
    CHIRON_TRY(frequency);
    CHIRON_TRY(poses);
    settings.frequency_Hz = *frequency;
    settings.poses = static_cast<int>(*poses);
    const mechanisms::FingertipPlatformParameters plant;
    auto verified = mechanisms::verifyFingertip(plant, *seed, settings);
    CHIRON_TRY(verified);
    FingertipCheck check;
    check.seed = *seed;
    check.verification = std::move(*verified);
    auto fingers = mechanisms::verifyFingertipOnFingers(plant, *seed, settings);
    CHIRON_TRY(fingers);
    check.fingers = std::move(*fingers);
    check.friction = mechanisms::identifyFingertipFriction(plant);
    auto arm = mechanisms::verifyFingertipArm({}, *seed);
    CHIRON_TRY(arm);
    check.arm = std::move(*arm);
    check.damping_Ns_per_m = damping.value_or(mechanisms::fingertipDamping_Ns_per_m(check.friction, plant));
    check.stiffnessCap_N_per_m = mechanisms::stiffnessCap_N_per_m(check.damping_Ns_per_m, core::kTickSeconds,
                                                                  check.verification.latency_s);
    if (arguments.has(QStringLiteral("degrade"))) {
        auto table = mechanisms::degradeFingertip(plant, *seed, settings);
        CHIRON_TRY(table);
        check.degradation = std::move(*table);
    }
    return describeFingertipCheck(check, arguments.has(QStringLiteral("series")));
}

constexpr double kDelayTolerance_s = 0.0002; ///< a fifth of a tick

/// A device's delay, and the serial number that it reports (DeviceDescriptor::serialNumber).
struct MeasuredDelay {
    haptics::DelayEstimate estimate;
    std::string serialNumber;
};

/// Measures the gimbal's delay in the same way as on any device: with an excitation force through loop and
/// supervisor, while a hand rests on it.
core::Result<MeasuredDelay> delayOf(const mechanisms::GimbalPlantParameters& plant) {
    session::SimulatedHand atRest;
    atRest.strategy = std::make_unique<mechanisms::ScriptedMotion>(devices::kHeldFrom_D);
    atRest.plant = plant;
    auto station = session::simulatedStation(devices::kGimbalHprd, std::move(atRest));
    CHIRON_TRY(station);
    const session::StationTool& tool = station->tools.front();
    const auto estimate = session::measureDelay(*tool.device, tool.mapping);
    CHIRON_TRY(estimate);
    return MeasuredDelay{*estimate, tool.device->descriptor().serialNumber};
}

/// The friction felt at rest and in motion, before and after its compensation.
QJsonObject frictionFeltJson(const session::FrictionFelt& felt, QString& text) {
    TextTable table({QStringLiteral("direction"), QStringLiteral(">speed (mm/s)"),
                     QStringLiteral(">felt before (N)"), QStringLiteral(">after (N)")});
    QJsonArray rows;
    for (const session::FrictionFeltRow& row : felt.rows) {
        rows.append(QJsonObject{{"direction", QString::fromStdString(row.direction)},
                                {"speed_m_per_s", row.speed_m_per_s},
                                {"before_N", row.before_N},
                                {"after_N", row.after_N}});
        table.add({QString::fromStdString(row.direction), shortNumber(1e3 * row.speed_m_per_s),
                   QString::number(row.before_N, 'f', 3), QString::number(row.after_N, 'f', 3)});
    }
    text = QStringLiteral("\nFriction that a hand feels with nothing touched, before and after %1 % of the "
                          "Coulomb friction is fed forward\n")
               .arg(100.0 * felt.compensation, 0, 'f', 0) +
           table.toText() + QLatin1Char('\n') +
           alignedPairs({{QStringLiteral("held still, change felt"), QStringLiteral("%1 N before, %2 N after")
                                                                         .arg(felt.heldBefore_N, 0, 'f', 3)
                                                                         .arg(felt.heldAfter_N, 0, 'f', 3)},
                         {QStringLiteral("work of the hand"), QStringLiteral("%1 mJ before, %2 mJ after")
                                                                  .arg(1e3 * felt.workBefore_J, 0, 'f', 1)
                                                                  .arg(1e3 * felt.workAfter_J, 0, 'f', 1)}});
    return {{"compensation", felt.compensation},  {"rows", rows},
            {"held_before_N", felt.heldBefore_N}, {"held_after_N", felt.heldAfter_N},
            {"work_before_J", felt.workBefore_J}, {"work_after_J", felt.workAfter_J}};
}

/// Checks P2's gimbal: the friction of its motor axes, identified by Tholey's method, must agree within a
/// twentieth with the friction given to the plant, and the measured delay with the age of its samples plus
/// the lag of its motors.
core::Result<CommandOutput> checkGimbal(double damping, int sampleDelay_ticks) {
    mechanisms::GimbalPlantParameters parameters;
    parameters.sampleDelay_ticks = sampleDelay_ticks;
    mechanisms::GimbalPlant plant(parameters);
    const auto found = mechanisms::identifyFriction(plant, {});
    CHIRON_TRY(found);
    const double given_s = core::kTickSeconds * parameters.sampleDelay_ticks + parameters.amplifierLag_s;
    const auto delay = delayOf(parameters);
    CHIRON_TRY(delay);
    const double latency_s = delay->estimate.delay_s;
    const double cap = mechanisms::stiffnessCap_N_per_m(damping, core::kTickSeconds, latency_s);
    const auto felt = session::feelFriction(parameters, devices::kMostFrictionCompensation);
    CHIRON_TRY(felt);
    TextTable table({QStringLiteral("axis"), QStringLiteral(">Coulomb"), QStringLiteral(">given"),
                     QStringLiteral(">viscous"), QStringLiteral(">given")});
    QJsonArray axes;
    bool holds = std::abs(latency_s - given_s) <= kDelayTolerance_s && felt->holds();
    const std::array<const char*, 4> names{"heading", "pitch", "roll", "depth"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto& axis = (*found)[i];
        if (!axis)
            continue;
        const auto& given = parameters.friction[i];
        holds = holds && std::abs(axis->coulomb - given.coulomb) <= 0.05 * given.coulomb &&
                std::abs(axis->viscous - given.viscous) <= 0.05 * given.viscous;
        axes.append(QJsonObject{{"axis", names[i]}, {"coulomb", axis->coulomb}, {"viscous", axis->viscous}});
        table.add({names[i], shortNumber(axis->coulomb), shortNumber(given.coulomb),
                   shortNumber(axis->viscous), shortNumber(given.viscous)});
    }
    QString feltText;
    const QJsonObject feltJson = frictionFeltJson(*felt, feltText);
    const QString text =
        QStringLiteral("Gimbal, simulated; N·m and N·m·s/rad, depth N and N·s/m.\n\n") + table.toText() +
        QLatin1Char('\n') +
        alignedPairs(
            {{QStringLiteral("serial number"), serialWords(delay->serialNumber)},
             {QStringLiteral("latency, measured"),
              QStringLiteral("%1 ± %2 ms")
                  .arg(shortNumber(1e3 * latency_s), shortNumber(1e3 * delay->estimate.standardError_s))},
             {QStringLiteral("latency, given"), shortNumber(1e3 * given_s) + QStringLiteral(" ms")},
             {QStringLiteral("stiffest wall"), shortNumber(cap) + QStringLiteral(" N/m")}}) +
        feltText;
    return CommandOutput{
        QJsonDocument(QJsonObject{{"mechanism", "gimbal_hprd"},
                                  {"serial_number", serialJson(delay->serialNumber)},
                                  {"holds", holds},
                                  {"friction", axes},
                                  {"friction_felt", feltJson},
                                  {"latency_us", 1e6 * latency_s},
                                  {"latency_error_us", 1e6 * delay->estimate.standardError_s},
                                  {"latency_given_us", 1e6 * given_s},
                                  {"damping_Ns_per_m", damping},
                                  {"stiffness_cap_N_per_m", cap}}),
        text, holds ? 0 : 1};
}

core::Result<CommandOutput> check(const Arguments& arguments) {
    CHIRON_TRY(refuseOtherDrivers(arguments.value(QStringLiteral("driver"))));
    const QString fingertip = QStringLiteral("fingertip_arm");
    const QString gimbal = QStringLiteral("gimbal_hprd");
    const auto mechanism = arguments.choice(QStringLiteral("mechanism"), {fingertip, gimbal}, fingertip);
    // models.md: the default B of a wall.
    const auto damping = arguments.number(QStringLiteral("damping"), 0.01, 100.0, 2.0);
    CHIRON_TRY(mechanism);
    CHIRON_TRY(damping);
    const auto sampleDelay = arguments.integer(QStringLiteral("sample-delay"), 0, 3, 0);
    CHIRON_TRY(sampleDelay);
    const auto isOnlyFor = [&](const QString& option, const QString& expected) {
        return wrongUse(QStringLiteral("--%1: means nothing with --mechanism %2; expected it with %3 alone")
                            .arg(option, *mechanism, expected));
    };
    if (*mechanism == fingertip && arguments.has(QStringLiteral("sample-delay")))
        return isOnlyFor(QStringLiteral("sample-delay"), gimbal);
    if (*mechanism == fingertip)
        return checkFingertip(arguments, arguments.has(QStringLiteral("damping")) ? std::optional(*damping)
                                                                                  : std::nullopt);
    for (const char* option : {"seed", "frequency", "poses", "degrade", "series"})
        if (arguments.has(QString::fromLatin1(option)))
            return isOnlyFor(QLatin1String(option), fingertip);
    return checkGimbal(*damping, static_cast<int>(*sampleDelay));
}

CommandSpec checkCommand() {
    CommandSpec command;
    command.group = QStringLiteral("device");
    command.verb = QStringLiteral("check");
    command.summary = QStringLiteral(
        "verify a mechanism: force and angle beside P3's figures, the arm, friction, latency, stiffness cap");
    command.options = {
        {QStringLiteral("mechanism"), QStringLiteral("ID"),
         QStringLiteral(
             "fingertip_arm (default) or gimbal_hprd (friction, what is felt of it, and latency)")},
        {QStringLiteral("driver"), QStringLiteral("ID"),
         QStringLiteral("the device's driver (default: %1)").arg(QString::fromStdString(checkedDriver()))},
        {QStringLiteral("seed"), QStringLiteral("S"),
         QStringLiteral("of sensor noise and poses (default 1)")},
        {QStringLiteral("frequency"), QStringLiteral("HZ"),
         QStringLiteral("of the 1 N sine, 0.05 to 5 (default 0.5; P3 does not print it)")},
        {QStringLiteral("poses"), QStringLiteral("N"),
         QStringLiteral("random orientations, 1 to 10000 (default 100)")},
        {QStringLiteral("damping"), QStringLiteral("B"),
         QStringLiteral("of device, hand and wall together in the stiffness cap, N·s/m (default: drives and "
                        "pad; gimbal: 2)")},
        {QStringLiteral("sample-delay"), QStringLiteral("TICKS"),
         QStringLiteral("of gimbal_hprd: how old its samples are, 0 to 3 (default 0)")},
        {QStringLiteral("degrade"),
         {},
         QStringLiteral(
             "also a table: force noise, converter, delay, friction, backlash, IMU times 0, 1, 2, 4")},
        {QStringLiteral("series"),
         {},
         QStringLiteral("with --json also every tick of the sine and every pose")}};
    command.example = QStringLiteral("chiron-cli device check --seed 1 --degrade --json");
    command.run = check;
    return command;
}

} // namespace

std::vector<CommandSpec> deviceCommands() {
    CommandSpec command;
    command.group = QStringLiteral("device");
    command.verb = QStringLiteral("list");
    command.summary = QStringLiteral("the devices that this build can drive");
    command.example = QStringLiteral("chiron-cli device list --json");
    command.run = list;
    return {command, checkCommand()};
}

} // namespace chiron::cli
