// SPDX-License-Identifier: GPL-3.0-or-later
#include "damping/damping_bench.h"

#include "core/units.h"
#include "damping/with_budget.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "devices/drivers/simulated/simulated_fingertip_device.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "ladder/fast_force.h"
#include "mechanisms/hand_strategy.h"
#include "support/named_hands.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::tests {

namespace {

using core::Vec3;

constexpr double kFriction_N = 2.7; ///< μN in the stricture (models.md §1.2)
constexpr double kAcross_N_per_m = 1120.0;
constexpr double kWall_N_per_m = 1000.0;
constexpr double kPressed_m = 0.008; ///< that the hand wants to be in the wall
constexpr double kArming_s = 3.0;
constexpr double kAmplitude_m = 0.016, kPeriod_s = 4.0, kRest_s = 1.5;

bool isFiveBar(const std::string& mechanism) {
    return mechanism == "five_bar_spherical";
}

struct Way {
    Vec3 start_D;
    Vec3 along_D; ///< unit
};

Way wayOf(const std::string& mechanism, int pose) {
    if (isFiveBar(mechanism))
        return pose == 0 ? Way{{0.0, -0.04, 0.01}, Vec3::UnitY()}
                         : Way{{0.0, 0.02, 0.08}, Vec3(0.0, 0.6, 0.8)};
    return pose == 0 ? Way{{0.0, 0.0, 0.05}, Vec3::UnitX()} : Way{{0.04, 0.03, 0.07}, -Vec3::UnitZ()};
}

/// Rubs to and fro, stands still between, and keeps the tool as it was held; or leans on the wall and slides
/// it up and down.
class Rubbing final : public mechanisms::HandStrategy {
public:
    Rubbing(const Way& way, bool presses) : m_way(way), m_presses(presses) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        if (!m_begun)
            m_q_DT = seen.q_DT;
        m_begun = true;
        const double t = std::max(0.0, seen.time_s - kArming_s), cycle = kPeriod_s + kRest_s;
        const double moving = t - cycle * std::floor(t / cycle);
        const double phase = 2.0 * core::kPi * std::min(1.0, moving / kPeriod_s);
        const double x = m_presses ? kPressed_m * (0.75 - 0.25 * std::cos(phase)) * std::min(1.0, t)
                                   : kAmplitude_m * std::sin(phase);
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = m_way.start_D + x * m_way.along_D;
        wanted.q_DDesired = m_q_DT;
        return wanted;
    }

private:
    Way m_way;
    bool m_presses;
    bool m_begun = false;
    core::Quat m_q_DT = core::Quat::Identity();
};

/// W is D. A force of a micronewton stays, so that standing still is no change of contact.
class BenchScene final : public simulation::IScene {
public:
    BenchScene(const BenchCase& wanted, const Way& way) : m_case(wanted), m_way(way) {}
    void respond(const realtime::HapticTick&, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        out = simulation::SceneOutput{};
        out.tissue.count = in.tools.count;
        out.phase = core::TrialPhase::running;
        if (in.tools.count == 0)
            return;
        const Vec3 from = in.tools.tools[0].p_WT - m_way.start_D, v = in.tools.tools[0].v_WT;
        const double b = std::min(m_case.damping_Ns_per_m, in.dampingBudget_Ns_per_m[0]);
        Vec3 force(1e-6, 0.0, 0.0);
        switch (m_case.load) {
        case BenchLoad::viscous:
            force -= b * v;
            break;
        case BenchLoad::friction:
            force += friction(v, b);
            break;
        case BenchLoad::both:
            force += friction(v, 0.5 * b) - 0.5 * b * v;
            break;
        case BenchLoad::canal: {
            const Vec3 along = v.dot(m_way.along_D) * m_way.along_D;
            const Vec3 off = from - from.dot(m_way.along_D) * m_way.along_D;
            force += friction(along, 0.5 * b) - 0.5 * b * along - kAcross_N_per_m * off -
                     b * (v - along); // the wall damps across it
            out.storedEnergy_J = 0.5 * kAcross_N_per_m * off.squaredNorm();
            out.contactStiffness_N_per_m = kAcross_N_per_m;
            break;
        }
        case BenchLoad::wall: {
            const double depth = from.dot(m_way.along_D), weight = std::clamp(depth / 0.0005, 0.0, 1.0);
            if (depth > 0.0)
                force -=
                    std::max(0.0, kWall_N_per_m * depth + b * weight * v.dot(m_way.along_D)) * m_way.along_D;
            out.storedEnergy_J = depth > 0.0 ? 0.5 * kWall_N_per_m * depth * depth : 0.0;
            out.contactStiffness_N_per_m = depth > 0.0 ? kWall_N_per_m : 0.0;
            break;
        }
        }
        out.damping_Ns_per_m[0] = b;
        out.tissue.tools[0].force = force;
    }

private:
    static Vec3 friction(const Vec3& v, double slope) noexcept {
        const double v0 = kFriction_N / slope;
        return -kFriction_N / std::sqrt(v.squaredNorm() + v0 * v0) * v;
    }
    BenchCase m_case;
    Way m_way;
};

