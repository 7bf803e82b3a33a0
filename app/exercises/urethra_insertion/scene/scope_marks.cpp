// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/scope_marks.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

/// The position in the picture; far outside if the point lies beside or behind the camera.
core::Vec2 placeInView(const core::Vec3& way_T, double fieldOfView_rad) {
    const double ahead = -way_T.z();
    const double wide = std::tan(0.5 * fieldOfView_rad);
    const core::Vec2 place =
        ahead > 1e-3 ? core::Vec2(way_T.head<2>() / (ahead * wide)) : core::Vec2(1e3 * way_T.head<2>());
    return place.norm() < 1e6 ? place : core::Vec2(0.0, 1e3);
}

core::Vec2 withinRim(const core::Vec2& place) {
    return place.norm() > ScopeMarks::kRim ? core::Vec2(place * (ScopeMarks::kRim / place.norm())) : place;
}

/// The same direction as seen by an endoscope turned parallel to the canal at its tip.
core::Vec3 seenAligned(const core::Vec3& way_T, const UrethraDrawing& drawing, const ToolView& tool) {
    const core::Vec3 tip_A = drawing.parameters().pose.pointToA(tool.p_WT);
    const core::Vec3 along_T = drawing.axes_A(tool).transpose() * drawing.centreline().foot(tip_A).at.t_A;
    return core::Quat::FromTwoVectors(along_T, core::Vec3(0.0, 0.0, -1.0)) * way_T;
}

void addGuidance(ScopeMarks& marks, const simulation::EndoscopeCues& cues, const UrethraDrawing& drawing,
                 const ToolView& tool) {
    const core::Vec3 way(cues.toLumen_T[0], cues.toLumen_T[1], cues.toLumen_T[2]);
    marks.dwell = std::clamp(cues.dwell, 0.0, 1.0);
    // It is a unit vector, or zero if no lumen is visible.
    if (!(way.squaredNorm() > 0.25))
        return;
    marks.guided = true;
    const double field_rad = drawing.parameters().endoscope.fieldOfView_rad;
    const core::Vec2 place = placeInView(way, field_rad);
    const core::Vec2 target = placeInView(seenAligned(way, drawing, tool), field_rad);
    marks.beyond = place.norm() > 1.0;
    marks.aligned = (place - target).norm() < ScopeMarks::kAligned;
    marks.lumen = withinRim(place);
    marks.target = withinRim(target);
}

} // namespace

ScopeMarks ScopeMarks::of(const SceneSetup& setup, const UrethraDrawing& drawing, const SceneState& state) {
    ScopeMarks marks;
    const ToolView& tool = state.tool[0];
    marks.pictureShown = setup.cues.object && state.objectShown && tool.present;
    if (marks.pictureShown && setup.cues.guidance && state.exercise.of<simulation::EndoscopeCues>().guided)
        addGuidance(marks, state.exercise.of<simulation::EndoscopeCues>(), drawing, tool);
    if (!setup.cues.arrow || !tool.present || !(tool.force_N.norm() > kLeast_N))
        return marks;
    const core::Vec3 force_T =
        drawing.axes_A(tool).transpose() * drawing.parameters().pose.vectorToA(tool.force_N);
    const double across_N = force_T.head<2>().norm();
    marks.over = tool.force_N.norm() > setup.forceLimit_N;
    if (!(across_N > kLeast_N))
        return marks;
    marks.force = true;
    marks.forceWay = force_T.head<2>() / across_N;
    marks.forceShare = across_N / std::max(0.1, setup.forceLimit_N);
    return marks;
}

} // namespace chiron::scene3d
