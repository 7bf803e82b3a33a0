// SPDX-License-Identifier: GPL-3.0-or-later
// What every simulated mechanism does under a fixed programme of efforts and hands, and what is found of it
// by its own sensors, against what was looked at and kept: laws and limits have tests of their own; here a
// term, a default or a step that nobody thought of cannot change unsaid. A change that is meant is kept anew,
// and its difference is read in review: CHIRON_STORE_OUTLINES=1 ctest --test-dir build/release -R
// "^test_kept_mechanisms$"
#include "core/fp_environment.h"
#include "core/units.h"
#include "mechanisms/fingertip_arm_plant.h"
#include "mechanisms/fingertip_arm_verification.h"
#include "mechanisms/fingertip_pad_identification.h"
#include "mechanisms/fingertip_platform.h"
#include "mechanisms/fingertip_verification.h"
#include "mechanisms/five_bar_plant.h"
#include "mechanisms/friction_identification.h"
#include "mechanisms/gimbal_plant.h"
#include "mechanisms/hand.h"
#include "mechanisms/jaw.h"
#include "mechanisms/rotation_vector.h"
#include "mechanisms/wrist.h"
#include "support/kept_numbers.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::mechanisms;
using core::Vec3;
using tests::NumberLines;

namespace {

constexpr int kTicks = 1600, kBlock = 200;
constexpr double kTick = core::kTickSeconds;

/// Efforts of a motor programme that takes every axis both ways, for a while beyond what its motor gives, and
/// off in between.
AxisEfforts effortsAt(int tick, const AxisEfforts& scale) {
    AxisEfforts efforts{};
    const double more = tick >= 700 && tick < 900 ? 4.0 : 1.0;
    for (std::size_t axis = 0; axis < efforts.size(); ++axis)
        efforts[axis] = more * scale[axis] *
                        std::sin((5.0 + 1.3 * static_cast<double>(axis)) * kTick * tick +
                                 0.4 * static_cast<double>(axis));
    return efforts;
}
bool enabledAt(int tick) {
    return tick < 1000 || tick >= 1150;
}

core::Wrench handAt(int tick, double force_N, double torque_Nm) {
    const double t = kTick * tick;
    return {force_N * Vec3(std::sin(3.0 * t), std::cos(2.0 * t), -0.6 + 0.5 * std::sin(4.0 * t)),
            torque_Nm * Vec3(std::cos(3.0 * t), std::sin(2.5 * t), 0.7 * std::sin(4.0 * t))};
}

/// What a plant's host and its hand notice, block after block.
template <class Mechanism, class Say>
QStringList trace(Mechanism& plant, const AxisEfforts& scale, double force_N, double torque_Nm, Say say) {
    NumberLines lines;
    std::vector<double> counts(plant.encoderCounts().size());
    core::Wrench measured;
    int saturated = 0;
    for (int tick = 0; tick < kTicks; ++tick) {
        plant.beginTick(effortsAt(tick, scale), enabledAt(tick));
        for (int step = 0; step < plant.substeps(); ++step)
            plant.step(kTick / plant.substeps(), handAt(tick, force_N, torque_Nm));
        plant.endTick();
        for (std::size_t axis = 0; axis < counts.size(); ++axis)
            counts[axis] += plant.encoderCounts()[axis] / static_cast<double>(kBlock);
        measured.force += plant.measured_D().force / kBlock;
        measured.torque += plant.measured_D().torque / kBlock;
        saturated += plant.saturated() ? 1 : 0;
        if ((tick + 1) % kBlock != 0)
            continue;
        const ToolMotion m = plant.motion();
        lines.add(QStringLiteral("after %1 ticks").arg(tick + 1));
        lines.add(QStringLiteral("  place"),
                  {m.p_DT.x(), m.p_DT.y(), m.p_DT.z(), m.v_DT.x(), m.v_DT.y(), m.v_DT.z()});
        lines.add(QStringLiteral("  attitude"),
                  {m.q_DT.w(), m.q_DT.x(), m.q_DT.y(), m.q_DT.z(), m.w_DT.x(), m.w_DT.y(), m.w_DT.z()});
        lines.add(QStringLiteral("  counts"), counts);
        lines.add(QStringLiteral("  measured"),
                  {measured.force.x(), measured.force.y(), measured.force.z(), measured.torque.x(),
                   measured.torque.y(), measured.torque.z()});
        lines.add(QStringLiteral("  saturated, energy"), {static_cast<double>(saturated), plant.energy_J()});
        say(lines);
        std::fill(counts.begin(), counts.end(), 0.0);
        measured = {};
        saturated = 0;
    }
    return lines.lines();
}

/// What rubs and is read in counts, for seconds: another library's last digit shows as another count, and
/// that in the second digit of a figure. Processors of one class have the same (core/fp_environment.h), so
/// there nothing may differ.
bool sameFigures(const QString& was, const QString& is) {
    static const bool sameClass =
        QString::fromStdString(core::cpuClass()).startsWith(QLatin1String("x86-64+fma+avx2"));
    if (sameClass || tests::sameNumbers(was, is))
        return tests::sameNumbers(was, is);
    const QStringList a = was.split(QLatin1Char(' ')), b = is.split(QLatin1Char(' '));
    bool same = a.size() == b.size();
    for (qsizetype i = 0; same && i < a.size(); ++i) {
        bool first = false, second = false;
        const double x = a[i].toDouble(&first), y = b[i].toDouble(&second);
        same = first && second ? std::abs(x - y) <= 0.05 * std::max(std::abs(x), std::abs(y)) + 0.02
                               : a[i] == b[i];
    }
    return same;
}

QString words(const core::Error& error) {
    return QString::fromStdString(error.message);
}

void addPad(NumberLines& lines, const QString& name, const FingerPadParameters& p) {
    lines.add(name, {p.radius_m, p.stiffness_N_per_m, p.hardening_per_m, p.damping_Ns_per_m, p.surface_m,
                     p.relaxation, p.relaxationTimes_s[0], p.relaxationTimes_s[1]});
}

QStringList figures(const FingertipVerification& v) {
    NumberLines lines;
    addPad(lines, QStringLiteral("finger"), v.pad);
    addPad(lines, QStringLiteral("identified"), v.identified);
    lines.add(QStringLiteral("rmse"), v.rmse_N);
    lines.add(QStringLiteral("true rmse"), v.rmseTrue_N);
    lines.add(QStringLiteral("means, gain, phase"), {v.meanRmse_N, v.meanRmseTrue_N, v.gain, v.phase_deg});
    lines.add(QStringLiteral("angles"),
              {v.meanError_deg, v.sdError_deg, v.meanErrorTrue_deg, v.sdErrorTrue_deg});
    lines.add(QStringLiteral("steps"), {v.overshoot, v.overshootOfForce, v.staticError, v.oneNewton_N});
    lines.add(QStringLiteral("most, latency"), {v.largest_N, v.latency_s});
    lines.add(QStringLiteral("holds"), {v.holds() ? 1.0 : 0.0});
    for (std::size_t i = 0; i < v.series.time_s.size(); i += 397)
        lines.add(QStringLiteral("at"), {v.series.time_s[i], v.series.reference_N[i], v.series.measured_N[i],
                                         v.series.true_N[i], v.series.height_m[i]});
    for (const FingertipPosed& p : v.poses)
        lines.add(QStringLiteral("pose"), {p.referencePitch_rad, p.referenceRoll_rad, p.measuredPitch_rad,
                                           p.measuredRoll_rad, p.truePitch_rad, p.trueRoll_rad});
    return lines.lines();
}

} // namespace

