// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands on one unfixed tube (P2, "Control Algorithm for Multiple Instruments", figure 7): the worst case of the books.
#include "devices/drivers/simulated/simulated_device.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "haptics/passivity_controller.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using core::Vec3;
using haptics::GuardMask;

namespace {

constexpr double kApart_m = 0.120;  // between the two entry points
constexpr double kRest_m = 0.122;   // so that the tube is slack while force arms
constexpr double kFriction = 0.1;  // of the device itself: the worst case
constexpr double kPull_m = 0.014;  // each hand then goes outwards by this much
constexpr double kPullAt_s = 3.0;

/// Holds its place, then pulls outwards and holds again. Tremor is the hand's own.
class Puller final : public mechanisms::HandStrategy {
public:
    explicit Puller(double side) : m_side(side) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        const double way = std::clamp((seen.time_s - kPullAt_s) / 0.5, 0.0, 1.0);
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = Vec3(m_side * kPull_m * way, 0.0, 0.05);
        return wanted;
    }

private:
    double m_side;
};

/// An unfixed, massless tube between two tips: tension k·stretch along the line between them, zero when slack.
class TubeBetween final : public simulation::IScene {
public:
    explicit TubeBetween(double stiffness_N_per_m) : m_k(stiffness_N_per_m) {}
    void respond(const realtime::HapticTick&, const simulation::SceneInput& in, simulation::SceneOutput& out) noexcept override {
        out = simulation::SceneOutput{};
        out.phase = core::TrialPhase::running;
        out.tissue.count = in.tools.count;
        if (in.tools.count < 2)
            return;
        const Vec3 way = in.tools.tools[1].p_WT - in.tools.tools[0].p_WT;
        const double stretch = std::max(0.0, way.norm() - kRest_m);
        out.tissue.tools[0].force = m_k * stretch * way.normalized();
        out.tissue.tools[1].force = -out.tissue.tools[0].force;
        out.energyByBody = true; // both at body 0
        out.bodyEnergy_J[0] = out.storedEnergy_J = 0.5 * m_k * stretch * stretch;
        // Both ends of it move; held all the time, slack or not.
        out.bodyStiffness_N_per_m[0] = out.contactStiffness_N_per_m = 2.0 * m_k;
    }

private:
    double m_k;
};

/// What became of a run.
struct Outcome final : core::IFrameSink {
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        if (frame.header.index == 0 || frame.header.index < m_from) {
            m_before = frame.tool[0].commanded[0];
            return true;
        }
        const double f = frame.tool[0].commanded[0];
        change += (f - m_before) * (f - m_before);
        m_before = f;
        strongest_N = std::max(strongest_N, std::abs(f));
        weakest_N = std::min(weakest_N, std::abs(f));
        damped += (frame.header.guards & core::guard_bits::kPassivity) != 0 ? 1 : 0;
        latched = latched || frame.header.force == core::ForceState::fault;
        leastMargin_J = std::min(leastMargin_J, frame.header.energySupplied_J - frame.header.energyStored_J);
        ++ticks;
        return true;
    }
    double chatter_N() const { ///< rms change of force a tick
        return std::sqrt(change / static_cast<double>(std::max<std::uint64_t>(1, ticks)));
    }

    std::uint64_t m_from = 20'000; // settled
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
        devices.push_back(std::move(*devices::SimulatedDevice::create(configuration, std::make_unique<Puller>(side))));
        (void)devices.back()->open();
        tools.push_back({*devices.back(), configuration.mapping});
    }
    Outcome outcome;
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    supervisor.setGuardMaskForTests(GuardMask::without(wanted.without));
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene = std::make_unique<TubeBetween>(wanted.stiffness_N_per_m);
    scenes.offer(scene);
    auto loop = std::move(*haptics::HapticLoop::create({tools, inputs, supervisor, {}, scenes, outcome}));
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    for (std::int64_t n = 0; n < static_cast<std::int64_t>(1000.0 * wanted.seconds); ++n)
        loop->tick(ticks.next(n * 1'000'000));
    return outcome;
}

