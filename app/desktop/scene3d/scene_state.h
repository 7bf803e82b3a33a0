// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exercise_cues.h"
#include "core/geometry.h"
#include "core/haptic_frame.h"
#include "desktop/scene3d/scene_note.h"

#include <array>
#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// One tool as it is drawn.
/// Unit: m, N.
/// Frame: W (world).
struct ToolView {
    bool present = false;
    core::Vec3 p_WT = core::Vec3::Zero(); ///< the tip, where the hand is
    /// Where the scene wants it drawn: at the surface while in contact.
    core::Vec3 p_WProxy = core::Vec3::Zero();
    /// Orientation; the shaft leaves the tip along +z of T. As long as a tool has only reported the identity
    /// (a mouse has no orientation), its shaft is drawn through a fixed entry point instead.
    core::Quat q_WT = core::Quat::Identity();
    core::Vec3 force_N = core::Vec3::Zero(); ///< *tissue* force on the tool: every cue uses this one
    double jaw_rad = 0.0;
    /// Pseudo-haptics: the device renders no force, the drawn tool stays at the surface.
    bool drawnAtSurface = false;
};

/// The part of a scene that changes from frame to frame. Training makes it from haptics::DisplayState,
/// playback from a recording.
struct SceneState {
    std::array<ToolView, core::kMaxTools> tool{};
    ToolView ghost{};         ///< a second session's tool 0, drawn translucent
    bool objectShown = false; ///< the level shows it (or the trial is over and this is playback)
    /// sphere_apex: centre of the ball, in the plane; the apex is above it.
    core::Vec3 p_WObject = core::Vec3::Zero();
    /// Playback of a level with a decoy: where it lies (depth and width: SceneSetup).
    bool dimpleShown = false;
    core::Vec2 dimpleCentre_m = core::Vec2::Zero(); ///< x, y in W
    bool marked = false; ///< playback and feedback after a trial: the position of the person's mark
    core::Vec3 p_WMark = core::Vec3::Zero();
    bool answered = false; ///< feedback after a trial: where the mark should have been
    core::Vec3 p_WAnswer = core::Vec3::Zero();
    /// Playback: where tissue gave way, or an object came off its tool, in this trial up to the moment shown.
    std::vector<core::Vec3> p_WYielded;
    core::ExerciseCues exercise; ///< as the exercise's scene displayed it, or as recorded
    core::ExerciseCues overlay;  ///< added by the exercise's screens
    int activeTool = -1; ///< with several tools, the one that mouse and keyboard move; it has a collar
    SceneNote note;      ///< drawn over everything else
    double time_s = 0.0;
};

} // namespace chiron::scene3d