class TestKeptMechanisms : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void gimbal_data();
    void gimbal();
    void fiveBar_data();
    void fiveBar();
    void arm();
    void platform_data();
    void platform();
    void handsAndJaws();
    void whatIsFoundOfTheGimbal();
    void whatIsFoundOfFingers();
    void whatIsFoundOfThePlatform();
    void whatIsFoundOfTheArm();
    void settingsThatAreRefused();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen() + m_figures.unseen(), QStringList()); }

private:
    void hold(const QString& name, const QStringList& lines) { hold(m_kept, name, lines); }
    static void hold(tests::KeptText& kept, const QString& name, const QStringList& lines) {
        const QString differs = kept.differs(name, lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_figures{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/mechanisms/kept_figures.txt"),
                              &sameFigures};
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/mechanisms/kept_mechanisms.txt"),
                           &tests::sameNumbers};
};

void TestKeptMechanisms::gimbal_data() {
    QTest::addColumn<int>("delay_ticks");
    QTest::addColumn<bool>("feedForward");
    QTest::newRow("gimbal") << 0 << true;
    QTest::newRow("gimbal, late and without feed-forward") << 2 << false;
}

void TestKeptMechanisms::gimbal() {
    QFETCH(int, delay_ticks);
    QFETCH(bool, feedForward);
    GimbalPlantParameters p;
    p.sampleDelay_ticks = delay_ticks;
    p.gravityFeedForward = feedForward;
    GimbalPlant plant(p);
    plant.reset({0.15, -0.1, 0.3, 0.2});
    hold(QString::fromLatin1(QTest::currentDataTag()),
         trace(plant, {0.25, -0.3, 0.0, 1.2}, 0.5, 0.0, [&](NumberLines& lines) {
             lines.add(QStringLiteral("  joints"), {plant.q().h, plant.q().p, plant.q().r, plant.q().d});
             lines.addMatrix(QStringLiteral("  rates"), plant.rates());
             lines.addMatrix(QStringLiteral("  inertia"), plant.inertia(plant.q()));
             lines.addMatrix(QStringLiteral("  gravity"), plant.gravity(plant.q()));
             lines.addMatrix(QStringLiteral("  jacobian"), plant.kinematics().jacobian_D(plant.q()));
         }));
}

