// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "cues/laparoscopy_cues.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <optional>

namespace chiron::scene3d {

/// The ring that marks a tube's target: the tube's end has to reach it.
struct MarkRing {
    core::Vec3 p_W = core::Vec3::Zero();
    core::Vec3 along = core::Vec3::UnitZ(); ///< unit vector of the axis
    double radius_m = 0.0;
    bool foot = false; ///< the ring is at a fixed place: a line to the floor shows above which point
};

/// The target's place from the cues. In the task "to the mark" the ring follows the tube's direction at the
/// distance from the base that the mark specifies, and is twice as thick as the tube. Empty if the level
/// shows no mark. Pure function.
inline std::optional<MarkRing> markRing(const simulation::ElasticTubeParameters& parameters,
                                        const core::LaparoscopyCues& cues) {
    if (!cues.present || !cues.objectShown)
        return std::nullopt;
    MarkRing ring;
    if (parameters.task != simulation::TubeTask::stretch) {
        if (!cues.targetShown)
            return std::nullopt;
        ring.p_W = {cues.p_WTarget[0], cues.p_WTarget[1], cues.p_WTarget[2]};
        ring.radius_m = cues.targetRadius_m;
        ring.along = core::Vec3(0.0, -0.72, 0.69); // towards the viewer
        ring.foot = true;
        return ring;
    }
    if (cues.grips < 2 || cues.torn)
        return std::nullopt;
    const auto last = static_cast<std::size_t>(cues.grips - 1);
    const core::Vec3 base(cues.p_WGrip[0][0], cues.p_WGrip[0][1], cues.p_WGrip[0][2]);
    const core::Vec3 way =
        core::Vec3(cues.p_WGrip[last][0], cues.p_WGrip[last][1], cues.p_WGrip[last][2]) - base;
    // While nobody holds the end, the mark is vertically above the base.
    ring.along = cues.gripHeldBy[last] != 0 && way.norm() > 0.3 * cues.restLength_m
                     ? core::Vec3(way.normalized())
                     : core::Vec3(core::Vec3::UnitZ());
    ring.p_W = base + parameters.markRatio * cues.restLength_m * ring.along;
    ring.radius_m = 2.0 * parameters.radius_m;
    return ring;
}

} // namespace chiron::scene3d
