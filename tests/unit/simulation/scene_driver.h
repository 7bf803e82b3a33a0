// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"

namespace chiron::simulation::testing {

using core::Vec3;

inline SphereApexParameters shortTrials(int trials = 3) {
    SphereApexParameters p;
    p.trials = trials;
    p.trialLimit_s = 0.050;
    p.betweenTrials_s = 0.020;
    p.cues = {"object", "tool"};
    return p;
}

/// Steps a scene as the loop does, with one tool that hovers unless told otherwise.
struct Driver {
    explicit Driver(const SphereApexParameters& parameters, std::uint64_t seed = 42)
        : scene(parameters, seed) {
        in.tools.count = 1;
        hover();
    }

    const SceneOutput& tick() {
        scene.respond(source.next(0), in, out);
        in.mark = false;
        return out;
    }
    void ticks(int n) {
        for (int i = 0; i < n; ++i)
            tick();
    }
    /// Into the first running tick of the first trial.
    void startRunning() {
        in.started = true;
        in.forceReady = true;
        ticks(2);
    }
    void hover() { in.tools.tools[0].p_WT = Vec3(0, 0, 0.05); }
    void pressApex(double depth_m) {
        const auto& c = scene.trials()[out.trial].centre_m;
        in.tools.tools[0].p_WT = Vec3(c.x(), c.y(), 0.020 - depth_m);
    }
    void button(bool down) { in.tools.tools[0].buttons = down ? core::kButtonMark : 0; }

    realtime::TickSource source;
    SphereApexScene scene;
    SceneInput in;
    SceneOutput out;
};

} // namespace chiron::simulation::testing
