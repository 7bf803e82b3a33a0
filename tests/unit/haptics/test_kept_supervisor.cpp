// SPDX-License-Identifier: GPL-3.0-or-later
// What the supervisor lets through, block after block of written episodes, with books, guards and words, what
// settings it refuses in which words, and what delays are found in made answers, against what was looked at
// and kept. Its promises have tests of their own (the oracle of test_safety_property bounds every row); here
// no share, order or threshold within those bounds changes unsaid: recordings are computed again by it. A
// change that is meant is kept anew, and its difference is read in review: CHIRON_STORE_OUTLINES=1 ctest
// --test-dir build/release -R "^test_kept_supervisor$"
#include "core/fp_environment.h"
#include "core/units.h"
#include "haptics/delay_estimate.h"
#include "haptics/delay_probe.h"
#include "haptics/latency_histogram.h"
#include "support/kept_numbers.h"
#include "unit/haptics/safety_rig.h"

#include <QtTest>
#include <complex>
#include <limits>
#include <random>

using namespace chiron;
using core::CommandKind;
using core::Vec3;
using tests::NumberLines;

namespace {

constexpr int kTicks = 2400, kBlock = 60;

/// The same numbers with every library.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : m_engine(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(m_engine() >> 11) * 0x1p-53;
    }
    Vec3 vector(double most) {
        const double x = between(-most, most), y = between(-most, most);
        return {x, y, between(-most, most)};
    }

private:
    std::mt19937_64 m_engine;
};

/// Settings with short ramps, so that an episode comes through every state.
haptics::SafetySettings quick() {
    haptics::SafetySettings s;
    s.armingRamp_ms = 60;
    s.stillTime_ms = 40;
    s.pauseRamp_ms = 50;
    s.heartbeatRamp_ms = 70;
    return s;
}

enum class Bodies { unsaid, one, each };

struct Episode {
    const char* name;
    std::vector<devices::DeviceDescriptor> devices;
    haptics::SafetySettings settings = quick();
    Bodies bodies = Bodies::unsaid;
    bool arm = false;         ///< the tools are arms whose lever depends on the pose
    double stiffness = 600.0; ///< of the walls
    double active = 0.0;      ///< by how much more they push on the way out: what makes energy
    bool eventful = true;     ///< stops, pauses, silence, jumps and rubbish in between
    devices::WorkspaceMapping mapping = {};
};

devices::DeviceDescriptor device(double force_N, double torque_Nm, std::uint32_t period_us = 1000,
                                 bool inProcess = false) {
    devices::DeviceDescriptor d = test::sixAxisDevice(8.0, 0.12);
    d.maximumForce_N = force_N;
    d.maximumTorque_Nm = torque_Nm;
    d.period_us = period_us;
    d.inProcess = inProcess;
    d.maximumDamping_Ns_per_m = 20.0;
    return d;
}

std::vector<Episode> episodes() {
    devices::DeviceDescriptor shown = device(0.0, 0.0);
    shown.rendersForce = false;
    devices::DeviceDescriptor pad = device(4.0, 0.0, 1000, true);
    for (devices::AxisDescriptor& axis : pad.axes)
        axis.continuousRating = 0.0;
    Episode usual{"one tool", {device(5.0, 0.2)}};
    Episode calm{"one tool, calm, on a wall that makes energy", {device(5.0, 0.2)}};
    calm.eventful = false;
    calm.active = 0.15;
    Episode two{"two tools on one body that gives way", {device(5.0, 0.0), device(3.0, 0.1)}};
    two.bodies = Bodies::one;
    two.active = 0.1;
    Episode each{"two tools, a body each", {device(5.0, 0.0), device(3.0, 0.1)}};
    each.bodies = Bodies::each;
    each.eventful = false;
    each.active = 0.2;
    Episode knee{"an arm, forces bent into their cap", {device(2.0, 0.1)}};
    knee.settings.capKnee = 0.3;
    knee.settings.exerciseForce_N = 1.5;
    knee.arm = true;
    knee.stiffness = 1500.0;
    Episode mixed{"a slow tool, one that is shown, a pad", {device(6.0, 0.1, 4000), shown, pad}};
    Episode turned{"a scaled and mirrored workspace", {device(6.0, 0.1, 2000, true)}};
    turned.mapping.scale = 2.0;
    turned.mapping.leftHanded = true;
    turned.active = 0.1;
    Episode unseen{"only shown", {shown}};
    return {usual, calm, two, each, knee, mixed, turned, unseen};
}

