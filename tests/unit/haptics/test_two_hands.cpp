// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands on one unfixed tube (P2, "Control Algorithm for Multiple Instruments", figure 7): the worst case
// of the books.
#include "core/units.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "haptics/passivity_controller.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"
#include "support/sanitized.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using core::Vec3;
using haptics::GuardMask;

namespace {

constexpr double kApart_m = 0.120; // between the two entry points
constexpr double kRest_m = 0.122;  // so that the tube is slack while force arms
constexpr double kFriction = 0.1;  // of the device itself: the worst case
constexpr double kPull_m = 0.014;  // each hand then goes outwards by this much
constexpr double kPullAt_s = 3.0;

/// Holds its place, then pulls outwards and holds again, or goes to and fro so that the tube hangs slack in
/// every cycle of 3 s. Tremor is the hand's own.
class Puller final : public mechanisms::HandStrategy {
public:
    Puller(double side, bool swings) : m_side(side), m_swings(swings) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        const double way = std::clamp((seen.time_s - kPullAt_s) / 0.5, 0.0, 1.0);
        const double fro =
            m_swings ? 0.5 * (1.0 + std::cos(2.0 * core::kPi * (seen.time_s - kPullAt_s - 0.5) / 3.0)) : 1.0;
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = Vec3(m_side * kPull_m * (way < 1.0 ? way : fro), 0.0, 0.05);
        return wanted;
    }

private:
    double m_side;
    bool m_swings;
};

/// The exercise's own scene, level "two_handed", with jaws that open once and then hold both ends from
/// wherever they are.
class HeldTube final : public simulation::IScene {
public:
    HeldTube(double stiffness_N_per_m, double viscosity_Ns_per_m)
        : m_scene(exercise(stiffness_N_per_m, viscosity_Ns_per_m), 1) {}
    void respond(const realtime::HapticTick& now, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        simulation::SceneInput held = in;
        for (core::ToolState& tool : held.tools.tools)
            tool.jaw_rad = m_tick < 100 ? 0.7 : 0.05;
        ++m_tick;
        m_scene.respond(now, held, out);
    }

private:
    static simulation::ElasticTubeParameters exercise(double stiffness_N_per_m, double viscosity_Ns_per_m) {
        simulation::ElasticTubeParameters p;
        p.task = simulation::TubeTask::twoHanded;
        p.tube.stiffness_N_per_m = stiffness_N_per_m;
        p.tube.viscosity_Ns_per_m = viscosity_Ns_per_m;
        p.restLength_m = kRest_m;
        p.baseSpread_m = 0.0;
        p.graspReach_m = 0.2;
        p.tearRatio = 2.0, p.overStretchRatio = 1.9; // no run gets there
        p.hold_s = p.trialLimit_s = 3600.0;
        p.trials = 1;
        return p;
    }
    simulation::ElasticTubeScene m_scene;
    std::uint64_t m_tick = 0;
};

/// What became of a run.
struct Outcome final : core::IFrameSink {
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        const double f = frame.tool[0].commanded[0];
        leastMargin_J = std::min(leastMargin_J, frame.header.energySupplied_J - frame.header.energyStored_J);
        stored_J = frame.header.energyStored_J;
        for (std::size_t i = 0; i < 2; ++i)
            held[i] =
                Vec3(frame.tool[i].commanded[0], frame.tool[i].commanded[1], frame.tool[i].commanded[2]);
        share = f != 0.0 && frame.tool[0].tissue[0] != 0.0 ? f / frame.tool[0].tissue[0] : share;
        if (frame.header.index == 0 || frame.header.index < m_from) {
            m_before = f;
            return true;
        }
        change += (f - m_before) * (f - m_before);
        m_before = f;
        strongest_N = std::max(strongest_N, std::abs(f));
        weakest_N = std::min(weakest_N, std::abs(f));
        damped += (frame.header.guards & core::guard_bits::kPassivity) != 0 ? 1 : 0;
        latched = latched || frame.header.force == core::ForceState::fault;
        ++ticks;
        return true;
    }
    /// Work of what was commanded over the way that the tips really went: what the objects and the loop made,
    /// if it is more than they had. `moved`: since the last tick.
    void addWork(const std::array<Vec3, 2>& force, const std::array<Vec3, 2>& moved) {
        for (std::size_t i = 0; i < 2; ++i)
            made_J += force[i].dot(moved[i]);
        mostMade_J = std::max(mostMade_J, made_J);
    }
    double all_J() const { return made_J + stored_J; } ///< with what it still holds
    double chatter_N() const {                         ///< rms change of force a tick
        return std::sqrt(change / static_cast<double>(std::max<std::uint64_t>(1, ticks)));
    }

    std::uint64_t m_from = 20'000; // settled
    std::array<Vec3, 2> held{Vec3::Zero(), Vec3::Zero()};
    double made_J = 0.0, mostMade_J = 0.0, stored_J = 0.0, share = 1.0;
    double change = 0.0, strongest_N = 0.0, weakest_N = 1e9, leastMargin_J = 1e9;
    std::uint64_t ticks = 0, damped = 0;
    bool latched = false;

