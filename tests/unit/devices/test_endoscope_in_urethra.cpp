// SPDX-License-Identifier: GPL-3.0-or-later
// P1's mechanism, hand, supervisor and the urethra's forces as one loop: a hand that knows the way goes in
// and out.
#include "core/units.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_scene.h"
#include "support/haptic_bench.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::tests;
using core::Vec3;

namespace {

constexpr double kWait_s = 3.0; // until the force has come up
constexpr double kIn_s = 17.0;  // for the way in, and as long out
constexpr double kHold_s = 3.0; // at the neck
constexpr double kDepth_m = 0.177;

/// Follows the centre-line, endoscope along it, from 25 mm before the entrance to 10 mm beyond the bladder
/// neck and back.
class Guide final : public mechanisms::HandStrategy {
public:
    explicit Guide(double aside_m, double tilt_rad = 0.0) : m_aside_m(aside_m), m_tilt_rad(tilt_rad) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        const double t = seen.time_s - kWait_s;
        const double share = t < kIn_s             ? t / kIn_s
                             : t < kIn_s + kHold_s ? 1.0
                                                   : 1.0 - (t - kIn_s - kHold_s) / kIn_s;
        const double s = -0.025 + kDepth_m * std::clamp(share, 0.0, 1.0);
        const simulation::CentrelinePoint at = m_line.at(s);
        const double astray = std::clamp((s - 0.05) / 0.02, 0.0, 1.0);
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = m_pose.pointToW(at.p_A + astray * m_aside_m * at.n_A); // D is W
        wanted.q_DDesired = mechanisms::SphericalJoint({at.psi_rad + astray * m_tilt_rad,
                                                        -0.5 * astray * m_tilt_rad, 0.3 * std::sin(0.5 * t)})
                                .orientation_DT();
        return wanted;
    }

private:
    simulation::AnatomyPose m_pose;
    simulation::UrethraCentreline m_line{13.0, 0.0877};
    double m_aside_m;
    double m_tilt_rad;
};

struct Run {
    FrameStore store{45'000};
    simulation::ProcedureStage farthest = simulation::ProcedureStage::outside;
    double deepest_m = -1.0;
    bool over = false;
};

void play(Run& run, double aside_m, double tilt_rad, const mechanisms::HandParameters& arm) {
    devices::SimulatedEndoscopeDevice::Configuration configuration;
    configuration.hand = arm;
    const auto device = std::move(*devices::SimulatedEndoscopeDevice::create(
        configuration, std::make_unique<Guide>(aside_m, tilt_rad)));
    QVERIFY(device->open().has_value());
    auto scene =
        std::make_unique<simulation::UrethraInsertionScene>(simulation::UrethraInsertionParameters{});
    const simulation::UrethraInsertionScene& procedure = *scene;
    haptics::LiveInputs inputs;
    LoopBench bench({{*device, {}}}, inputs, run.store, std::move(scene));
    realtime::TickSource ticks;
    inputs.post({core::CommandKind::start});
    const int last = static_cast<int>(1000.0 * (kWait_s + 2.0 * kIn_s + kHold_s)) + 2000;
    for (int n = 0; n < last && !run.over; ++n) {
        inputs.beat(static_cast<std::int64_t>(n) * 1'000'000);
        run.over = !bench.loop->tick(ticks.next(static_cast<std::int64_t>(n) * 1'000'000));
        run.farthest = std::max(run.farthest, procedure.procedure().stage());
        run.deepest_m = std::max(run.deepest_m, procedure.response().foot.at.s_m);
    }
}

} // namespace

class TestEndoscopeInUrethra : public QObject {
    Q_OBJECT
private slots:
    void goesInAndOut_data() {
        QTest::addColumn<QString>("arm");
        QTest::addColumn<double>("aside_mm");
        QTest::addColumn<double>("tilt_deg");
        QTest::newRow("default, along the middle") << "default" << 0.0 << 0.0;
        for (const char* each : {"default", "light", "firm"})
            QTest::addRow("%s, 3 mm aside and tilted by 20 degrees", each) << each << 3.0 << 20.0;
    }

    void goesInAndOut() {
        QFETCH(QString, arm);
        QFETCH(double, aside_mm);
        QFETCH(double, tilt_deg);
        mechanisms::HandParameters hand = arm == "light"  ? mechanisms::HandParameters::light()
                                          : arm == "firm" ? mechanisms::HandParameters::firm()
                                                          : mechanisms::HandParameters{};
        hand.tremorRms_m = hand.wristTremorRms_rad = 0.0;
        Run run;
        play(run, 1e-3 * aside_mm, core::radFromDeg(tilt_deg), hand);
        const devices::FiveBarSphericalKinematics kinematics = *devices::FiveBarSphericalKinematics::create(
            (*devices::SimulatedEndoscopeDevice::create({}, std::make_unique<Guide>(0.0)))->descriptor());
        double strongest = 0.0, hardest = 0.0, jump = 0.0;
        Vec3 low = Vec3::Constant(9.0), high = Vec3::Constant(-9.0), before = Vec3::Zero();
        for (std::size_t n = 0; n < run.store.frames.size(); ++n) {
            const core::ToolFrame& frame = run.store.frames[n].tool[0];
            const core::Wrench wrench = core::toWrench(frame.commanded);
            core::DeviceSample sample;
            sample.counts = frame.counts;
            const auto efforts = kinematics.efforts(sample, wrench);
            QVERIFY2(std::abs(efforts[4]) <= 0.010 && wrench.torque.norm() <= 0.150 + 1e-12, "P1's torques");
            strongest = std::max(strongest, wrench.force.norm());
            hardest = std::max(hardest, wrench.torque.norm());
            jump = std::max(jump, (wrench.force - before).norm());
            before = wrench.force;
            const double held = 1e-3 * static_cast<double>(n) - kWait_s - kIn_s;
            if (held > kHold_s - 1.0 && held < kHold_s) {
                low = low.cwiseMin(wrench.force);
                high = high.cwiseMax(wrench.force);
            }
        }
        qInfo("deepest %.1f mm, at most %.2f N and %.0f mN.m, steps %.3f N, at rest within %.3f N",
              1e3 * run.deepest_m, strongest, 1e3 * hardest, jump, (high - low).maxCoeff());
        QVERIFY(run.farthest >= simulation::ProcedureStage::withdrawal);
        QVERIFY(run.deepest_m > 0.149);
        QVERIFY(strongest > 0.2 && strongest < 4.0);
        QVERIFY(tilt_deg == 0.0 || hardest > 0.030);
        QVERIFY(jump < 0.4);
        // A count of each base axis in the estimator's window, either way, at b_max: 4 · 22 µm / 15 ms · 50
        // N·s/m = 0.29 N. Nothing swings.
        QVERIFY((high - low).maxCoeff() < 0.29);
    }
};

QTEST_APPLESS_MAIN(TestEndoscopeInUrethra)
#include "test_endoscope_in_urethra.moc"