void TestKeptMechanisms::fiveBar_data() {
    gimbal_data();
}

void TestKeptMechanisms::fiveBar() {
    QFETCH(int, delay_ticks);
    QFETCH(bool, feedForward);
    FiveBarPlantParameters p;
    p.sampleDelay_ticks = delay_ticks;
    p.gravityFeedForward = feedForward;
    FiveBarPlant plant(p);
    FiveBarVector q;
    const auto theta = FiveBarKinematics(p.geometry).inverse({0.0, -0.03, 0.05});
    QVERIFY(theta);
    q << (*theta)[0], (*theta)[1], 0.2, -0.1, 0.4;
    plant.reset(q);
    hold(m_figures,
         QString::fromLatin1(QTest::currentDataTag())
             .replace(QStringLiteral("gimbal"), QStringLiteral("five-bar linkage")),
         trace(plant, {0.3, -0.25, 0.06, 0.05, 0.004}, 1.0, 0.012, [&](NumberLines& lines) {
             lines.addMatrix(QStringLiteral("  joints"), plant.q());
             lines.addMatrix(QStringLiteral("  rates"), plant.rates());
             lines.addMatrix(QStringLiteral("  motors"), plant.motorAngles());
             lines.addMatrix(QStringLiteral("  inertia"), plant.dynamics().inertia());
             lines.addMatrix(QStringLiteral("  bias"), plant.dynamics().bias(plant.rates()));
             lines.addMatrix(QStringLiteral("  gravity"), plant.dynamics().gravity());
             lines.add(QStringLiteral("  potential, condition"),
                       {plant.dynamics().potential_J(),
                        FiveBarKinematics::conditionNumber(plant.dynamics().loop())});
         }));
}

void TestKeptMechanisms::arm() {
    FingertipArmPlant plant({}, 5);
    plant.reset({0.03, -0.05, 0.08});
    plant.holdLever(0.7);
    hold(QStringLiteral("arm"), trace(plant, {}, 0.25, 0.004, [&](NumberLines& lines) {
             lines.addMatrix(QStringLiteral("  joints"), plant.q());
             lines.addMatrix(QStringLiteral("  rates"), plant.rates());
             lines.add(QStringLiteral("  grasp, mass, inertia"),
                       {static_cast<double>(plant.jawCounts()), plant.apparentMass_kg(),
                        plant.apparentInertia_kgm2()});
             lines.addMatrix(QStringLiteral("  attitude sensor"), plant.imu().attitude().coeffs());
             lines.addMatrix(QStringLiteral("  rate"), plant.imu().rate_T());
             lines.addMatrix(QStringLiteral("  acceleration"), plant.imu().acceleration_T());
         }));
}

void TestKeptMechanisms::platform_data() {
    QTest::addColumn<double>("relaxation");
    QTest::addColumn<double>("stiffness");
    QTest::newRow("platform") << 0.0 << 1.0;
    QTest::newRow("platform, a soft finger that relaxes") << 0.3 << 0.6;
}

