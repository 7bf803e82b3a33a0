// SPDX-License-Identifier: GPL-3.0-or-later
// The closed loop of a palpation: hand → arm → tissue → supervisor → platform → pad, displayed against
// computed while in contact, beside P3's figures.
#include "devices/drivers/simulated/simulated_fingertip_device.h"
#include "haptics/safety_supervisor.h"
#include "mechanisms/fingertip_verification.h"
#include "simulation/palpation/tissue_contact.h"
#include "simulation/palpation/tissue_pinch.h"
#include "simulation/velocity_estimator.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Vec3;

namespace {

/// Waits above until force is on, presses, strokes over the lump and back along both axes, lifts; again and
/// again.
class Stroker final : public mechanisms::HandStrategy {
public:
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        mechanisms::HandIntention wanted;
        const double t = seen.time_s - 2.5;
        const double cycle = 6.0, s = t - cycle * std::floor(t / cycle);
        const double down = t < 0.0 ? 0.0 : std::clamp(std::min(s, cycle - s) / 1.0, 0.0, 1.0);
        const double smooth = down * down * (3.0 - 2.0 * down);
        const double stroke = 2.0 * core::kPi * std::clamp((s - 1.0) / 4.0, 0.0, 1.0);
        const bool across = static_cast<int>(t / cycle) % 2 == 1;
        const double along = t < 0.0 ? 0.0 : 0.02 * std::sin(stroke);
        wanted.p_DDesired = Vec3(across ? 0.0 : along, across ? along : 0.0, 0.006 - 0.0095 * smooth);
        most_N = std::max(most_N, seen.pad.normalForce_N);
        return wanted;
    }
    double most_N = 0.0;
};

/// Goes in with open jaws, waits, closes them half-way and holds: what its pad feels before and after.
class Pincher final : public mechanisms::HandStrategy {
public:
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        const double t = seen.time_s - 2.5;
        const double down = std::clamp(t, 0.0, 1.0), closed = std::clamp(t - 2.5, 0.0, 1.0);
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = Vec3(0.0, 0.0, 0.006 - 0.009 * down * down * (3.0 - 2.0 * down));
        wanted.jaw_rad = 0.9 - 0.2 * closed;
        after_N += 0.005 * (seen.pad.normalForce_N - after_N); // over 0.2 s: the hand trembles
        if (t < 2.4)
            before_N = after_N;
        return wanted;
    }
    double before_N = 0.0, after_N = 0.0;
};

struct Loop {
    struct Figures {
        double forceSum2 = 0.0, forceTrueSum2 = 0.0, angleSum = 0.0, angleTrueSum = 0.0;
        double mostComputed_N = 0.0, mostLean_rad = 0.0;
        int contact = 0; ///< ticks: all the figures are of these
    };

    explicit Loop(std::uint64_t seed, std::unique_ptr<mechanisms::HandStrategy> other = nullptr)
        : contact(tissue()), pinches(other != nullptr) {
        const simulation::Lump lump{{0.004, 0.0}, 0.010, 0.005, 10.0};
        contact.setLumps({&lump, 1});
        auto strategy = std::move(other);
        if (!strategy) {
            auto made = std::make_unique<Stroker>();
            stroker = made.get();
            strategy = std::move(made);
        }
        devices::SimulatedFingertipDevice::Configuration c;
        c.start_D = Vec3(0.0, 0.0, 0.006);
        c.seed = seed;
        device = std::move(devices::SimulatedFingertipDevice::create(c, std::move(strategy)).value());
        const std::array<haptics::SafetyTool, 1> tools{
            haptics::SafetyTool{device->descriptor(), device->kinematics(), {}}};
        haptics::SafetySettings settings;
        settings.heartbeatWatched = false;
        if (!device->open() || !supervisor.configure(settings, tools))
            qFatal("open");
        states.count = scene.tissue.count = 1;
    }

    static simulation::TissueParameters tissue() {
        simulation::TissueParameters p;
        p.stiffness_N_per_m = 500.0;
        return p;
    }

    void tick(Figures& f) {
        const realtime::HapticTick now = ticks.next(static_cast<std::int64_t>(n++) * 1'000'000);
        const core::DeviceSample sample = device->read(now);
        const core::ToolState pose = device->kinematics().pose(sample);
        supervisor.admit(now, 0, sample, pose, 0);
        core::ToolState& tool = states.tools[0];
        tool = pose;
        device->kinematics().velocity(sample, velocity.update(sample), tool.v_WT, tool.w_WT);
        simulation::TissueResponse response = contact.respond(tool, touch);
        if (pinches) {
            pinched = simulation::pinchTissue(contact, {}, tool, response, pinch);
            response.force += pinched.hold;
            response.display.normalForce_N += pinched.force_N;
        }
        scene.tissue.tools[0] = {response.force, Vec3::Zero()};
        scene.display[0] = response.display;
        scene.storedEnergy_J = response.energy_J;
        scene.contactStiffness_N_per_m = response.stiffness_N_per_m;
        supervisor.limit(now, {states, scene, {}, 0}, out);
        devices::ForceCommand command;
        command.wrench_D = out.tools[0].wrench_D;
        command.display = out.tools[0].display_D;
        command.enabled = out.tools[0].enabled;
        device->command(now, command);
        guards |= out.guards;
        if (!out.forceReady ||
            !response.inContact) // in the air there is nothing to display: it would only flatter
            return;
        ++f.contact;
        const core::DisplayPose &asked = response.display, &real = device->platform().truth();
        const double force = asked.normalForce_N - device->platform().sensedForce_N(),
                     truly = asked.normalForce_N - real.normalForce_N;
        f.forceSum2 += force * force;
        f.forceTrueSum2 += truly * truly;
        f.mostComputed_N = std::max(f.mostComputed_N, asked.normalForce_N);
        f.mostLean_rad = std::max(f.mostLean_rad, std::hypot(asked.pitch_rad, asked.roll_rad));
        f.angleSum += core::degFromRad(std::hypot(asked.pitch_rad - device->platform().sensedPitch_rad(),
                                                  asked.roll_rad - device->platform().sensedRoll_rad()));
        f.angleTrueSum +=
            core::degFromRad(std::hypot(asked.pitch_rad - real.pitch_rad, asked.roll_rad - real.roll_rad));
    }

