// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/device_check.h"

#include "cli/text_table.h"

#include <QJsonArray>
#include <QJsonObject>
#include <array>

namespace chiron::cli {

namespace {

using mechanisms::FingertipPublished;

QString in(double value, int digits) {
    return QString::number(value, 'f', digits);
}

QJsonArray numbers(const std::vector<double>& values) {
    QJsonArray array;
    for (const double value : values)
        array.append(value);
    return array;
}

QJsonObject publishedJson() {
    QJsonArray cycles;
    for (const double rmse : FingertipPublished::kRmse_N)
        cycles.append(rmse);
    return {{"rmse_cycles_N", cycles},
            {"rmse_N", FingertipPublished::kMeanRmse_N},
            {"angle_error_deg", FingertipPublished::kMeanError_deg},
            {"angle_error_sd_deg", FingertipPublished::kSdError_deg}};
}

QJsonArray degradationJson(const FingertipCheck& check) {
    QJsonArray rows;
    for (const auto& row : check.degradation)
        rows.append(QJsonObject{{"what", QString::fromStdString(row.what)},
                                {"factor", row.factor},
                                {"rmse_N", row.rmse_N},
                                {"rmse_true_N", row.rmseTrue_N},
                                {"angle_error_deg", row.meanError_deg},
                                {"angle_error_true_deg", row.meanErrorTrue_deg},
                                {"most_N", row.largest_N},
                                {"holds", row.holds}});
    return rows;
}

QJsonObject seriesJson(const mechanisms::FingertipVerification& v) {
    QJsonArray poses;
    for (const auto& pose : v.poses)
        poses.append(
            QJsonArray{core::degFromRad(pose.referencePitch_rad), core::degFromRad(pose.referenceRoll_rad),
                       core::degFromRad(pose.measuredPitch_rad), core::degFromRad(pose.measuredRoll_rad),
                       core::degFromRad(pose.truePitch_rad), core::degFromRad(pose.trueRoll_rad)});
    return {{"time_s", numbers(v.series.time_s)},         {"reference_N", numbers(v.series.reference_N)},
            {"measured_N", numbers(v.series.measured_N)}, {"true_N", numbers(v.series.true_N)},
            {"height_m", numbers(v.series.height_m)},     {"poses_deg", poses}};
}

QJsonObject onFinger(const QString& name, const mechanisms::FingertipVerification& v) {
    return {{"finger", name},
            {"rmse_N", v.meanRmse_N},
            {"rmse_true_N", v.meanRmseTrue_N},
            {"gain", v.gain},
            {"phase_deg", v.phase_deg},
            {"angle_error_deg", v.meanError_deg},
            {"angle_error_true_deg", v.meanErrorTrue_deg},
            {"overshoot", v.overshoot},
            {"overshoot_of_force", v.overshootOfForce},
            {"static_error", v.staticError},
            {"asked_1_N_most_N", v.oneNewton_N},
            {"most_N", v.largest_N},
            {"identified", QJsonObject{{"stiffness_N_per_m", v.identified.stiffness_N_per_m},
                                       {"hardening_per_m", v.identified.hardening_per_m},
                                       {"surface_m", v.identified.surface_m}}},
            {"holds", v.holds()}};
}

QJsonArray fingersJson(const FingertipCheck& check) {
    QJsonArray rows{onFinger(QStringLiteral("assumed"), check.verification)};
    for (const auto& on : check.fingers)
        rows.append(onFinger(QString::fromStdString(on.finger), on.verified));
    return rows;
}

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

QJsonObject armJson(const mechanisms::FingertipArmVerification& arm) {
    using Published = mechanisms::FingertipArmPublished;
    using Bounds = mechanisms::FingertipArmBounds;
    QJsonArray drags;
    for (const auto& drag : arm.drags)
        drags.append(QJsonObject{{"axis", kAxes[static_cast<std::size_t>(drag.axis)]},
                                 {"speed_m_per_s", drag.speed_m_per_s},
                                 {"felt_N", drag.felt_N},
                                 {"given_N", drag.given_N}});
    return {{"holds", arm.holds()},
            {"freedoms", mechanisms::FingertipArmParameters::kJoints},
            {"poses", arm.poses},
            {"reached", arm.reached},
            {"condition", arm.condition},
            {"inverse_error_m", arm.inverse_m},
            {"inverse_error_rad", arm.inverse_rad},
            {"jacobian_error", arm.jacobian},
            {"gravity_error_Nm", arm.gravity_Nm},
            {"weight_N", arm.weight_N},
            {"sinks_m", arm.sinks_m},
            {"mass_kg", QJsonArray{arm.massLeast_kg, arm.massMost_kg}},
            {"friction", drags},
            {"friction_error", arm.frictionError()},
            {"encoder_bits", arm.encoderBits},
            {"encoder_count_m", QJsonArray{arm.countLeast_m, arm.countMost_m}},
            {"place_error_m", arm.place_m},
            {"bounds", QJsonObject{{"condition", Bounds::kCondition},
                                   {"inverse_error_m", Bounds::kInverse_m},
                                   {"inverse_error_rad", Bounds::kInverse_rad},
                                   {"jacobian_error", Bounds::kJacobian},
                                   {"gravity_error_Nm", Bounds::kGravity_Nm},
                                   {"weight_N", Bounds::kWeight_N},
                                   {"sinks_m", Bounds::kSinks_m},
                                   {"friction_error", Bounds::kFriction},
                                   {"encoder_count_m", Bounds::kCount_m},
                                   {"place_error_m", Bounds::kPlace_m}}},
            {"published", QJsonObject{{"freedoms", Published::kFreedoms},
                                      {"wrist_by_imu", Published::kWrist},
                                      {"place_by_encoders", Published::kPlace},
                                      {"grasp_by_hall_sensor", Published::kGrasp}}}};
}

QJsonObject toJson(const FingertipCheck& check, bool withSeries) {
    const auto& v = check.verification;
    QJsonArray cycles;
    for (const double rmse : v.rmse_N)
        cycles.append(rmse);
    QJsonObject json{
        {"mechanism", "fingertip_arm"},
        // A text, because JSON numbers lose digits of large seeds.
        {"seed", QString::number(check.seed)},
        {"simulated", true},
        {"serial_number", serialJson(check.serialNumber)},
        {"holds", holds(check)},
        {"bounds", QJsonObject{{"rmse_N", FingertipPublished::kMeanRmse_N},
                               {"angle_error_deg", FingertipPublished::kMeanError_deg},
                               {"overshoot_of_force", mechanisms::FingertipBounds::kOvershootOfForce},
                               {"most_N", mechanisms::FingertipBounds::kLimit_N}}},
        {"fingers", fingersJson(check)},
        {"frequency_Hz", v.settings.frequency_Hz},
        {"peak_N", v.settings.peak_N},
        {"rmse_cycles_N", cycles},
        {"rmse_N", v.meanRmse_N},
        {"rmse_true_N", v.meanRmseTrue_N},
        {"poses", v.settings.poses},
        {"angle_error_deg", v.meanError_deg},
        {"angle_error_sd_deg", v.sdError_deg},
        {"angle_error_true_deg", v.meanErrorTrue_deg},
        {"latency_us", 1e6 * v.latency_s},
        {"friction", QJsonObject{{"coulomb_N", check.friction.coulomb_N},
                                 {"viscous_Ns_per_m", check.friction.viscous_Ns_per_m}}},
        {"damping_Ns_per_m", check.damping_Ns_per_m},
        {"stiffness_cap_N_per_m", check.stiffnessCap_N_per_m},
        {"arm", armJson(check.arm)},
        {"published", publishedJson()}};
    if (!check.degradation.empty())
        json["degradation"] = degradationJson(check);
    if (withSeries)
        json["series"] = seriesJson(v);
    return json;
}

QString armText(const mechanisms::FingertipArmVerification& arm) {
    using Published = mechanisms::FingertipArmPublished;
    using Bounds = mechanisms::FingertipArmBounds;
    const QString none = QStringLiteral("not printed");
    const auto power = [](double value) { return QString::number(value, 'e', 1); };
    const auto span = [](double least, double most, int digits) {
        return QStringLiteral("%1 to %2").arg(in(least, digits), in(most, digits));
    };
    TextTable table(
        {QStringLiteral("arm"), QStringLiteral(">here"), QStringLiteral(">bound"), QStringLiteral(">P3")});
    table.add({QStringLiteral("degrees of freedom: wrist, place, grasp"),
               QStringLiteral("%1: %2 + %3 + 1")
                   .arg(mechanisms::FingertipArmParameters::kJoints)
                   .arg(3)
                   .arg(mechanisms::FingertipArmParameters::kArm),
               {},
               QStringLiteral("%1: %2 + %3 + %4")
                   .arg(Published::kFreedoms)
                   .arg(Published::kWrist)
                   .arg(Published::kPlace)
                   .arg(Published::kGrasp)});
    table.add({QStringLiteral("poses of the box within reach"),
               QStringLiteral("%1 of %2").arg(arm.reached).arg(arm.poses), QStringLiteral("all"), none});
    table.add({QStringLiteral("condition number of the place's Jacobian, worst"), in(arm.condition, 2),
               in(Bounds::kCondition, 2), none});
    table.add({QStringLiteral("inverse kinematics, there and back (m)"), power(arm.inverse_m),
               power(Bounds::kInverse_m), none});
    table.add({QStringLiteral("inverse kinematics, there and back (rad)"), power(arm.inverse_rad),
               power(Bounds::kInverse_rad), none});
    table.add({QStringLiteral("Jacobian beside differences (m/rad, rad/rad)"), power(arm.jacobian),
               power(Bounds::kJacobian), none});
    table.add({QStringLiteral("gravity beside the potential's differences (N·m)"), power(arm.gravity_Nm),
               power(Bounds::kGravity_Nm), none});
    table.add({QStringLiteral("weight that a hand carries at the pad, most (N)"), in(arm.weight_N, 3),
               in(Bounds::kWeight_N, 3), none});
    table.add({QStringLiteral("sinks in 0.5 s without a hand, most (mm)"), in(1e3 * arm.sinks_m, 2),
               in(1e3 * Bounds::kSinks_m, 2), none});
    table.add({QStringLiteral("mass that a hand moves along (kg)"),
               span(arm.massLeast_kg, arm.massMost_kg, 3),
               {},
               none});
    table.add({QStringLiteral("a count of an encoder of %1 bits at the pad (µm)").arg(arm.encoderBits),
               span(1e6 * arm.countLeast_m, 1e6 * arm.countMost_m, 1), in(1e6 * Bounds::kCount_m, 1), none});
    table.add({QStringLiteral("pad beside where the encoders say, most (mm)"), in(1e3 * arm.place_m, 2),
               in(1e3 * Bounds::kPlace_m, 2), none});
    TextTable felt({QStringLiteral("led along"), QStringLiteral(">speed (mm/s)"),
                    QStringLiteral(">felt at the pad (N)"), QStringLiteral(">given (N)")});
    for (const auto& drag : arm.drags)
        felt.add({kAxes[static_cast<std::size_t>(drag.axis)], shortNumber(1e3 * drag.speed_m_per_s),
                  in(drag.felt_N, 4), in(drag.given_N, 4)});
    return QStringLiteral("\nThe arm, seven joints in series without motors: what is felt at the pad is its "
                          "friction, weight and mass.\n\n") +
           table.toText() +
           QStringLiteral("\nFriction of the joints as a hand feels it at the pad, within %1 % of what they "
                          "were given:\n\n")
               .arg(100.0 * Bounds::kFriction, 0, 'f', 0) +
           felt.toText();
}

QString figures(const FingertipCheck& check) {
    const auto& v = check.verification;
    TextTable table({QStringLiteral("figure"), QStringLiteral(">here"), QStringLiteral(">P3"),
                     QStringLiteral(">really")});
    for (std::size_t cycle = 0; cycle < 3; ++cycle)
        table.add({QStringLiteral("force RMSE, cycle %1 (N)").arg(cycle + 1), in(v.rmse_N[cycle], 4),
                   in(FingertipPublished::kRmse_N[cycle], 3), in(v.rmseTrue_N[cycle], 4)});
    table.add({QStringLiteral("force RMSE, mean (N)"), in(v.meanRmse_N, 4),
               in(FingertipPublished::kMeanRmse_N, 4), in(v.meanRmseTrue_N, 4)});
    table.add({QStringLiteral("angle error, mean (°)"), in(v.meanError_deg, 2),
               in(FingertipPublished::kMeanError_deg, 2), in(v.meanErrorTrue_deg, 2)});
    table.add({QStringLiteral("angle error, SD (°)"), in(v.sdError_deg, 2),
               in(FingertipPublished::kSdError_deg, 2), in(v.sdErrorTrue_deg, 2)});
    return table.toText();
}

QString fingers(const FingertipCheck& check) {
    TextTable table({QStringLiteral("finger"), QStringLiteral(">RMSE (N)"), QStringLiteral(">gain"),
                     QStringLiteral(">phase (°)"), QStringLiteral(">angle (°)"), QStringLiteral(">overshoot"),
                     QStringLiteral(">of force"), QStringLiteral(">1 N: most (N)"),
                     QStringLiteral(">4 N: most (N)"), QStringLiteral("in bounds")});
    const auto add = [&table](const QString& name, const mechanisms::FingertipVerification& v) {
        table.add({name, in(v.meanRmseTrue_N, 4), in(v.gain, 3), in(v.phase_deg, 1),
                   in(v.meanErrorTrue_deg, 2), in(100.0 * v.overshoot, 0) + QStringLiteral(" %"),
                   in(100.0 * v.overshootOfForce, 1) + QStringLiteral(" %"), in(v.oneNewton_N, 2),
                   in(v.largest_N, 2), v.holds() ? QStringLiteral("yes") : QStringLiteral("no")});
    };
    add(QStringLiteral("assumed"), check.verification);
    for (const auto& on : check.fingers)
        add(QString::fromStdString(on.finger), on.verified);
    table.add({QStringLiteral("bound"),
               in(FingertipPublished::kMeanRmse_N, 4),
               {},
               {},
               in(FingertipPublished::kMeanError_deg, 2),
               {},
               in(100.0 * mechanisms::FingertipBounds::kOvershootOfForce, 1) + QStringLiteral(" %"),
               {},
               in(mechanisms::FingertipBounds::kLimit_N, 2),
               {}});
    return QStringLiteral("\nWhat the pad really got, on eight simulated fingers that the platform "
                          "identified by its own sensors:\n\n") +
           table.toText();
}

QString degradation(const FingertipCheck& check) {
    TextTable table({QStringLiteral("what"), QStringLiteral(">times"), QStringLiteral(">RMSE (N)"),
                     QStringLiteral(">really (N)"), QStringLiteral(">angle (°)"),
                     QStringLiteral(">really (°)"), QStringLiteral("in bounds")});
    for (const auto& row : check.degradation)
        table.add({QString::fromStdString(row.what), QString::number(row.factor), in(row.rmse_N, 4),
                   in(row.rmseTrue_N, 4), in(row.meanError_deg, 2), in(row.meanErrorTrue_deg, 2),
                   row.holds ? QStringLiteral("yes") : QStringLiteral("no")});
    return QLatin1Char('\n') + table.toText();
}

} // namespace

QJsonValue serialJson(const std::string& serialNumber) {
    return serialNumber.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(serialNumber));
}

