// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "session/live_sample.h"
#include "simulation/palpation/surface_map.h"

#include <span>

namespace chiron::desktop {

/// The live map: where the fingers pressed in the current trial, from every sample of the loop.
/// Thread: GUI.
class PalpationMap {
public:
    explicit PalpationMap(const simulation::PalpationParameters& level)
        : m_map(level.areaHalf_m, level.tissue.contactRadius_m, level.coverForce_N) {}

    /// Adds the samples since the previous frame, which belong to `trial`. A new trial starts with an empty
    /// map.
    void take(int trial, std::span<const session::LiveSample> samples);
    const simulation::SurfaceMap& map() const noexcept { return m_map; }

private:
    simulation::SurfaceMap m_map;
    int m_trial = -1;
};

} // namespace chiron::desktop