/// Up, down, leaning, beyond the limit, off, on a finger that moves.
void TestKeptMechanisms::platform() {
    QFETCH(double, relaxation);
    QFETCH(double, stiffness);
    FingertipPlatformParameters p;
    p.pad.relaxation = relaxation;
    p.pad.stiffness_N_per_m *= stiffness;
    FingertipPlatform platform(p, 8);
    NumberLines lines;
    for (int tick = 0; tick < 2400; ++tick) {
        const double t = kTick * tick;
        const core::DisplayPose wanted{tick < 1500 ? 1.5 - 1.5 * std::cos(4.0 * t) : 6.0,
                                       0.4 * std::sin(3.0 * t), 0.5 * std::sin(2.0 * t)};
        platform.shiftFinger(1e-4 * std::sin(5.0 * t));
        platform.tick(wanted, tick < 1800 || tick >= 1950);
        if ((tick + 1) % 150 != 0)
            continue;
        const core::DisplayPose& is = platform.truth();
        lines.add(QStringLiteral("after %1 ticks").arg(tick + 1));
        lines.add(QStringLiteral("  on the pad"), {is.normalForce_N, is.pitch_rad, is.roll_rad});
        lines.add(QStringLiteral("  sensed"), {platform.sensedForce_N(), platform.sensedPitch_rad(),
                                               platform.sensedRoll_rad(), platform.saturated() ? 1.0 : 0.0});
        lines.add(QStringLiteral("  plant"), {platform.plant().pose().z_m, platform.plant().pose().pitch_rad,
                                              platform.plant().pose().roll_rad, platform.plant().energy_J()});
        lines.addMatrix(QStringLiteral("  motors"), platform.plant().motors());
        lines.addMatrix(QStringLiteral("  place on the plate"), platform.plant().padPlace());
        const auto& counts = platform.forceSensors().counts();
        lines.add(QStringLiteral("  counts"), {static_cast<double>(counts[0]), static_cast<double>(counts[1]),
                                               static_cast<double>(counts[2])});
    }
    for (const double load_N : {0.0, 0.5, 1.0, 3.0})
        lines.add(QStringLiteral("newtons a count"), {load_N, platform.forceSensors().resolution_N(load_N)});
    hold(QString::fromLatin1(QTest::currentDataTag()), lines.lines());
}

void TestKeptMechanisms::handsAndJaws() {
    const std::pair<const char*, HandParameters> hands[] = {
        {"usual", {}}, {"light", HandParameters::light()}, {"firm", HandParameters::firm()}};
    for (const auto& [name, parameters] : hands) {
        Hand hand(parameters, 3, 0.12);
        Wrist wrist(parameters, 4, 0.001);
        Jaw jaw({}, 1);
        hand.reset({0.01, -0.02, 0.05}, turned(core::Quat::Identity(), {0.1, 0.0, 0.0}));
        wrist.reset(turned(core::Quat::Identity(), {0.1, 0.0, 0.0}));
        jaw.reset();
        NumberLines lines;
        Vec3 tool(0.01, -0.02, 0.05); // follows half of the way each tick: any tool will do
        for (int tick = 0; tick < 900; ++tick) {
            const double t = kTick * tick;
            HandIntention wanted;
            wanted.p_DDesired = {0.01 + 0.02 * std::sin(4.0 * t), -0.02, 0.05 - 0.01 * t};
            wanted.v_DDesired = {0.08 * std::cos(4.0 * t), 0.0, -0.01};
            wanted.q_DDesired =
                turned(core::Quat::Identity(), {0.1 + 0.3 * std::sin(3.0 * t), 0.2 * t, -0.1});
            wanted.w_DDesired = {0.9 * std::cos(3.0 * t), 0.2, 0.0};
            wanted.buttons = tick > 300 ? 1u : 0u;
            wanted.jaw_rad = 1.0 + std::sin(5.0 * t);
            hand.beginTick(wanted);
            wrist.beginTick(hand.acting());
            jaw.advance(hand.acting().jaw_rad);
            const Vec3 grip = hand.gripForceOnTool(tool, {0.01, 0.0, 0.0});
            const Vec3 turn =
                wrist.gripTorqueOnTool(turned(core::Quat::Identity(), {0.05, 0.05, 0.0}), {0.0, 0.1, 0.0});
            for (int step = 0; step < 4; ++step) {
                hand.integrate(0.25 * kTick, 0.2 * grip);
                wrist.integrate(0.25 * kTick, 0.1 * turn);
            }
            tool += 0.5 * (hand.p_D() - tool);
            if ((tick + 1) % 100 != 0)
                continue;
            lines.add(QStringLiteral("after %1 ticks").arg(tick + 1),
                      {static_cast<double>(hand.acting().buttons), hand.acting().jaw_rad, jaw.angle_rad(),
                       static_cast<double>(jaw.counts())});
            lines.addMatrix(QStringLiteral("  hand"), hand.p_D());
            lines.addMatrix(QStringLiteral("  speed"), hand.v_D());
            lines.addMatrix(QStringLiteral("  grip"), grip);
            lines.addMatrix(QStringLiteral("  wrist"), wrist.q_D().coeffs());
            lines.addMatrix(QStringLiteral("  turns"), wrist.w_D());
            lines.addMatrix(QStringLiteral("  torque"), turn);
        }
        hold(QStringLiteral("hand, %1").arg(QLatin1String(name)), lines.lines());
    }
}