    simulation::TissueContact contact;
    bool pinches;
    simulation::TissueTouch touch;
    simulation::PinchTouch pinch;
    simulation::PinchResponse pinched;
    std::unique_ptr<devices::SimulatedFingertipDevice> device;
    Stroker* stroker = nullptr;
    haptics::SafetySupervisor supervisor;
    haptics::SafetyOutput out;
    simulation::SceneOutput scene;
    simulation::VelocityEstimator velocity;
    core::ToolStates states;
    realtime::TickSource ticks;
    std::uint64_t n = 0;
    std::uint32_t guards = 0;
};

} // namespace

class TestPalpationDisplay : public QObject {
    Q_OBJECT
private slots:
    void displayedFollowsComputed_data();
    void displayedFollowsComputed();
    void aPinchIsFeltAtThePad();
};

void TestPalpationDisplay::displayedFollowsComputed_data() {
    QTest::addColumn<int>("seed");
    for (const int seed : {4, 5, 6})
        QTest::addRow("seed %d", seed) << seed;
}

// P3's bounds are of what its sensors measured; what the pad truly got is held to them too.
void TestPalpationDisplay::displayedFollowsComputed() {
    QFETCH(int, seed);
    Loop loop(static_cast<std::uint64_t>(seed));
    Loop::Figures f;
    for (int n = 0; n < 26500; ++n) // four strokes, both directions
        loop.tick(f);
    QVERIFY(loop.out.forceReady);
    QVERIFY2(f.contact > 12000 && f.mostComputed_N > 1.0 && f.mostComputed_N < 4.0 && f.mostLean_rad > 0.15,
             qPrintable(
                 QString("%1 ticks, %2 N, %3 rad").arg(f.contact).arg(f.mostComputed_N).arg(f.mostLean_rad)));
    QVERIFY(loop.stroker->most_N > 0.8 * f.mostComputed_N); // the hand felt it
    QCOMPARE(loop.guards & (core::guard_bits::kPassivity | core::guard_bits::kOverVelocity), 0u);
    const double rmse = std::sqrt(f.forceSum2 / f.contact), truly = std::sqrt(f.forceTrueSum2 / f.contact);
    const double angle = f.angleSum / f.contact, angleTruly = f.angleTrueSum / f.contact;
    qInfo("palpation up to %.2f N and %.1f deg: RMSE %.4f N (P3's sine %.4f), on the pad %.4f N; angle %.2f "
          "deg (P3's poses %.2f), truly %.2f",
          f.mostComputed_N, core::degFromRad(f.mostLean_rad), rmse,
          mechanisms::FingertipPublished::kMeanRmse_N, truly, angle,
          mechanisms::FingertipPublished::kMeanError_deg, angleTruly);
    QVERIFY(rmse < mechanisms::FingertipPublished::kMeanRmse_N &&
            truly < mechanisms::FingertipPublished::kMeanRmse_N);
    QVERIFY(angle < mechanisms::FingertipPublished::kMeanError_deg &&
            angleTruly < mechanisms::FingertipPublished::kMeanError_deg);
}

// Fingers close the arm's lever, its Hall sensor tells the jaw, the tissue between the jaws is squeezed, and
// the platform presses the pad by that much more.
void TestPalpationDisplay::aPinchIsFeltAtThePad() {
    auto strategy = std::make_unique<Pincher>();
    Pincher* hand = strategy.get();
    Loop loop(11, std::move(strategy));
    Loop::Figures figures;
    double squeeze = 0.0;
    for (int n = 0; n < 8000; ++n) {
        loop.tick(figures);
        squeeze = loop.pinched.force_N;
    }
    QVERIFY2(squeeze > 0.4 && squeeze < 3.0, qPrintable(QString::number(squeeze)));
    QVERIFY2(hand->before_N > 0.3, qPrintable(QString::number(hand->before_N)));
    const double more = hand->after_N - hand->before_N;
    QVERIFY2(std::abs(more - squeeze) < 0.1 + 0.1 * squeeze,
             qPrintable(QString("%1 N more at the pad for %2 N between the jaws").arg(more).arg(squeeze)));
}

QTEST_APPLESS_MAIN(TestPalpationDisplay)
#include "test_palpation_display.moc"
