// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"

#include <algorithm>

namespace chiron::simulation::testing {

using core::Vec3;

inline ElasticTubeParameters tubeExercise(TubeTask task) {
    ElasticTubeParameters p;
    p.task = task;
    p.tube.stiffness_N_per_m = 60.0;
    p.tube.viscosity_Ns_per_m = 0.2;
    p.trials = 2;
    p.trialLimit_s = 20.0;
    p.betweenTrials_s = 0.5;
    p.hold_s = 0.5;
    p.cues = {"object", "tool", "bars"};
    return p;
}

/// Steps a scene as the loop does, with ideal hands: a tip moves straight to where it is wanted at a speed,
/// velocity and all.
struct TubeDriver {
    static constexpr double kOpen_rad = 0.7;

    explicit TubeDriver(const ElasticTubeParameters& parameters, std::uint64_t seed = 42)
        : p(parameters), scene(parameters, seed) {
        in.tools.count = parameters.tools();
        for (core::ToolState& tool : in.tools.tools) {
            tool.p_WT = Vec3(0.0, 0.0, 0.09);
            tool.jaw_rad = kOpen_rad;
        }
    }

    const SceneOutput& tick() {
        before = out;
        scene.respond(source.next(0), in, out);
        events |= out.events;
        for (int i = 0; i < in.tools.count; ++i)
            largestStep_N = std::max(largestStep_N, (out.tissue.tools[static_cast<std::size_t>(i)].force -
                                                     before.tissue.tools[static_cast<std::size_t>(i)].force)
                                                        .norm());
        return out;
    }
    void ticks(int n) {
        for (int i = 0; i < n; ++i)
            tick();
    }
    /// Into the first running tick of the first trial.
    void startRunning() {
        in.started = in.forceReady = true;
        ticks(2);
    }
    core::ToolState& tool(int i) { return in.tools.tools[static_cast<std::size_t>(i)]; }
    Vec3 place(int node) const {
        const auto& at =
            out.cues.exercise.of<core::LaparoscopyCues>().p_WGrip[static_cast<std::size_t>(node)];
        return {at[0], at[1], at[2]};
    }
    Vec3 force(int i) const { return out.tissue.tools[static_cast<std::size_t>(i)].force; }
    double quantity(TubeQuantity which) const { return out.quantities[static_cast<std::size_t>(which)]; }
    core::LaparoscopyStep step() const {
        return static_cast<core::LaparoscopyStep>(quantity(TubeQuantity::step));
    }

    /// Straight there at `speed_m_per_s`, then still.
    void moveTo(int i, const Vec3& goal, double speed_m_per_s = 0.05) {
        core::ToolState& moved = tool(i);
        const Vec3 way = goal - moved.p_WT;
        const int n =
            std::max(1, static_cast<int>(std::ceil(way.norm() / (speed_m_per_s * core::kTickSeconds))));
        for (int k = 0; k < n; ++k) {
            moved.p_WT += way / n;
            moved.v_WT = way / (n * core::kTickSeconds);
            tick();
        }
        moved.v_WT.setZero();
        tick();
    }
    void close(int i) {
        tool(i).jaw_rad = 0.05;
        tick();
    }
    void open(int i) {
        tool(i).jaw_rad = kOpen_rad;
        tick();
    }
    /// Goes to a place of the tube (by `off` beside it) and closes on it.
    void grasp(int i, int node, const Vec3& off = Vec3::Zero()) {
        tool(i).p_WT = place(node) + off;
        tool(i).v_WT.setZero();
        tick();
        close(i);
    }

    ElasticTubeParameters p;
    ElasticTubeScene scene;
    realtime::TickSource source;
    SceneInput in;
    SceneOutput out;
    SceneOutput before;
    std::uint32_t events = 0;
    double largestStep_N = 0.0; ///< of a tool's force from tick to tick
};

} // namespace chiron::simulation::testing
