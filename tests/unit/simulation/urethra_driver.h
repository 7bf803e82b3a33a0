// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/urethra_bench.h"

namespace chiron::simulation::testing {

/// Steps a scene as the loop does.
struct UrethraDriver {
    explicit UrethraDriver(const UrethraInsertionParameters& parameters) : p(parameters), scene(parameters) {
        in.tools.count = 1;
        in.tools.tools[0] = tests::onTheLine(p, -0.030);
    }
    const SceneOutput& tick() {
        scene.respond(source.next(0), in, out);
        return out;
    }
    void ticks(int n) {
        for (int i = 0; i < n; ++i)
            tick();
    }
    void startRunning() {
        in.started = true;
        in.forceReady = true;
        ticks(2);
    }
    /// Held for a while at s, so that nothing moves.
    const SceneOutput& at(double s_m, int n = 1) {
        in.tools.tools[0] = tests::onTheLine(p, s_m);
        ticks(n);
        return out;
    }
    core::ToolState& tool() { return in.tools.tools[0]; }

    UrethraInsertionParameters p;
    realtime::TickSource source;
    UrethraInsertionScene scene;
    SceneInput in;
    SceneOutput out;
};

inline double norm(const core::Wrench& w) {
    return w.force.norm() + w.torque.norm();
}

inline core::Vec3 vectorOf(const std::array<double, 3>& a) {
    return {a[0], a[1], a[2]};
}

} // namespace chiron::simulation::testing