private:
    double m_before = 0.0;
};

struct Run {
    double stiffness_N_per_m;
    int delay_ticks;
    mechanisms::HandParameters hand;
    std::uint32_t without = 0;
    double seconds = 60.0;
    double viscosity_Ns_per_m = 0.0; ///< of the tube
    bool swings = false;             ///< slack in every cycle
};

Outcome run(const Run& wanted) {
    std::vector<std::unique_ptr<devices::SimulatedDevice>> devices;
    std::vector<haptics::LoopTool> tools;
    for (const double side : {1.0, -1.0}) { // tool 0 is the right one
        devices::SimulatedDevice::Configuration configuration;
        configuration.hand = wanted.hand;
        configuration.plant.sampleDelay_ticks = wanted.delay_ticks;
        for (auto& axis : configuration.plant.friction)
            axis.coulomb *= kFriction, axis.viscous *= kFriction;
        configuration.seed = side > 0.0 ? 1 : 1001;
        configuration.mapping.origin_m = {0.5 * kApart_m * side, 0.0, 0.0};
        devices.push_back(std::move(
            *devices::SimulatedDevice::create(configuration, std::make_unique<Puller>(side, wanted.swings))));
        (void)devices.back()->open();
        tools.push_back({*devices.back(), configuration.mapping});
    }
    Outcome outcome;
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    supervisor.setGuardMaskForTests(GuardMask::without(wanted.without));
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene =
        std::make_unique<HeldTube>(wanted.stiffness_N_per_m, wanted.viscosity_Ns_per_m);
    scenes.offer(scene);
    auto loop = std::move(*haptics::HapticLoop::create({tools, inputs, supervisor, {}, scenes, outcome}));
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    std::array<Vec3, 2> at{devices[0]->plant().p_DT(), devices[1]->plant().p_DT()}; // D's axes are W's here
    for (std::int64_t n = 0; n < static_cast<std::int64_t>(1000.0 * wanted.seconds); ++n) {
        const std::array<Vec3, 2> before = at;
        const std::array<Vec3, 2> held = outcome.held; // the plants move under the last tick's force
        loop->tick(ticks.next(n * 1'000'000));
        at = {devices[0]->plant().p_DT(), devices[1]->plant().p_DT()};
        outcome.addWork(held, {at[0] - before[0], at[1] - before[1]});
    }
    return outcome;
}

/// The worst hands: light, with a loose grip that damps little, on devices nearly without friction of their
/// own.
mechanisms::HandParameters looseHand() {
    mechanisms::HandParameters hand = mechanisms::HandParameters::light();
    hand.gripStiffness_N_per_m = 1000.0;
    hand.gripDamping_Ns_per_m = 1.0;
    return hand;
}

constexpr double kDamping_Ns_per_m = 2.0 + 0.05; ///< of one tip: the arm's, and a tenth of the device's own

} // namespace

class TestTwoHands : public QObject {
    Q_OBJECT
private slots:
    void theStiffestTubesAreHeldForAMinute_data();
    void theStiffestTubesAreHeldForAMinute();
    void whatTheDelayCarriesIsLeftAlone();
    void theStiffestStableTubeFollowsTheDelay();
};

