// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/drivers/simulated/simulated_device.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "haptics/safety_supervisor.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// A whole sphere-apex session of a scripted trainee through the real loop, scene and supervisor, as fast as
/// it runs, with the ways of deceiving it that the blind tests need.
namespace chiron::support {

/// What stands between the scene and the trainee.
struct ApexDeception {
    bool mute = false;                     ///< the force channel is zero
    bool mirrored = false;                 ///< the field is turned by 180° about the workspace's middle
    int delay_ticks = 0;                   ///< force comes this much later
    core::Vec2 shift = core::Vec2::Zero(); ///< the ball jumps by this ...
    double shiftAfter_s = 1e9;             ///< ... this long after its trial began
};

struct ApexTrialResult {
    core::Vec2 centre = core::Vec2::Zero(); ///< as planned (no deception), m
    core::Vec2 mark = core::Vec2::Zero();   ///< tool at the answer, m
    bool marked = false;                    ///< not timed out
    bool touching = false;                  ///< at the answer
    double time_s = 0.0;
    double maximumForce_N = 0.0; ///< tissue
    double error_percent(int axis, double radius_m = 0.020) const {
        return 100.0 * (mark - centre)[axis] / radius_m;
    }
    double meanAbsoluteError_percent() const {
        return 0.5 * (std::abs(error_percent(0)) + std::abs(error_percent(1)));
    }
};

class DeceivedScene final : public simulation::IScene {
public:
    DeceivedScene(const simulation::SphereApexParameters& parameters, std::uint64_t seed,
                  const ApexDeception& deception)
        : m_scene(parameters, seed), m_deception(deception),
          m_line(static_cast<std::size_t>(deception.delay_ticks) + 1) {}

    void respond(const realtime::HapticTick& now, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        m_ticks = m_running ? m_ticks + 1 : 0;
        const bool shifted = static_cast<double>(m_ticks) * 1e-3 > m_deception.shiftAfter_s;
        simulation::SceneInput seen = in;
        core::ToolState& tool = seen.tools.tools[0];
        const double sign = m_deception.mirrored ? -1.0 : 1.0;
        tool.p_WT.head<2>() *= sign;
        tool.v_WT.head<2>() *= sign;
        if (shifted)
            tool.p_WT.head<2>() -= sign * m_deception.shift;
        m_scene.respond(now, seen, out);
        out.tissue.tools[0].force.head<2>() *= sign;
        // What the supervisor knows of the contact goes with the force, or its damping would tell of the
        // ball.
        m_line[m_next] = {out.tissue.tools[0], out.storedEnergy_J, out.contactStiffness_N_per_m};
        m_next = (m_next + 1) % m_line.size();
        const Contact late = m_deception.mute ? Contact{} : m_line[m_next];
        out.tissue.tools[0] = late.wrench;
        out.storedEnergy_J = late.energy_J;
        out.contactStiffness_N_per_m = late.stiffness_N_per_m;
        m_running = out.phase == core::TrialPhase::running;
    }
    const simulation::SphereApexScene& scene() const { return m_scene; }

private:
    struct Contact {
        core::Wrench wrench;
        double energy_J = 0.0;
        double stiffness_N_per_m = 0.0;
    };
    simulation::SphereApexScene m_scene;
    ApexDeception m_deception;
    std::vector<Contact> m_line;
    std::size_t m_next = 0;
    std::uint64_t m_ticks = 0;
    bool m_running = false;
};

/// Reads the trials off the frames, as scoring does.
class ApexRecorder final : public core::IFrameSink {
public:
    ApexRecorder(const devices::IToolKinematics& kinematics, std::vector<simulation::SphereApexTrial> plan)
        : m_kinematics(kinematics), m_plan(std::move(plan)) {}
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        namespace bits = core::event_bits;
        if ((frame.header.events & bits::kTrialStarted) != 0) {
            m_now = {};
            m_ticks = 0;
        }
        ++m_ticks;
        ++m_total;
        const core::Wrench tissue = core::toWrench(frame.tool[0].tissue);
        m_now.maximumForce_N = std::max(m_now.maximumForce_N, tissue.force.norm());
        if ((frame.header.events & (bits::kMarked | bits::kTimedOut)) != 0) {
            core::DeviceSample sample;
            sample.counts = frame.tool[0].counts;
            m_now.mark = m_kinematics.pose(sample).p_WT.head<2>();
            m_now.centre = m_plan[frame.header.trial].centre_m;
            m_now.marked = (frame.header.events & bits::kMarked) != 0;
            m_now.touching = tissue.force.norm() > 0.0;
            m_now.time_s = static_cast<double>(m_ticks) * 1e-3;
            m_results.push_back(m_now);
        }
        for (std::int32_t count : frame.tool[0].counts)
            m_digest = (m_digest ^ static_cast<std::uint32_t>(count)) * 0x100000001b3ULL;
        return true;
    }
    const std::vector<ApexTrialResult>& results() const { return m_results; }
    std::uint64_t ticks() const { return m_total; }
    std::uint64_t digest() const { return m_digest; } ///< FNV over all counts: two runs alike

private:
    const devices::IToolKinematics& m_kinematics;
    std::vector<simulation::SphereApexTrial> m_plan;
    ApexTrialResult m_now;
    std::vector<ApexTrialResult> m_results;
    std::uint64_t m_ticks = 0;
    std::uint64_t m_total = 0;
    std::uint64_t m_digest = 0xcbf29ce484222325ULL;
};

struct ApexSession {
    std::string operatorName = "expert";
    std::uint64_t seed = 1;
    simulation::SphereApexParameters level; ///< defaults: level 2, haptics alone, k = 500 N/m, no friction
    ApexDeception deception;
};

struct ApexOutcome {
    std::vector<ApexTrialResult> trials;
    std::uint64_t ticks = 0;
    std::uint64_t digest = 0;
};

/// Empty trials when something could not be made.
inline ApexOutcome runApexSession(const ApexSession& session) {
    const auto settings = operators::sphereApexOperatorSettings(session.operatorName);
    if (!settings)
        return {};
    auto mind = operators::makeSphereApexOperator(*settings, session.seed);
    if (!mind)
        return {};
    devices::SimulatedDevice::Configuration configuration;
    configuration.hand = settings->hand;
    configuration.seed = session.seed;
    auto device = devices::SimulatedDevice::create(configuration, std::move(*mind));
    if (!device || !(*device)->open())
        return {};
    auto deceived = std::make_unique<DeceivedScene>(session.level, session.seed, session.deception);
    ApexRecorder recorder((*device)->kinematics(), deceived->scene().trials());
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene = std::move(deceived);
    scenes.offer(scene);
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    haptics::SafetySettings safety;
    safety.exerciseForce_N = session.level.maximumForce_N;
    const std::array<haptics::LoopTool, 1> tools{haptics::LoopTool{**device, {}}};
    auto loop = haptics::HapticLoop::create({tools, inputs, supervisor, safety, scenes, recorder});
    if (!loop)
        return {};
    inputs.post({core::CommandKind::start, 0});
    realtime::TickSource source;
    const std::uint64_t longest = 1'000'000;
    while (source.executed() < longest &&
           (*loop)->tick(source.next(static_cast<std::int64_t>(source.executed()) * 1'000'000)))
        ;
    return {recorder.results(), recorder.ticks(), recorder.digest()};
}

} // namespace chiron::support
