// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands on one unfixed tube (P2, "Control Algorithm for Multiple Instruments", figure 7): the worst case of the books.
#include "devices/drivers/simulated/simulated_device.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using core::Vec3;
using haptics::GuardMask;

namespace {

constexpr double kApart_m = 0.120;  // between the two entry points
constexpr double kRest_m = 0.122;   // so that the tube is slack while force arms
double g_friction = 1.0;
double g_pull = 0.004;   // each hand then goes outwards by this much
constexpr double kPullAt_s = 3.0;

/// Holds its place, then pulls outwards and holds again. Tremor is the hand's own.
class Puller final : public mechanisms::HandStrategy {
public:
    explicit Puller(double side) : m_side(side) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        const double way = std::clamp((seen.time_s - kPullAt_s) / 0.5, 0.0, 1.0);
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = Vec3(m_side * g_pull * way, 0.0, 0.05);
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
    double chatter_N() const { return std::sqrt(change / static_cast<double>(std::max<std::uint64_t>(1, ticks))); }
    bool stable() const { return !latched && chatter_N() < 0.05; } ///< rms change of force a tick

    std::uint64_t m_from = 10'000; // settled
    double change = 0.0, strongest_N = 0.0, weakest_N = 1e9, leastMargin_J = 1e9;
    std::uint64_t ticks = 0, damped = 0;
    bool latched = false;

private:
    double m_before = 0.0;
};

struct Run {
    double stiffness_N_per_m = 500.0;
    int delay_ticks = 0;
    mechanisms::HandParameters hand;
    std::uint32_t without = 0;
    double seconds = 60.0;
    std::uint64_t seed = 1;
};

Outcome run(const Run& wanted) {
    std::vector<std::unique_ptr<devices::SimulatedDevice>> devices;
    std::vector<haptics::LoopTool> tools;
    for (const double side : {1.0, -1.0}) { // tool 0 is the right one
        devices::SimulatedDevice::Configuration configuration;
        configuration.hand = wanted.hand;
        configuration.plant.sampleDelay_ticks = wanted.delay_ticks;
        for (auto& axis : configuration.plant.friction)
            axis.coulomb *= g_friction, axis.viscous *= g_friction;
        configuration.seed = wanted.seed + (side > 0.0 ? 0 : 1000);
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

} // namespace

class TestTwoHands : public QObject {
    Q_OBJECT
private slots:
    void explore() {
        struct { const char* name; mechanisms::HandParameters hand; double pull; } hands[] = {
            {"default loose", {.gripStiffness_N_per_m = 1000.0, .gripDamping_Ns_per_m = 1.0}, 0.006},
            {"light loose", mechanisms::HandParameters::light(), 0.014},
            {"default", {}, 0.006}};
        hands[1].hand.gripDamping_Ns_per_m = 1.0;
        hands[1].hand.gripStiffness_N_per_m = 1000.0;
        for (const double friction : {0.1, 0.0})
        for (const auto& hand : hands)
        for (const int delay : {1, 2, 3})
            for (const double k : {250.0, 500.0, 1000.0, 2000.0}) {
                g_pull = hand.pull;
                g_friction = friction;
                const Outcome with = run({k, delay, hand.hand, 0, 15.0, 1});
                const Outcome without = run({k, delay, hand.hand, GuardMask::kPassivity, 15.0, 1});
                qInfo("friction %.1f %s delay %d k %4.0f: with: chatter %.4f damped %.3f f %.2f..%.2f fault %d | without: chatter %.4f f %.2f..%.2f fault %d",
                      friction, hand.name, delay, k, with.chatter_N(), double(with.damped) / double(with.ticks), with.weakest_N, with.strongest_N, with.latched,
                      without.chatter_N(), without.weakest_N, without.strongest_N, without.latched);
            }
    }
};

QTEST_APPLESS_MAIN(TestTwoHands)
#include "test_two_hands.moc"