/// The worst hands: light, with a loose grip that damps little, on devices nearly without friction of their own.
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
    void oneBodyCannotBorrowFromAnother();
    void aHeldBodyKeepsItsBookWhileItIsSlack();
    void booksGoWithTheirTools();
};

void TestTwoHands::theStiffestTubesAreHeldForAMinute_data() {
    QTest::addColumn<double>("stiffness");
    QTest::newRow("drawn by a level: 500 N/m") << 500.0;
    QTest::newRow("an object's own: 2000 N/m") << 2000.0;
}

void TestTwoHands::theStiffestTubesAreHeldForAMinute() {
    QFETCH(double, stiffness);
    const Outcome with = run({stiffness, 3, looseHand(), 0, 60.0});
    const Outcome without = run({stiffness, 3, looseHand(), GuardMask::kPassivity, 60.0});
    qInfo("%.0f N/m, 3 ms late: tension %.2f to %.2f N, rms change %.4f N a tick, least W - E %.2f mJ; without the guard %.2f to "
          "%.2f N, %.4f N",
          stiffness, with.weakest_N, with.strongest_N, with.chatter_N(), 1e3 * with.leastMargin_J, without.weakest_N,
          without.strongest_N, without.chatter_N());
    // Held: never slack, never at the motors' 3 N, and quieter than a tremor of 0.1 mm makes it anyhow. 20 s were given to settle.
    QVERIFY(!with.latched && with.weakest_N > 0.0 && with.strongest_N < 2.9 && with.chatter_N() < 0.02);
    QVERIFY(with.leastMargin_J > -0.0035); // the 1 mJ that is allowed, and what is made while c falls by 1 % a tick
    // Without the books the tube is shaken from slack to the motors' limit for ever: the test can fail.
    QVERIFY(without.weakest_N < 0.05 && without.strongest_N > 2.9 && without.chatter_N() > 0.04);
}

void TestTwoHands::whatTheDelayCarriesIsLeftAlone() {
    const Outcome with = run({200.0, 3, looseHand(), 0, 60.0});
    const Outcome without = run({200.0, 3, looseHand(), GuardMask::kPassivity, 60.0});
    QCOMPARE(with.damped, std::uint64_t{0});
    QCOMPARE(with.strongest_N, without.strongest_N); // the same run
    QCOMPARE(with.change, without.change);
}

void TestTwoHands::theStiffestStableTubeFollowsTheDelay() {
    // devices.md §6: K < (b + B)/(T/2 + t_d). In the tube both tips move against each other, so that each meets 2k; t_d is the
    // sample's delay and the amplifier's lag.
    double before = 1e9;
    for (const int delay : {1, 2, 3}) {
        double stiffest = 0.0;
        for (double k = 150.0; k <= 900.0; k += 75.0) {
            const Outcome outcome = run({k, delay, looseHand(), GuardMask::kPassivity, 25.0});
            if (outcome.weakest_N == 0.0 || outcome.chatter_N() > 4.0 * 1.5e-5 * k) // a tremor makes about 1.5e-5 m a tick
                break;
            stiffest = k;
        }
        const double limit = kDamping_Ns_per_m / (0.0005 + 0.0003 + 0.001 * delay) / 2.0;
        qInfo("%d ms late: stable up to %.0f N/m, the rule says %.0f", delay, stiffest, limit);
        QVERIFY(stiffest <= before && stiffest > 0.5 * limit && stiffest < 2.0 * limit);
        before = stiffest;
    }
}