QStringList run(const Episode& e) {
    Draw draw(99);
    haptics::SafetySupervisor supervisor;
    const test::CartesianKinematics cartesian{};
    const test::ArmKinematics arm{};
    std::vector<haptics::SafetyTool> tools;
    for (const devices::DeviceDescriptor& d : e.devices)
        tools.push_back(
            {d, e.arm ? static_cast<const devices::IToolKinematics&>(arm) : cartesian, e.mapping});
    NumberLines lines;
    if (const auto configured = supervisor.configure(e.settings, tools); !configured) {
        lines.add(QString::fromStdString(configured.error().message));
        return lines.lines();
    }
    const std::size_t count = e.devices.size();
    for (std::size_t i = 0; i < count; ++i)
        lines.add(QStringLiteral("tool %1: renders %2, budget")
                      .arg(i)
                      .arg(supervisor.rendersForce(static_cast<int>(i))),
                  {supervisor.dampingBudget_Ns_per_m(static_cast<int>(i))});

    realtime::TickSource source;
    core::ToolStates states;
    states.count = static_cast<int>(count);
    std::array<core::DeviceSample, core::kMaxTools> samples{};
    std::array<std::int64_t, core::kMaxTools> arrived_us{};
    std::array<Vec3, core::kMaxTools> before{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    haptics::SafetyOutput out;
    struct Sums {
        double gain = 0.0, admissions = 0.0, enabled = 0.0;
        Vec3 force = Vec3::Zero(), torque = Vec3::Zero(), device = Vec3::Zero(), compensation = Vec3::Zero(),
             display = Vec3::Zero(), display_D = Vec3::Zero();
    };
    std::array<Sums, core::kMaxTools> sums{};
    std::uint32_t guards = 0;
    double guardTicks = 0.0, ready = 0.0;
    for (int tick = 0; tick < kTicks; ++tick) {
        const std::int64_t now_us = 1'000'000 + 1000 * tick;
        const auto now = source.next(1000 * now_us);
        simulation::SceneOutput scene;
        scene.tissue.count = static_cast<int>(count);
        haptics::SafetyInput in{states, scene};
        const bool silent = e.eventful && ((tick >= 500 && tick < 509) || (tick >= 1400 && tick < 1440));
        scene.energyByBody = e.bodies != Bodies::unsaid;
        for (std::size_t i = 0; i < count; ++i) {
            const double t = core::kTickSeconds * tick + 0.3 * static_cast<double>(i);
            // Into the wall and out of it, now and then fast; the first ticks outside.
            const double fast = e.eventful && tick >= 1000 && tick < 1040 ? 60.0 : 0.0;
            const double depth = tick < 30 ? -0.001
                                           : 0.004 * std::sin(9.0 * t) + 0.0004 * std::sin(70.0 * t) +
                                                 0.02 * std::sin(fast * t) * (fast > 0.0 ? 1.0 : 0.0);
            const Vec3 p(0.002 * std::sin(5.0 * t), 0.001 * std::cos(7.0 * t), -depth);
            core::DeviceSample& sample = samples[i];
            core::ToolState pose;
            pose.p_WT = p / e.mapping.scale;
            const std::uint32_t every = std::max<std::uint32_t>(1, e.devices[i].period_us / 1000);
            if (!silent && static_cast<std::uint32_t>(tick) % every == 0) {
                sample.packet += 1;
                sample.deviceTime_us += e.devices[i].period_us;
                sample.counts[0] = static_cast<std::int32_t>(1e6 * p.x());
                sample.buttons = e.eventful && tick >= 1700 && tick < 1720 ? core::kButtonStop
                                 : tick % 700 > 650                        ? core::kButtonDeadMan
                                                                           : 0u;
                sample.status = e.eventful && tick == 2000  ? core::sample_status::kDeviceFault
                                : e.eventful && tick == 320 ? core::sample_status::kInvalid
                                                            : 0u;
                arrived_us[i] = now_us - 300;
                if (e.eventful && tick >= 700 && tick < 702)
                    pose.p_WT.x() += 0.5;
                if (e.eventful && tick >= 1200 && tick < 1205)
                    pose.q_WT.coeffs() *= 1.02;
                if (e.eventful && tick == 330)
                    sample.packet -= 2;
            }
            const haptics::Admission admission = supervisor.admit(
                now, static_cast<int>(i), sample, pose,
                e.devices[i].inProcess ? 0u : static_cast<std::uint32_t>(now_us - arrived_us[i]));
            sums[i].admissions += static_cast<double>(admission) * (1 + tick % kBlock);
            core::ToolState& state = states.tools[i];
            state.v_WT = (p - before[i]) / core::kTickSeconds;
            state.w_WT = Vec3(0.3 * std::sin(4.0 * t), 0.2, 0.0);
            state.p_WT = p;
            before[i] = p;
            const double pressed = std::max(0.0, depth), more = state.v_WT.z() > 0.0 ? 1.0 + e.active : 1.0;
            const Vec3 side = draw.vector(0.02);
            scene.tissue.tools[i] = {
                pressed > 0.0 ? Vec3(Vec3(0.1, 0.05, more) * e.stiffness * pressed + side) : Vec3::Zero(),
                pressed > 0.0 ? Vec3(12.0 * pressed, -8.0 * pressed, 4.0 * pressed) : Vec3::Zero()};
            const double stored = 0.5 * e.stiffness * pressed * pressed;
            scene.storedEnergy_J += stored;
            scene.contactStiffness_N_per_m =
                std::max(scene.contactStiffness_N_per_m, pressed > 0.0 ? e.stiffness : 0.0);
            scene.body[i] = e.bodies == Bodies::each || (e.bodies == Bodies::one && tick % 400 >= 350)
                                ? static_cast<std::uint8_t>(i)
                                : std::uint8_t{0};
            scene.bodyEnergy_J[scene.body[i]] += stored;
            scene.bodyStiffness_N_per_m[scene.body[i]] = e.stiffness;
            scene.damping_Ns_per_m[i] = pressed > 0.0 ? 4.0 : 0.0;
            scene.load_N[i] = tick % 300 > 200 ? 1.2 * e.stiffness * pressed : 0.0;
            scene.display[i] = {more * e.stiffness * pressed, 0.3 * std::sin(3.0 * t),
                                0.2 * std::cos(5.0 * t)};
            in.compensation_W[i] = {Vec3(0.05, -0.02 * std::sin(t), 0.3 * (tick % 250 > 200)),
                                    Vec3(0.002, 0.0, 0.02 * (tick % 250 > 225))};
        }
        if (e.eventful && tick == 900)
            scene.events = core::event_bits::kSceneChanged;
        if (e.eventful && tick == 2200)
            scene.tissue.tools[0].force.x() = std::nan("");
        if (e.eventful && tick == 2300)
            scene.tissue.tools[0].force = {1e200, 0.0, 1e200};
        const auto command = [&](int at, CommandKind first, CommandKind second = CommandKind::none) {
            if (e.eventful && tick == at) {
                in.commands[0].kind = first;
                in.commands[1].kind = second;
            }
        };
        command(250, CommandKind::pause);
        command(290, CommandKind::resume);
        command(340, CommandKind::confirmHold);
        command(450, CommandKind::pause);
        command(620, CommandKind::resume, CommandKind::confirmHold);
        command(750, CommandKind::stopForce);
        command(800, CommandKind::rearm);
        command(1090, CommandKind::rearm);
        command(1250, CommandKind::rearm);
        command(1500, CommandKind::rearm);
        command(1710, CommandKind::rearm);
        command(1730, CommandKind::rearm, CommandKind::confirmHold);
        command(2050, CommandKind::rearm);
        command(2230, CommandKind::rearm, CommandKind::stopForce);
        command(2250, CommandKind::rearm);
        in.heartbeatAge_ms =
            static_cast<std::uint16_t>(e.eventful && tick >= 1850 && tick < 1900 ? 249 + (tick - 1850) : 20);
        supervisor.limit(now, in, out);
        guards |= out.guards;
        guardTicks += static_cast<double>(out.guards) * (1 + tick % kBlock);
        ready += out.forceReady ? 1.0 : 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const haptics::SafeTool& safe = out.tools[i];
            Sums& s = sums[i];
            s.gain += out.gain / kBlock;
            s.enabled += (safe.enabled ? 1.0 : 0.0) + (safe.noMovement ? 1000.0 : 0.0);
            s.force += safe.wrench_W.force / kBlock;
            s.torque += safe.wrench_W.torque / kBlock;
            s.device += safe.wrench_D.force / kBlock + safe.wrench_D.torque;
            s.compensation += safe.compensation_D.force / kBlock + safe.compensation_D.torque;
            s.display +=
                Vec3(safe.display.normalForce_N, safe.display.pitch_rad, safe.display.roll_rad) / kBlock;
            s.display_D +=
                Vec3(safe.display_D.normalForce_N, safe.display_D.pitch_rad, safe.display_D.roll_rad) /
                kBlock;
        }
        if ((tick + 1) % kBlock != 0)
            continue;
        lines.add(QStringLiteral("after %1 ticks: state %2, waits for %3, paused %4, guards %5")
                      .arg(tick + 1)
                      .arg(static_cast<int>(out.force))
                      .arg(static_cast<int>(out.waitsFor))
                      .arg(out.paused)
                      .arg(guards, 0, 16),
                  {guardTicks, ready});
        lines.add(QStringLiteral("  books"),
                  {out.energySupplied_J, out.energyStored_J, out.energyKept_J, out.energyBook_J});
        for (std::size_t i = 0; i < count; ++i) {
            const Sums& s = sums[i];
            lines.add(QStringLiteral("  tool %1").arg(i),
                      {s.gain, s.admissions, s.enabled, s.force.x(), s.force.y(), s.force.z(), s.torque.x(),
                       s.torque.y(), s.torque.z()});
            lines.add(QStringLiteral("    device"),
                      {s.device.x(), s.device.y(), s.device.z(), s.compensation.x(), s.compensation.y(),
                       s.compensation.z()});
            lines.add(QStringLiteral("    display"), {s.display.x(), s.display.y(), s.display.z(),
                                                      s.display_D.x(), s.display_D.y(), s.display_D.z()});
        }
        sums = {};
        guards = 0;
        guardTicks = ready = 0.0;
    }
    return lines.lines();
}

} // namespace

