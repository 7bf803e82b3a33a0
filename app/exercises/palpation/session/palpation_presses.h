// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "simulation/palpation/surface_map.h"
#include "simulation/palpation/tissue_surface.h"

#include <array>
#include <cstddef>
#include <optional>

namespace chiron::session {

/// Builds the map of what was pressed from recorded poses and forces of the fingers. A press is entered at
/// the surface point nearest to the finger, which is the scene's own contact point under the contact law
/// `anchored`, but not under `p3_recast` (whose contact point is the ray's). Use one object per trial.
/// Unit: m, N.
/// Frame: W.
class PalpationPresses {
public:
    explicit PalpationPresses(const simulation::PalpationParameters& level)
        : m_surface(level.tissue.shape),
          m_map(level.areaHalf_m, level.tissue.contactRadius_m, level.coverForce_N) {}

    void press(std::size_t finger, const core::Vec3& p_WT, const core::Vec3& tissue_N) {
        if (finger >= m_guess_m.size() || !p_WT.allFinite() || !tissue_N.allFinite())
            return;
        // In the air: the search for the next contact starts below the finger.
        if (tissue_N.squaredNorm() == 0.0) {
            m_guess_m[finger].reset();
            return;
        }
        const auto foot = m_surface.nearest(p_WT, m_guess_m[finger].value_or(p_WT.head<2>()));
        m_guess_m[finger] = foot.p_W.head<2>();
        if (foot.depth_m > 0.0)
            m_map.press(foot.p_W.head<2>(), tissue_N.dot(foot.normal));
    }
    const simulation::SurfaceMap& map() const noexcept { return m_map; }

private:
    simulation::TissueSurface m_surface;
    simulation::SurfaceMap m_map;
    std::array<std::optional<core::Vec2>, core::kMaxTools> m_guess_m; ///< last contact point of each finger
};

} // namespace chiron::session