void TestKeptMechanisms::whatIsFoundOfTheGimbal() {
    NumberLines lines;
    const std::pair<GimbalCoordinates, FrictionSweep> sweeps[] = {
        {{0.0, 0.0, 0.0, 0.18}, {}},
        {{0.2, -0.1, 0.0, 0.22}, {.slow = 0.04, .fast = 0.2, .halfTravel = 0.06, .settled = 0.5}}};
    for (const auto& [middle, sweep] : sweeps) {
        GimbalPlant plant{GimbalPlantParameters{}};
        const auto found = identifyFriction(plant, middle, sweep);
        QVERIFY2(found, found ? "" : found.error().message.c_str());
        for (std::size_t axis = 0; axis < 4; ++axis)
            if (const auto& friction = (*found)[axis])
                lines.add(QStringLiteral("axis %1").arg(axis), {friction->coulomb, friction->viscous});
    }
    hold(QStringLiteral("friction of the gimbal"), lines.lines());
}

void TestKeptMechanisms::whatIsFoundOfFingers() {
    NumberLines lines;
    addPad(lines, QStringLiteral("soft"), FingerPadParameters::soft());
    addPad(lines, QStringLiteral("stiff"), FingerPadParameters::stiff());
    for (const FingertipFinger& finger : otherFingers({})) {
        addPad(lines, QString::fromStdString(finger.finger), finger.pad);
        FingertipPlatformParameters p;
        p.pad = finger.pad;
        const auto found = worn(p, 6);
        QVERIFY2(found, found ? "" : found.error().message.c_str());
        addPad(lines, QStringLiteral("  found"), found->control.pad);
    }
    FingertipPlatformParameters none;
    none.pad.surface_m = 0.02;
    const auto nobody = identifyPad(none, 6);
    FingertipPlatformParameters weak;
    weak.drive.forceLimit_N = 0.5;
    const auto weakly = identifyPad(weak, 6);
    QVERIFY(!nobody && !weakly);
    lines.add(words(nobody.error()));
    lines.add(words(weakly.error()));

    // Readings that are given: how many are expected, which count, and that they have to rise.
    const FingerPadParameters nominal;
    const FingerPad pad(nominal);
    const auto readings = [&](int count, double sign) {
        std::vector<PadReading> made;
        for (int i = 0; i < count; ++i)
            made.push_back({1e-3 + sign * pad.depthOf(0.05 + 0.02 * i), 0.05 + 0.02 * i});
        return made;
    };
    for (const int count : {19, 20}) {
        const auto fitted = fitPad(readings(count, 1.0), 2.0, nominal);
        lines.add(QStringLiteral("%1 readings: ").arg(count) + (fitted ? QString() : words(fitted.error())));
        if (fitted)
            addPad(lines, QStringLiteral("  fitted"), *fitted);
    }
    const auto falling = fitPad(readings(40, -1.0), 2.0, nominal);
    lines.add(QStringLiteral("falling: ") + (falling ? QString() : words(falling.error())));
    auto disturbed = readings(60, 1.0);
    disturbed.push_back({1e-3, 0.0499999}); // noise
    disturbed.push_back({5e-3, 0.9000001}); // beyond what is looked at
    disturbed.push_back({std::nan(""), 0.5});
    const auto fitted = fitPad(disturbed, 0.9, nominal);
    QVERIFY(fitted);
    addPad(lines, QStringLiteral("disturbed"), *fitted);
    hold(QStringLiteral("fingers as they are found"), lines.lines());
}