class TestKeptSupervisor : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void episodesAreAsTheyWereKept_data();
    void episodesAreAsTheyWereKept();
    void settingsThatAreRefused();
    void delays();
    void theProbe();
    void durations();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const QStringList& lines) {
        const QString differs = m_kept.differs(name, lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/haptics/kept_supervisor.txt"),
                           &tests::sameNumbers};
};

void TestKeptSupervisor::episodesAreAsTheyWereKept_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Episode& e : episodes())
        QTest::newRow(e.name) << index++;
}

void TestKeptSupervisor::episodesAreAsTheyWereKept() {
    QFETCH(int, index);
    const Episode e = episodes()[static_cast<std::size_t>(index)];
    hold(QString::fromLatin1(e.name), run(e));
}

/// The last value that is taken, and the first that is not; in the words in which it is refused.
void TestKeptSupervisor::settingsThatAreRefused() {
    NumberLines lines;
    const test::CartesianKinematics kinematics;
    const auto say = [&](const QString& what, const haptics::SafetySettings& s,
                         const std::vector<devices::DeviceDescriptor>& devices, double scale = 1.0) {
        std::vector<haptics::SafetyTool> tools;
        for (const devices::DeviceDescriptor& d : devices)
            tools.push_back({d, kinematics, {}});
        for (haptics::SafetyTool& tool : tools)
            tool.mapping.scale = scale;
        haptics::SafetySupervisor supervisor;
        const auto configured = supervisor.configure(s, tools);
        lines.add(what + QStringLiteral(": ") +
                  (configured ? QStringLiteral("taken, budget %1")
                                    .arg(devices.empty() ? 0.0 : supervisor.dampingBudget_Ns_per_m(0))
                              : QString::fromStdString(configured.error().message)));
    };
    using S = haptics::SafetySettings;
    const devices::DeviceDescriptor sound = test::sixAxisDevice();
    double S::*const reals[] = {&S::siteForce_N,
                                &S::siteTorque_Nm,
                                &S::exerciseForce_N,
                                &S::exerciseTorque_Nm,
                                &S::slewForce_N_per_ms,
                                &S::slewTorque_Nm_per_ms,
                                &S::armingForce_N,
                                &S::armingTorque_Nm,
                                &S::stillSpeed_m_per_s,
                                &S::overVelocity_m_per_s,
                                &S::overVelocityDamping_Ns_per_m,
                                &S::quaternionTolerance,
                                &S::jump_m,
                                &S::passivityExcess_J,
                                &S::passivityMinimumSpeed_m_per_s,
                                &S::capKnee};
    for (const auto real : reals)
        for (const double value : {0.0, 1e-9, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
            S s;
            s.*real = value;
            say(QStringLiteral("a number of %1").arg(value), s, {sound});
        }
    std::uint32_t S::*const whole[] = {&S::armingQuiet_ticks, &S::stillTime_ms,     &S::armingRamp_ms,
                                       &S::badPacketsToFault, &S::watchdogRamp_us,  &S::slowestRendering_us,
                                       &S::heartbeatLimit_ms, &S::heartbeatRamp_ms, &S::pauseRamp_ms};
    for (const auto number : whole)
        for (const std::uint32_t value : {0u, 1u, 30'000u, 30'001u, 65'535u, 65'536u}) {
            S s;
            s.*number = value;
            say(QStringLiteral("a count of %1").arg(value), s, {sound});
        }
    for (const double knee : {0.5, 0.51}) {
        S s;
        s.capKnee = knee;
        say(QStringLiteral("a knee of %1").arg(knee), s, {sound});
    }
    say(QStringLiteral("no tool"), {}, {});
    say(QStringLiteral("four tools"), {}, {sound, sound, sound, sound});
    say(QStringLiteral("five tools"), {}, {sound, sound, sound, sound, sound});
    const auto changed = [&](const QString& what, auto change) {
        devices::DeviceDescriptor d = sound;
        change(d);
        say(what, {}, {sound, d});
    };
    changed(QStringLiteral("no axis"), [](auto& d) { d.axes.clear(); });
    changed(QStringLiteral("eight axes"), [](auto& d) { d.axes.resize(8); });
    changed(QStringLiteral("nine axes"), [](auto& d) { d.axes.resize(9); });
    changed(QStringLiteral("no period"), [](auto& d) { d.period_us = 0; });
    for (const double value : {0.0, -0.1, std::nan("")}) {
        changed(QStringLiteral("a rating of %1").arg(value),
                [&](auto& d) { d.axes[1].continuousRating = value; });
        changed(QStringLiteral("a force of %1").arg(value), [&](auto& d) { d.maximumForce_N = value; });
        changed(QStringLiteral("a torque of %1").arg(value), [&](auto& d) { d.maximumTorque_Nm = value; });
        changed(QStringLiteral("a damping of %1").arg(value),
                [&](auto& d) { d.maximumDamping_Ns_per_m = value; });
        say(QStringLiteral("a scale of %1").arg(value), {}, {sound}, value);
    }
    say(QStringLiteral("a scale of 2"), {}, {sound}, 2.0);
    devices::DeviceDescriptor slow = sound;
    for (const std::uint32_t period_us : {4000u, 4001u}) {
        slow.period_us = period_us;
        say(QStringLiteral("a period of %1").arg(period_us), {}, {slow});
    }
    hold(QStringLiteral("settings"), lines.lines());
}

/// A mass on a spring and a damper behind a delay, with counts and noise, as what is found of it says.
void TestKeptSupervisor::delays() {
    NumberLines lines;
    struct Made {
        double delay_s, mass_kg, noise_m, count_m, force_N;
        int bursts;
    };
    for (const Made& m : {Made{0.0, 0.2, 0.0, 0.0, 0.4, 3}, Made{0.0013, 0.1, 2e-5, 0.0, 0.4, 5},
                          Made{0.004, 0.3, 0.0, 1e-5, 0.3, 4}, Made{0.0241, 0.2, 0.0, 0.0, 0.4, 3},
                          Made{0.0252, 0.2, 0.0, 0.0, 0.4, 3}, Made{0.002, 0.2, 1.5e-4, 0.0, 0.2, 4},
                          Made{0.001, 0.2, 0.01, 0.0, 0.4, 4}, Made{0.001, -0.2, 0.0, 0.0, 0.4, 3},
                          Made{0.001, 1e9, 0.0, 1e-6, 0.4, 3}, Made{0.001, 0.2, 0.0, 0.0, 0.0099, 3},
                          Made{0.001, 0.2, 0.0, 0.0, 0.0101, 3}, Made{0.001, 0.2, 0.0, 0.0, 0.4, 2},
                          Made{0.001, 0.2, std::nan(""), 0.0, 0.4, 3}}) {
        Draw draw(5);
        haptics::DelayRecord record;
        record.reserve(m.bursts);
        for (int n = 0; n < m.bursts * haptics::DelayRecord::kWindow_ticks; ++n) {
            double f = 0.0, x = 0.0;
            for (std::size_t i = 0; i < haptics::DelayRecord::kFrequencies_Hz.size(); ++i) {
                const double w = 2.0 * core::kPi * haptics::DelayRecord::kFrequencies_Hz[i];
                const std::complex<double> in =
                    std::polar(m.force_N, w * n * core::kTickSeconds + static_cast<double>(i * i));
                const std::complex<double> stiffness(350.0 - m.mass_kg * w * w, 2.5 * w + 8000.0 / w);
                f += in.real();
                x += (in / stiffness * std::polar(1.0, -w * (m.delay_s + 0.5 * core::kTickSeconds))).real();
            }
            x += m.noise_m * draw.between(-1.7, 1.7);
            record.place(m.count_m > 0.0 ? m.count_m * std::round(x / m.count_m) : x);
            record.force(f, true);
        }
        const auto found = haptics::estimateDelay(record);
        lines.add(QStringLiteral("made"), {m.delay_s, m.mass_kg, m.noise_m, m.count_m, m.force_N});
        if (found)
            lines.add(QStringLiteral("  found"),
                      {std::max(1e-9, found->delay_s), std::max(1e-9, found->standardError_s), found->mass_kg,
                       static_cast<double>(found->bursts)});
        else
            lines.add(QStringLiteral("  ") + QString::fromStdString(found.error().message));
    }
    hold(QStringLiteral("delays"), lines.lines());
}

/// Its force, tick by tick in blocks, and what it and its listener write down.
void TestKeptSupervisor::theProbe() {
    haptics::DelayProbeSettings settings;
    settings.bursts = 3;
    settings.force_N = 0.6;
    settings.axis_W = Vec3(0.6, 0.0, 0.8);
    haptics::DelayRecord record;
    haptics::DelayProbe probe(settings, record);
    haptics::DelayListener listener(settings, record);
    NumberLines lines;
    lines.add(QStringLiteral("ticks"), {static_cast<double>(haptics::DelayProbe::ticksOf(settings))});
    realtime::TickSource source;
    simulation::SceneInput in;
    in.tools.count = 1;
    simulation::SceneOutput out;
    double sum = 0.0, most = 0.0;
    Vec3 forces = Vec3::Zero();
    for (int tick = 0; tick < 4400; ++tick) {
        in.started = tick >= 10;
        in.forceReady = tick >= 20;
        in.paused = tick >= 500 && tick < 540;
        in.tools.tools[0].p_WT = Vec3(1e-5 * tick, 0.0, 2e-5 * tick);
        const std::int64_t now_ns = 1'000'000LL * tick + (tick == 2000   ? 700'000
                                                          : tick == 3000 ? 699'999
                                                                         : 0);
        probe.respond(source.next(now_ns), in, out);
        core::HapticFrame frame;
        frame.tools = 1;
        frame.header.now_ns = now_ns;
        frame.header.guards = tick % 500 == 77 ? core::guard_bits::kPassivity : 0u;
        for (int axis = 0; axis < 3; ++axis)
            frame.tool[0].commanded[static_cast<std::size_t>(axis)] = out.tissue.tools[0].force[axis];
        QVERIFY(listener.tryPush(frame));
        sum += out.tissue.tools[0].force.squaredNorm();
        most = std::max(most, out.tissue.tools[0].force.norm());
        forces += static_cast<double>(1 + tick % 50) * out.tissue.tools[0].force;
        if ((tick + 1) % 50 != 0)
            continue;
        lines.add(QStringLiteral("after %1 ticks: phase %2, tools %3, writing %4")
                      .arg(tick + 1)
                      .arg(static_cast<int>(out.phase))
                      .arg(out.tissue.count)
                      .arg(record.writing),
                  {sum, most, forces.x(), forces.y(), forces.z(), static_cast<double>(record.places),
                   static_cast<double>(record.forces), static_cast<double>(record.damped)});
        sum = most = 0.0;
        forces.setZero();
    }
    double places = 0.0, written = 0.0;
    for (std::size_t i = 0; i < record.places; ++i) {
        places += record.place_m[i] * static_cast<double>(1 + i % 97);
        written += record.force_N[i] * static_cast<double>(1 + i % 89);
    }
    lines.add(QStringLiteral("written"),
              {places, written, static_cast<double>(record.broken[0]), static_cast<double>(record.broken[1]),
               static_cast<double>(record.broken[2])});
    hold(QStringLiteral("probe"), lines.lines());
}

/// Every bucket's edges: the largest value that it answers for, and who is counted up to it.
void TestKeptSupervisor::durations() {
    NumberLines lines;
    haptics::LatencyHistogram all;
    std::int64_t before = -1;
    for (std::int64_t value = 0; value < (1LL << 36); value += std::max<std::int64_t>(1, value / 41)) {
        haptics::LatencyHistogram one;
        one.add(value);
        one.add(INT64_MAX);                             // else the edge is cut to the largest value
        const bool last = one.percentile_us(0.5) > 1e9; // the bucket of all that is longer has no edge
        const std::int64_t edge_ns = last ? -1 : std::llround(1e3 * one.percentile_us(0.5));
        if (!last) {
            QVERIFY(edge_ns >= value && edge_ns >= before);
            QCOMPARE(one.countUpTo(edge_ns), 1u);
            QCOMPARE(one.countUpTo(edge_ns - 1), 0u);
            before = edge_ns;
        }
        lines.add(QString::number(value), {static_cast<double>(edge_ns)});
        all.add(value);
    }
    for (const double share : {0.0, 0.01, 0.5, 0.9, 0.999, 1.0})
        lines.add(QStringLiteral("share"), {share, all.percentile_us(share)});
    for (const std::int64_t limit_ns : {0LL, 31LL, 32LL, 1'000LL, 100'000LL, 1'000'000LL, 34'359'738'367LL,
                                        34'359'738'368LL, 60'000'000'000LL})
        lines.add(QStringLiteral("up to"),
                  {static_cast<double>(limit_ns), static_cast<double>(all.countUpTo(limit_ns))});
    hold(QStringLiteral("durations"), lines.lines());
}

QTEST_APPLESS_MAIN(TestKeptSupervisor)
#include "test_kept_supervisor.moc"
