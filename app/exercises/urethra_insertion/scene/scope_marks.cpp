// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/scope_marks.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

void addGuidance(ScopeMarks& marks, const simulation::EndoscopeCues& cues, double fieldOfView_rad) {
    const core::Vec3 way(cues.toLumen_T[0], cues.toLumen_T[1], cues.toLumen_T[2]);
    marks.dwell = std::clamp(cues.dwell, 0.0, 1.0);
    if (!(way.squaredNorm() > 0.25)) // a unit vector, or zero where no lumen is seen
        return;
    marks.guided = true;
    const double ahead = -way.z();
    const double wide = std::tan(0.5 * fieldOfView_rad);
    core::Vec2 place = ahead > 1e-3 ? core::Vec2(way.head<2>() / (ahead * wide)) : core::Vec2(1e3 * way.head<2>());
    if (!(place.norm() < 1e6))
        place = core::Vec2(0.0, 1e3);
    marks.beyond = place.norm() > 1.0;
    marks.aligned = place.norm() < ScopeMarks::kAligned;
    if (place.norm() > ScopeMarks::kRim)
        place *= ScopeMarks::kRim / place.norm();
    marks.lumen = place;
}

} // namespace

ScopeMarks ScopeMarks::of(const SceneSetup& setup, const UrethraDrawing& drawing, const SceneState& state) {
    ScopeMarks marks;
    const ToolView& tool = state.tool[0];
    marks.pictureShown = setup.cues.object && state.objectShown && tool.present;
    if (marks.pictureShown && setup.cues.guidance && state.exercise.of<simulation::EndoscopeCues>().guided)
        addGuidance(marks, state.exercise.of<simulation::EndoscopeCues>(), drawing.parameters().endoscope.fieldOfView_rad);
    if (!setup.cues.arrow || !tool.present || !(tool.force_N.norm() > kLeast_N))
        return marks;
    const core::Vec3 force_T = drawing.axes_A(tool).transpose() * drawing.parameters().pose.vectorToA(tool.force_N);
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
