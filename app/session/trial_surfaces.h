// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <optional>
#include <vector>

namespace chiron::session {

/// A lump below a surface that is palpated.
/// Unit: m.
/// Frame: W.
struct TrialLump {
    core::Vec3 p_WCentre = core::Vec3::Zero();
    core::Vec3 p_WAbove = core::Vec3::Zero(); ///< the surface point above it: the correct position of a mark
    double radius_m = 0.0;
    double reach_m = 0.0; ///< a mark within this distance of the point above it has found it
};

/// The object of one trial, as playback draws it: the truth from content and seed.
struct TrialObject {
    core::Vec3 p_WObject = core::Vec3::Zero(); ///< m; of a ball on the plane: its centre, in the plane
    double radius_m = 0.0;
    std::optional<core::Vec2> dimpleCentre_m; ///< x, y in W, if the level has a decoy
    double turn_rad = 0.0;                    ///< rotation of a meshed dome about the vertical
    std::vector<TrialLump> lumps{};           ///< the true ones (before a research control moved them)
};

/// The geometry that could be touched in each trial of a session, restored from its stored content and seed:
/// the same geometry as the felt one. Immutable.
/// Thread: any.
class TrialSurfaces {
public:
    TrialSurfaces() = default;
    TrialSurfaces(const TrialSurfaces&) = delete;
    TrialSurfaces& operator=(const TrialSurfaces&) = delete;
    virtual ~TrialSurfaces() = default;

    /// Empty for a trial that was not planned.
    virtual std::optional<TrialObject> object(int trial) const = 0;
    /// The drawn position of a tool that stays at the surface, m in W; equal to `p_WT` out of contact and
    /// without an object.
    virtual core::Vec3 surfacePoint(int trial, const core::Vec3& p_WT) const = 0;
};

} // namespace chiron::session