QString serialWords(const std::string& serialNumber) {
    return serialNumber.empty() ? QStringLiteral("not reported by the device")
                                : QString::fromStdString(serialNumber);
}

CommandOutput describeFingertipCheck(const FingertipCheck& check, bool withSeries) {
    const auto& v = check.verification;
    QString text =
        QStringLiteral(
            "Fingertip platform, simulated; seed %1; sine 0 to %2 N at %3 Hz, %4 poses.\n"
            "\"here\" is what its own sensors measure, as P3 did; \"really\" what the pad gets.\n\n")
            .arg(check.seed)
            .arg(v.settings.peak_N)
            .arg(v.settings.frequency_Hz)
            .arg(v.settings.poses);
    text += figures(check) + QLatin1Char('\n');
    text += alignedPairs({{QStringLiteral("serial number"), serialWords(check.serialNumber)},
                          {QStringLiteral("latency"), in(1e3 * v.latency_s, 1) + QStringLiteral(" ms")},
                          {QStringLiteral("friction of a drive"),
                           QStringLiteral("%1 N + %2 N·s/m")
                               .arg(in(check.friction.coulomb_N, 3), in(check.friction.viscous_Ns_per_m, 2))},
                          {QStringLiteral("stiffest wall"), QStringLiteral("%1 N/m, with b + B = %2 N·s/m")
                                                                .arg(in(check.stiffnessCap_N_per_m, 0),
                                                                     shortNumber(check.damping_Ns_per_m))}});
    text += fingers(check);
    if (!check.degradation.empty())
        text += degradation(check);
    text += armText(check.arm);
    const bool platform = check.verification.holds() && mechanisms::holdsOnAll(check.fingers);
    text += QLatin1Char('\n') +
            (platform
                 ? QStringLiteral("Within its bounds on all fingers, in simulation: P3's errors in force and "
                                  "angle, no overshoot that is felt, never more than 4 N on the pad.\n")
                 : QStringLiteral("Not within its bounds on all fingers, in simulation: see the table.\n"));
    text += check.arm.holds()
                ? QStringLiteral("The arm is within its bounds, in simulation. A real device has to be "
                                 "measured on its own.\n")
                : QStringLiteral("The arm is not within its bounds, in simulation: see its table.\n");
    return {QJsonDocument(toJson(check, withSeries)), text, holds(check) ? 0 : 1};
}

bool holds(const FingertipCheck& check) noexcept {
    return check.verification.holds() && mechanisms::holdsOnAll(check.fingers) && check.arm.holds();
}

} // namespace chiron::cli
