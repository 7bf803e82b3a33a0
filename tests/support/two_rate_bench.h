// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"

#include <cmath>
#include <cstdint>

/// A slow model that is as late as a busy machine makes it, without a clock: stepped by the test, some ticks
/// after each request, now and then a whole period later.
namespace chiron::tests {

/// When a slow model answers: `tick()` once a tick, after the scene.
class LateModel {
public:
    LateModel(simulation::ISlowModel& model, std::uint64_t seed)
        : m_model(model), m_random(core::Random::stream(seed, "late")) {}

    void tick() {
        if (m_wait == 0) {
            ++m_answers;
            if (!m_model.step())
                return; // nothing was asked: it looks again in the next tick
            // 5 to 45 ticks of work and waiting; every fifth answer loses one to four periods
            m_wait = 5 + m_random.below(41) + (m_random.below(5) == 0 ? 33 * (1 + m_random.below(4)) : 0);
            return;
        }
        --m_wait;
    }

private:
    simulation::ISlowModel& m_model;
    core::Random m_random;
    std::uint64_t m_wait = 0;
    std::uint64_t m_answers = 0;
};

/// Level 6 in short: one soft dome in the middle of the workspace.
inline simulation::SphereApexParameters softDome() {
    simulation::SphereApexParameters p;
    p.surface = simulation::ApexSurface::organ;
    p.meshEdge_m = 0.002;
    p.centreDiscRadius_m = 0.0;
    p.stiffnessLow_N_per_m = p.stiffnessHigh_N_per_m = 600.0;
    p.trials = 1;
    return p;
}

} // namespace chiron::tests