void TestTwoHands::theStiffestTubesAreHeldForAMinute_data() {
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("viscosity");
    QTest::addColumn<bool>("swings");
    QTest::newRow("drawn by a level: 500 N/m") << 500.0 << 0.0 << false;
    QTest::newRow("2000 N/m, 2 N s/m, slack in every cycle") << 2000.0 << 2.0 << true;
    if (support::kSanitized)
        return; // the others run the same instructions with other numbers
    QTest::newRow("500 N/m, slack in every cycle") << 500.0 << 0.0 << true;
    QTest::newRow("500 N/m, 0.5 N s/m along it") << 500.0 << 0.5 << false; // felt late, it drives
    QTest::newRow("an object's own: 2000 N/m") << 2000.0 << 0.0 << false;
}

void TestTwoHands::theStiffestTubesAreHeldForAMinute() {
    QFETCH(double, stiffness);
    QFETCH(double, viscosity);
    QFETCH(bool, swings);
    const Outcome with = run({stiffness, 3, looseHand(), 0, 60.0, viscosity, swings});
    const Outcome without = run({stiffness, 3, looseHand(), GuardMask::kPassivity, 60.0, viscosity, swings});
    qInfo("%.0f N/m, 3 ms late: share %.2f, tension %.2f to %.2f N, rms change %.4f N a tick, made %.2f mJ "
          "in truth, most held beyond "
          "the work measured %.2f mJ; without the guard %.2f to %.2f N, %.4f N, %.0f mJ",
          stiffness, with.share, with.weakest_N, with.strongest_N, with.chatter_N(), 1e3 * with.all_J(),
          -1e3 * with.leastMargin_J, without.weakest_N, without.strongest_N, without.chatter_N(),
          1e3 * without.all_J());
    // Held: never slack but where the hands let it hang, never at the motors' 3 N, and quieter than a tremor
    // of 0.1 mm makes it anyhow. 20 s were given to settle.
    QVERIFY(!with.latched && (swings || with.weakest_N > 0.0) && with.strongest_N < 2.0 &&
            with.chatter_N() < 0.02);
    // As the device measures: 1 mJ that is allowed, 1 mJ that is forgiven, and what is made while c falls by
    // 1 % a tick.
    QVERIFY(with.leastMargin_J > -0.0025);
    // In truth: 1 mJ, 0.1 mW of a trembling hand for 60 s, and what is made while c falls.
    QVERIFY(with.mostMade_J < 0.009 && with.all_J() < 0.009);
    // Without the books the tube is shaken for ever: the test can fail.
    QVERIFY(without.chatter_N() > 0.02 && without.all_J() > 0.1);
}

void TestTwoHands::whatTheDelayCarriesIsLeftAlone() {
    const Outcome with = run({200.0, 3, looseHand(), 0, 60.0});
    const Outcome without = run({200.0, 3, looseHand(), GuardMask::kPassivity, 60.0});
    QCOMPARE(with.damped, std::uint64_t{0});
    QCOMPARE(with.strongest_N, without.strongest_N); // the same run
    QCOMPARE(with.change, without.change);
}

void TestTwoHands::theStiffestStableTubeFollowsTheDelay() {
    CHIRON_SKIP_STATISTICS(); // a search through 30 runs like those above
    // devices.md §6: K < (b + B)/(T/2 + t_d). In the tube both tips move against each other, so that each
    // meets 2k; t_d is the sample's delay and the amplifier's lag.
    double before = 1e9;
    for (const int delay : {1, 2, 3}) {
        double stiffest = 0.0;
        for (double k = 150.0; k <= 900.0; k += 75.0) {
            const Outcome outcome = run({k, delay, looseHand(), GuardMask::kPassivity, 25.0});
            if (outcome.weakest_N == 0.0 ||
                outcome.chatter_N() > 4.0 * 1.5e-5 * k) // a tremor makes about 1.5e-5 m a tick
                break;
            stiffest = k;
        }
        const double limit = kDamping_Ns_per_m / (0.0005 + 0.0003 + 0.001 * delay) / 2.0;
        qInfo("%d ms late: stable up to %.0f N/m, the rule says %.0f", delay, stiffest, limit);
        QVERIFY(stiffest <= before && stiffest > 0.5 * limit && stiffest < 2.0 * limit);
        before = stiffest;
    }
}

QTEST_APPLESS_MAIN(TestTwoHands)
#include "test_two_hands.moc"
