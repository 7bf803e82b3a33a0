// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"
#include "core/units.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "modules/exercises/urethra_insertion/cues/procedure_stage.h"

#include <cmath>

namespace chiron::scene3d::samples {

/// The parameters' defaults, five landmarks, everything shown.
inline SceneSetup urethraSetup() {
    simulation::UrethraInsertionParameters p;
    p.landmarks = {{"dome", 0.349, -1.571},
                   {"left_wall", 1.5, 3.0},
                   {"right_wall", 1.5, 0.15},
                   {"left_ureter", 1.012, -2.094},
                   {"right_ureter", 1.012, -1.047}};
    SceneSetup setup;
    setup.exercise = "urethra_insertion";
    setup.parameters = p;
    setup.cues = {.tool = true, .arrow = true, .object = true, .overview = true, .guidance = true};
    setup.family = QStringLiteral("Inter");
    return setup;
}

/// The tip at arc length s, beside the centre-line by e (x̂, n), looking along the canal, then turned up by
/// `pitch_rad` (about x̂) and to the side by `yaw_rad`, y of the picture towards the concave side.
struct ScopePose {
    double s_m = 0.0;
    double ex_m = 0.0;
    double en_m = 0.0;
    double pitch_rad = 0.0;
    double yaw_rad = 0.0;
    double roll_rad = 0.0;
};

inline SceneState urethraState(const SceneSetup& setup, const ScopePose& pose) {
    const auto& p = setup.parameters.as<simulation::UrethraInsertionParameters>();
    const simulation::UrethraCentreline line(p.anatomy);
    const simulation::CentrelinePoint at = line.at(pose.s_m);
    SceneState state;
    state.objectShown = true;
    ToolView& tool = state.tool[0];
    tool.present = true;
    const core::Vec3 p_A = at.p_A + pose.ex_m * core::Vec3::UnitX() + pose.en_m * at.n_A;
    tool.p_WT = tool.p_WProxy = p.pose.pointToW(p_A);
    // Columns x right, y up, z back: the view is along t, up is n, right = t × n.
    core::Mat3 axes;
    axes << at.t_A.cross(at.n_A), at.n_A, -at.t_A;
    using Turn = Eigen::AngleAxisd;
    const core::Mat3 turned = axes * Turn(pose.yaw_rad, core::Vec3::UnitY()).toRotationMatrix() *
                              Turn(pose.pitch_rad, core::Vec3::UnitX()).toRotationMatrix() *
                              Turn(pose.roll_rad, core::Vec3::UnitZ()).toRotationMatrix();
    tool.q_WT = p.pose.q_WA * core::Quat(turned);
    state.exercise.own<simulation::EndoscopeCues>().present = true;
    state.exercise.own<simulation::EndoscopeCues>().pictureShown = true;
    state.exercise.own<simulation::EndoscopeCues>().depth_m = pose.s_m;
    state.exercise.own<simulation::EndoscopeCues>().landmarks = int(p.landmarks.size());
    // The middle of the lumen 15 mm ahead.
    const core::Vec3 ahead = line.at(pose.s_m + 0.015).p_A - p_A;
    const core::Vec3 seen = turned.transpose() * ahead;
    state.exercise.own<simulation::EndoscopeCues>().lumenDistance_m = ahead.norm();
    for (int k = 0; k < 3; ++k)
        state.exercise.own<simulation::EndoscopeCues>().toLumen_T[std::size_t(k)] = seen[k] / ahead.norm();
    state.exercise.own<simulation::EndoscopeCues>().guided = setup.cues.guidance;
    state.exercise.own<simulation::EndoscopeCues>().stage = pose.s_m > line.length_m()
                                                                ? simulation::ProcedureStage::inspection
                                                                : simulation::ProcedureStage::insertion;
    return state;
}

} // namespace chiron::scene3d::samples