void TestKeptMechanisms::whatIsFoundOfThePlatform() {
    FingertipVerificationSettings s;
    s.poses = 4;
    s.frequency_Hz = 0.8;
    s.peak_N = 1.2;
    s.settle_s = 0.4;
    const auto v = verifyFingertip({}, 12, s);
    QVERIFY(v);
    hold(m_figures, QStringLiteral("platform, verified"), figures(*v));
    s.feedback = false;
    s.fingerMoves_m = 0.0003;
    s.poses = 1;
    const auto cut = verifyFingertip({}, 13, s);
    QVERIFY(cut);
    hold(m_figures, QStringLiteral("platform without its force loop"), figures(*cut));
    s.feedback = true;
    s.frequency_Hz = 5.0;
    s.settle_s = 0.1;
    const auto worse = degradeFingertip({}, 14, s);
    QVERIFY2(worse, worse ? "" : worse.error().message.c_str());
    NumberLines lines;
    for (const FingertipDegradation& d : *worse)
        lines.add(QString::fromStdString(d.what), {d.factor, d.rmse_N, d.rmseTrue_N, d.meanError_deg,
                                                   d.meanErrorTrue_deg, d.largest_N, d.holds ? 1.0 : 0.0});
    for (const double factor : {1.0, 3.0}) {
        FingertipPlatformParameters p;
        p.drive.friction.coulomb *= factor;
        const FingertipFriction friction = identifyFingertipFriction(p);
        lines.add(QStringLiteral("friction"),
                  {friction.coulomb_N, friction.viscous_Ns_per_m, fingertipDamping_Ns_per_m(friction, p)});
    }
    hold(m_figures, QStringLiteral("platform, degraded"), lines.lines());
}

void TestKeptMechanisms::whatIsFoundOfTheArm() {
    FingertipArmVerificationSettings s;
    s.grid = 3;
    s.speeds_m_per_s = {0.1};
    const auto v = verifyFingertipArm({}, 21, s).value();
    NumberLines lines;
    lines.add(QStringLiteral("poses"),
              {static_cast<double>(v.poses), static_cast<double>(v.reached), v.holds() ? 1.0 : 0.0});
    lines.add(QStringLiteral("condition, weight, sinks"), {v.condition, v.weight_N, v.sinks_m});
    lines.add(QStringLiteral("mass"), {v.massLeast_kg, v.massMost_kg});
    lines.add(QStringLiteral("encoders"),
              {static_cast<double>(v.encoderBits), v.countLeast_m, v.countMost_m, v.place_m});
    for (const FingertipArmDrag& drag : v.drags)
        lines.add(QStringLiteral("drag"),
                  {static_cast<double>(drag.axis), drag.speed_m_per_s, drag.felt_N, drag.given_N});
    lines.add(QStringLiteral("friction error"), {v.frictionError()});
    QVERIFY(v.inverse_m < 1e-14 && v.inverse_rad < 1e-14 && v.jacobian < 1e-8 &&
            v.gravity_Nm < 1e-8); // rounding alone

    // Where a pad cannot be, and what its joints would have to be.
    const std::pair<const char*, Vec3> places[] = {{"middle", {0.0, 0.0, 0.05}},
                                                   {"far", {0.5, -0.5, 0.3}},
                                                   {"near", {0.0, 0.30, 0.20}},
                                                   {"over the shoulder", {0.0, 0.34, 0.4}},
                                                   {"not a number", {std::nan(""), 0.0, 0.0}},
                                                   {"beside", {0.4, 0.2, 0.1}},
                                                   {"behind", {0.0, 0.6, 0.1}}};
    for (const auto& [name, place] : places)
        for (const Vec3& turn :
             {Vec3(0.0, 0.0, 0.0), Vec3(0.3, 1.0, -0.4), Vec3(0.0, 0.5 * core::kPi, 0.0)}) {
            const ArmPosture posture =
                fingertipArmPosture({}, place, turned(core::Quat::Identity(), turn), 0.3);
            lines.add(QStringLiteral("%1: %2, joint %3")
                          .arg(QLatin1String(name), QLatin1String(wordsFor(posture.reach)))
                          .arg(posture.joint));
            if (posture.reach == ArmReach::reached || posture.reach == ArmReach::beyondTravel)
                lines.addMatrix(QStringLiteral("  joints"), posture.q);
        }
    hold(QStringLiteral("arm, verified"), lines.lines());
}