namespace {
/// A controller with two tools, armed, without caps in the way.
struct Books {
    Books() {
        controller.reset({});
        for (auto& limit : limits)
            limit.renders = true;
        states.count = 2;
    }
    /// Tool i of body `of[i]` is shown f[i]; then moves by dx[i].
    void tick(const std::array<std::uint8_t, 2>& of, const std::array<double, 2>& force, const std::array<double, 2>& dx,
              const std::array<double, 4>& energy, double stiffness = 0.0) {
        haptics::PassivityBodies bodies;
        for (std::size_t i = 0; i < 2; ++i) {
            bodies.bodyOf[i] = of[i];
            haptics::PassivityContact& c = bodies.contacts[of[i]];
            c.members[i] = true;
            c.share[i] = of[0] == of[1] ? 0.5 : 1.0;
            c.capRatio[i] = 1.0;
        }
        for (std::size_t body = 0; body < 4; ++body) {
            haptics::PassivityContact& c = bodies.contacts[body];
            c.givesWay = true;
            c.gain = c.gainBefore = 1.0;
            c.stored_J = energy[body];
            c.stiffness_N_per_m = stiffness;
            c.touching = energy[body] > 0.0 || stiffness > 0.0;
        }
        haptics::PassivityController::Wrenches wrenches{};
        for (std::size_t i = 0; i < 2; ++i)
            wrenches[i].force.x() = force[i];
        acted = controller.apply(limits, 2, states, bodies, wrenches);
        core::ToolWrenches shown;
        shown.count = 2;
        for (std::size_t i = 0; i < 2; ++i)
            shown.tools[i] = wrenches[i];
        controller.hold(states, shown);
        share = force[0] != 0.0 ? wrenches[0].force.x() / force[0] : 1.0;
        for (std::size_t i = 0; i < 2; ++i)
            states.tools[i].p_WT.x() += dx[i];
    }
    haptics::PassivityController controller;
    haptics::PassivityController::Limits limits{};
    core::ToolStates states;
    bool acted = false;
    double share = 1.0;
};

} // namespace

void TestTwoHands::oneBodyCannotBorrowFromAnother() {
    // Tool 1 pushes into its spring: 1 N over 20 mm, 20 mJ in. Tool 0 is pushed by 1 N over 20 mm, and nobody pays.
    for (const bool apart : {false, true}) {
        Books books;
        double least = 1.0;
        for (int n = 0; n < 200; ++n) {
            const double in = 1e-4 * n;
            books.tick({0, static_cast<std::uint8_t>(apart ? 1 : 0)}, {1.0, 1.0}, {1e-4, -1e-4},
                       apart ? std::array{1e-6, in, 0.0, 0.0} : std::array{1e-6, 0.0, 0.0, 0.0});
            least = std::min(least, books.share);
        }
        QCOMPARE(least < 0.5, apart); // together the one pays for the other
    }
}

void TestTwoHands::aHeldBodyKeepsItsBookWhileItIsSlack() {
    // Each pull gives back 0.8 mJ more than it took, and the tube is slack in between.
    for (const bool held : {false, true}) {
        Books books;
        bool acted = false;
        for (int pull = 0; pull < 5; ++pull) {
            for (int n = 0; n < 8; ++n) {
                books.tick({0, 0}, {1.0, 0.0}, {1e-4, 0.0}, {1e-6, 0.0, 0.0, 0.0}, held ? 500.0 : 0.0);
                acted = acted || books.acted;
            }
            books.tick({0, 0}, {0.0, 0.0}, {0.0, 0.0}, {}, held ? 500.0 : 0.0);
        }
        QCOMPARE(acted, held);
    }
}

void TestTwoHands::booksGoWithTheirTools() {
    Books books;
    // Both at bodies of their own, 2 mJ put into each by 1 N over 2 mm.
    for (int n = 0; n <= 20; ++n)
        books.tick({0, 1}, {1.0, 1.0}, {n < 20 ? -1e-4 : 0.0, n < 20 ? -1e-4 : 0.0}, {1e-4 * n, 1e-4 * n, 0.0, 0.0});
    QVERIFY(std::abs(books.controller.supplied_J() - 4e-3) < 1e-6);
    // They become one: the books are one, nothing is lost and nothing is owed.
    books.tick({0, 0}, {1.0, 1.0}, {0.0, 0.0}, {4e-3, 0.0, 0.0, 0.0});
    QVERIFY(std::abs(books.controller.excess_J(0)) < 1e-6 && !books.acted);
    // One of two again, with a quarter of it: what it holds goes along.
    books.tick({0, 2}, {1.0, 1.0}, {0.0, 0.0}, {3e-3, 0.0, 1e-3, 0.0});
    QVERIFY(std::abs(books.controller.excess_J(2)) < 1e-6 && std::abs(books.controller.excess_J(0)) < 1e-6);
}

QTEST_APPLESS_MAIN(TestTwoHands)
#include "test_two_hands.moc"
