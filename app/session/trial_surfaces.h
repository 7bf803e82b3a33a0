// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <optional>
#include <vector>

namespace chiron::session {

/// A lump below a surface that is palpated. W, m.
struct TrialLump {
    core::Vec3 p_WCentre = core::Vec3::Zero();
    core::Vec3 p_WAbove = core::Vec3::Zero(); ///< the surface point above it: where a mark should be
    double radius_m = 0.0;
    double reach_m = 0.0; ///< a mark so near to the place above it has found it
};

/// The object of one trial, as playback draws it: what was true, from content and seed.
struct TrialObject {
    core::Vec3 p_WObject = core::Vec3::Zero(); ///< m; sphere_apex: centre of the ball, in the plane
    double radius_m = 0.0;
    std::optional<core::Vec2> dimpleCentre_m; ///< x, y in W, where the level has a decoy
    double turn_rad = 0.0; ///< of a meshed dome about the vertical
    std::vector<TrialLump> lumps{}; ///< palpation: what was to be found (before a control moved it)
};

/// What could be touched in each trial of a session, made again from its stored content and seed: the same geometry
/// that was felt. Immutable; any thread.
class TrialSurfaces {
public:
    TrialSurfaces() = default;
    TrialSurfaces(const TrialSurfaces&) = delete;
    TrialSurfaces& operator=(const TrialSurfaces&) = delete;
    virtual ~TrialSurfaces() = default;

    /// Nothing for a trial that was not planned.
    virtual std::optional<TrialObject> object(int trial) const = 0;
    /// Where a tool that stays at the surface is drawn, m in W; `p_WT` itself out of contact and without an object.
    virtual core::Vec3 surfacePoint(int trial, const core::Vec3& p_WT) const = 0;
};

} // namespace chiron::session