class Witness final : public core::IFrameSink {
public:
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        fast.add(frame);
        const auto& f = frame.tool[0].commanded;
        largest_N = std::max(largest_N, std::hypot(f[0], f[1], f[2]));
        injected += (frame.header.guards & core::guard_bits::kPassivity) != 0 ? 1 : 0;
        return true;
    }
    FastForce fast;
    double largest_N = 0.0;
    std::uint64_t injected = 0;
};

std::unique_ptr<devices::IDevice> deviceOf(const std::string& mechanism, const Way& way,
                                           const std::string& hand, std::uint64_t seed,
                                           std::unique_ptr<mechanisms::HandStrategy> strategy) {
    if (isFiveBar(mechanism)) {
        devices::SimulatedEndoscopeDevice::Configuration configuration;
        configuration.hand = *handNamed(hand);
        configuration.start_D = way.start_D;
        configuration.seed = seed;
        return std::move(*devices::SimulatedEndoscopeDevice::create(configuration, std::move(strategy)));
    }
    if (mechanism == "fingertip_arm") {
        devices::SimulatedFingertipDevice::Configuration configuration;
        configuration.hand = *handNamed(hand);
        configuration.start_D = way.start_D;
        configuration.seed = seed;
        return std::move(*devices::SimulatedFingertipDevice::create(configuration, std::move(strategy)));
    }
    devices::SimulatedDevice::Configuration configuration;
    configuration.hand = *handNamed(hand);
    configuration.start_D = way.start_D;
    configuration.seed = seed;
    return std::move(*devices::SimulatedDevice::create(configuration, std::move(strategy)));
}

} // namespace

std::vector<std::string> benchMechanisms() {
    return {"five_bar_spherical", "gimbal_hprd", "fingertip_arm"};
}
std::vector<std::string> benchHands() {
    return namedHands();
}
std::vector<BenchLoad> benchLoads() {
    return {BenchLoad::viscous, BenchLoad::friction, BenchLoad::both, BenchLoad::canal, BenchLoad::wall};
}

std::string nameOf(BenchLoad load) {
    constexpr std::array<const char*, 5> kNames{"viscous", "friction", "both", "canal", "wall"};
    return kNames[static_cast<std::size_t>(load)];
}

double budgetOf(const std::string& mechanism) {
    const Way way = wayOf(mechanism, 0);
    return deviceOf(mechanism, way, "usual", 1, std::make_unique<Rubbing>(way, false))
        ->descriptor()
        .maximumDamping_Ns_per_m;
}

BenchResult runBench(const BenchCase& wanted) {
    const Way way = wayOf(wanted.mechanism, wanted.pose);
    auto device = deviceOf(wanted.mechanism, way, wanted.hand, wanted.seed,
                           std::make_unique<Rubbing>(way, wanted.load == BenchLoad::wall));
    if (wanted.budget_Ns_per_m > 0.0)
        device = std::make_unique<WithBudget>(std::move(device), wanted.budget_Ns_per_m);
    (void)device->open();
    const std::array<haptics::LoopTool, 1> tools{haptics::LoopTool{*device, {}}};
    Witness witness;
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene = std::make_unique<BenchScene>(wanted, way);
    scenes.offer(scene);
    auto loop = std::move(*haptics::HapticLoop::create({tools, inputs, supervisor, {}, scenes, witness}));
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    for (std::int64_t n = 0; n < static_cast<std::int64_t>(1000.0 * wanted.seconds); ++n)
        (void)loop->tick(ticks.next(n * 1'000'000));
    return {witness.fast.worst_N(), witness.largest_N, witness.fast.windows(), witness.injected};
}

} // namespace chiron::tests