/// The last value that is taken, and the first that is not; in the words in which it is refused.
void TestKeptMechanisms::settingsThatAreRefused() {
    NumberLines lines;
    const auto friction = [&](const QString& name, const FrictionSweep& sweep,
                              const GimbalCoordinates& middle = {0.0, 0.0, 0.0, 0.18}) {
        GimbalPlant plant{GimbalPlantParameters{}};
        const auto found = identifyFriction(plant, middle, sweep);
        lines.add(name + QStringLiteral(": ") + (found ? QStringLiteral("taken") : words(found.error())));
    };
    friction(QStringLiteral("slow 0"), {.slow = 0.0});
    friction(QStringLiteral("fast as slow"), {.slow = 0.1, .fast = 0.1});
    friction(QStringLiteral("fast 1, a small travel"), {.slow = 0.9, .fast = 1.0, .halfTravel = 0.05});
    friction(QStringLiteral("fast above 1"), {.slow = 0.9, .fast = 1.001, .halfTravel = 0.05});
    friction(QStringLiteral("travel 0"), {.halfTravel = 0.0});
    friction(QStringLiteral("settled 0"), {.slow = 0.5, .fast = 0.9, .halfTravel = 0.05, .settled = 0.0});
    friction(QStringLiteral("settled 0.9"), {.slow = 0.5, .fast = 0.9, .halfTravel = 0.05, .settled = 0.9});
    friction(QStringLiteral("settled below 0"), {.settled = -0.01});
    friction(QStringLiteral("settled above 0.9"), {.settled = 0.91});
    const FrictionSweep quick{.slow = 0.5, .fast = 0.9, .halfTravel = 0.05};
    const GimbalPlantParameters p;
    for (const double beyond : {-0.001, 0.001}) {
        friction(QStringLiteral("heading to %1 beyond its end").arg(beyond), quick,
                 {p.maximum[0] - 0.05 + beyond, 0.0, 0.0, 0.18});
        friction(QStringLiteral("pitch to %1 beyond its end").arg(beyond), quick,
                 {0.0, p.minimum[1] + 0.05 - beyond, 0.0, 0.18});
        friction(QStringLiteral("depth to %1 beyond its end").arg(beyond), quick,
                 {0.0, 0.0, 0.0, p.maximum[3] - 0.01 + beyond});
        friction(QStringLiteral("depth to %1 before its start").arg(beyond), quick,
                 {0.0, 0.0, 0.0, p.minimum[3] + 0.01 - beyond});
    }
    const auto platform = [&](const QString& name, auto change) {
        FingertipVerificationSettings s;
        s.frequency_Hz = 5.0;
        s.poses = 1;
        s.settle_s = 0.1;
        change(s);
        const auto found = verifyFingertip({}, 1, s);
        lines.add(name + QStringLiteral(": ") + (found ? QStringLiteral("taken") : words(found.error())));
    };
    for (const double x : {0.0499, 5.0, 5.001})
        platform(QStringLiteral("frequency %1").arg(x), [x](auto& s) { s.frequency_Hz = x; });
    for (const double x : {0.0, 4.0, 4.001})
        platform(QStringLiteral("peak %1").arg(x), [x](auto& s) { s.peak_N = x; });
    for (const int x : {0, 10001})
        platform(QStringLiteral("poses %1").arg(x), [x](auto& s) { s.poses = x; });
    for (const double x : {0.0999, 5.0, 5.001})
        platform(QStringLiteral("settled in %1").arg(x), [x](auto& s) { s.settle_s = x; });
    for (const double x : {-1e-6, 0.0, 0.001, 0.001001})
        platform(QStringLiteral("the finger moves by %1").arg(x), [x](auto& s) { s.fingerMoves_m = x; });
    hold(QStringLiteral("settings"), lines.lines());
}

QTEST_APPLESS_MAIN(TestKeptMechanisms)
#include "test_kept_mechanisms.moc"
