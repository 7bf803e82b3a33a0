// SPDX-License-Identifier: GPL-3.0-or-later
// States of every scene: what the tools beside take pictures of, and what test_kept_scenes holds against what
// was looked at.
#pragma once

#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "cues/laparoscopy_cues.h"
#include "gui/scene3d/laparoscopy_samples.h"
#include "gui/scene3d/palpation_samples.h"
#include "gui/scene3d/scene_samples.h"
#include "gui/scene3d/urethra_samples.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "simulation/geometry/mesh/mesh_source.h"
#include "simulation/palpation/tissue_pinch.h"

#include <QString>
#include <list>
#include <map>

namespace chiron::scene3d::samples {

/// A state of a scene to be drawn.
struct Picture {
    const char* name;
    SceneSetup setup;
    SceneState state;
    simulation::SurfaceMap map;
    bool mapShown = false;
};

// ---- a sphere ----
inline std::map<QString, SceneState> apexStates() {
    std::map<QString, SceneState> all;
    all["air"] = inAir();
    all["contact"] = pressed(2.0);
    all["over"] = pressed(5.2);
    all["pseudo"] = pressed(3.0);
    all["pseudo"].tool[0].drawnAtSurface = true;
    all["hidden"] = inAir();
    all["hidden"].objectShown = false;
    all["playback"] = pressed(1.2);
    all["playback"].marked = true;
    all["playback"].p_WMark = {0.017, 0.003, 0.019};
    all["playback"].ghost = inAir().tool[0];
    all["playback"].ghost.p_WT = {-0.022, -0.025, 0.012};
    all["playback"].ghost.q_WT = chiron::core::Quat(Eigen::AngleAxisd(-0.25, chiron::core::Vec3::UnitY()));
    all["z_turned"] = inAir();
    all["z_turned"].tool[0].q_WT = chiron::core::Quat(Eigen::AngleAxisd(0.3, chiron::core::Vec3::UnitX()));
    all["z_turned"].tool[0].jaw_rad = 0.6;
    all["z_turned"].tool[1] = all["z_turned"].tool[0];
    all["z_turned"].tool[1].p_WT = {0.05, -0.03, 0.02};
    all["z_turned"].tool[1].q_WT = chiron::core::Quat(Eigen::AngleAxisd(0.3, chiron::core::Vec3(0, 1, 0)));
    all["dimple"] = all["air"];
    all["dimple"].dimpleShown = true;
    all["dimple"].dimpleCentre_m = {0.006, -0.002};
    all["plane"] = inAir();
    all["plane"].tool[0].p_WT = {-0.030, -0.030, -0.006};
    all["plane"].tool[0].p_WProxy = {-0.030, -0.030, 0.0};
    all["plane"].tool[0].force_N = {0.0, 0.0, 3.0};
    all["rim"] = inAir();
    all["rim"].tool[0].p_WT = {0.026, -0.004, 0.003};
    all["rim"].tool[0].force_N = {1.5, -1.2, 0.3};
    return all;
}

// ---- palpation ----
inline Picture visibleLump() {
    Picture picture{"pad_visible", palpationSetup(Tissue::pad), {}, {}, true};
    addLump(picture.state, picture.setup, {0.012, 0.010}, 0.012, 0.0075, false);
    pressFinger(picture.state, picture.setup, 0, {0.004, 0.004}, 0.004, {-0.5, -0.2});
    picture.map = searched(picture.setup, 0.45);
    return picture;
}

inline Picture pinched() {
    Picture picture{"pad_pinch", palpationSetup(Tissue::pad), {}, {}, false};
    picture.setup.parameters.as<simulation::PalpationParameters>().pinch = simulation::PinchParameters{};
    pressFinger(picture.state, picture.setup, 0, {0.004, 0.004}, 0.004);
    picture.state.tool[0].jaw_rad = 0.8;
    return picture;
}

inline Picture hiddenLumps() {
    Picture picture{"pad_hidden", palpationSetup(Tissue::pad), {}, {}, false};
    pressFinger(picture.state, picture.setup, 0, {-0.016, 0.012}, -0.012);
    addFinding(picture.state, picture.setup, 0, {0.018, 0.014}, simulation::FindingOutcome::open);
    return picture;
}

inline Picture prostateFelt() {
    Picture picture{"prostate", palpationSetup(Tissue::prostate), {}, {}, false};
    pressFinger(picture.state, picture.setup, 0, {0.011, -0.002}, 0.0035, {0.7, 1.3});
    addFinding(picture.state, picture.setup, 0, {-0.013, 0.006}, simulation::FindingOutcome::open);
    return picture;
}

inline Picture twoFingers() {
    Picture picture{"breast_two_hands", palpationSetup(Tissue::breast, 2), {}, {}, false};
    pressFinger(picture.state, picture.setup, 0, {0.022, -0.004}, 0.005, {0.3, 0.3});
    pressFinger(picture.state, picture.setup, 1, {-0.020, 0.006}, 0.004, {-0.3, 0.1});
    picture.state.activeTool = 0;
    addFinding(picture.state, picture.setup, 0, {-0.008, 0.026}, simulation::FindingOutcome::open);
    return picture;
}

inline Picture fingerPattern() {
    Picture picture{"breast_pattern", palpationSetup(Tissue::breast, 1, 2), {}, {}, true};
    pressFinger(picture.state, picture.setup, 0, {0.004, -0.006}, 0.005, {0.2, 0.2});
    pressFinger(picture.state, picture.setup, 1, {-0.014, -0.006}, 0.005, {0.1, 0.2});
    picture.map = searched(picture.setup, 0.6);
    return picture;
}

inline Picture playedBack(simulation::SurfaceMapKind kind) {
    Picture picture{kind == simulation::SurfaceMapKind::force ? "playback_force" : "playback_coverage",
                    palpationSetup(Tissue::breast, 2),
                    {},
                    {},
                    true};
    picture.state.overlay.own<PalpationOverlay>().mapKind = kind;
    addLump(picture.state, picture.setup, {-0.020, 0.016}, 0.012, 0.0075, false);
    addLump(picture.state, picture.setup, {0.022, -0.014}, 0.010, 0.005, true);
    addFinding(picture.state, picture.setup, 0, {-0.017, 0.019}, simulation::FindingOutcome::hit);
    addFinding(picture.state, picture.setup, 1, {0.014, 0.024}, simulation::FindingOutcome::falseAlarm);
    picture.map = searched(picture.setup, 0.8);
    return picture;
}

inline Picture fingerShown() {
    Picture picture{"pad_pseudo", palpationSetup(Tissue::pad), {}, {}, false};
    pressFinger(picture.state, picture.setup, 0, {0.0, 0.0}, 0.009);
    picture.state.tool[0].drawnAtSurface = true;
    picture.state.ghost = picture.state.tool[0];
    picture.state.ghost.p_WProxy = picture.state.ghost.p_WT = {0.022, 0.012, 0.004};
    return picture;
}

inline std::list<Picture> palpationPictures() {
    return {visibleLump(),
            pinched(),
            hiddenLumps(),
            prostateFelt(),
            twoFingers(),
            fingerPattern(),
            playedBack(simulation::SurfaceMapKind::coverage),
            playedBack(simulation::SurfaceMapKind::force),
            fingerShown()};
}

// ---- tube and ovaries ----
inline std::list<Picture> laparoscopyPictures() {
    SceneState torn = tubeState({0.030, -0.012, 0.078}, true);
    torn.exercise.own<core::LaparoscopyCues>().torn = true;
    torn.exercise.own<core::LaparoscopyCues>().tension_N = 0.0;
    torn.tool[0].force_N.setZero();
    SceneState mark = tubeState({0.020, -0.016, 0.046}, true);
    mark.exercise.own<core::LaparoscopyCues>().targetShown = true;
    SceneState squeezed = handlingState(true);
    squeezed.exercise.own<core::LaparoscopyCues>().squeeze_N[0] = 2.4;
    squeezed.exercise.own<core::LaparoscopyCues>().body[1].squeeze_m = 0.006;
    SceneSetup organ = handlingSetup();
    auto& bed = organ.parameters.as<simulation::ObjectHandlingParameters>();
    bed.organBed = true;
    bed.bedMesh.shape = simulation::MeshSource::Shape::ellipsoid;
    bed.bedMesh.halfAxisX_m = bed.bedMesh.halfAxisY_m = 0.090;
    bed.bedMesh.halfAxisZ_m = 0.014;
    bed.bedMesh.edge_m = 0.006;
    bed.bedMesh.bumpHeight_m = 0.0004;
    bed.bedMesh.bumpWavelength_m = 0.040;
    SceneState onOrgan = handlingState(false);
    for (int i = 0; i < 3; ++i)
        onOrgan.exercise.own<core::LaparoscopyCues>().body[std::size_t(i)].p_W[2] = 0.007;
    return {{"ovary_organ", organ, onOrgan, {}, false},
            {"tube_lying", tubeSetup(), tubeState({0.030, -0.022, 0.003}, false), {}, false},
            {"tube_slack", tubeSetup(), tubeState({0.016, -0.014, 0.024}, true), {}, false},
            {"tube_taut", tubeSetup(), tubeState({0.026, -0.016, 0.052}, true), {}, false},
            {"tube_mark", tubeSetup(simulation::TubeTask::stretch), mark, {}, false},
            {"tube_torn", tubeSetup(simulation::TubeTask::stretch), torn, {}, false},
            {"tube_two_handed", tubeSetup(simulation::TubeTask::twoHanded), twoHanded(0.064), {}, false},
            {"tube_two_slack", tubeSetup(simulation::TubeTask::twoHanded), twoHanded(0.034), {}, false},
            {"tube_fold", tubeSetup(simulation::TubeTask::twoHanded), behindAFold(false), {}, false},
            {"tube_fold_back", tubeSetup(simulation::TubeTask::twoHanded), behindAFold(true), {}, false},
            {"tube_transfer", tubeSetup(simulation::TubeTask::transfer), handOver(), {}, false},
            {"ovary_lying", handlingSetup(), handlingState(false), {}, false},
            {"ovary_carried", handlingSetup(), handlingState(true), {}, false},
            {"ovary_squeezed", handlingSetup(), squeezed, {}, false}};
}

// ---- the urethra ----
/// With the shape that the levels have: straight to B, then the bend.
inline SceneSetup shippedCanal() {
    SceneSetup setup = urethraSetup();
    auto& anatomy = setup.parameters.as<simulation::UrethraInsertionParameters>().anatomy;
    anatomy.straight_m = 0.035;
    anatomy.zEnd_m = 0.100;
    anatomy.pivotSpan_m = 0.020;
    return setup;
}

struct UrethraPicture {
    SceneSetup setup = shippedCanal();
    SceneState state;
};

inline UrethraPicture urethraPicture(const ScopePose& pose, bool depthOfField = false) {
    UrethraPicture made;
    made.setup.depthOfField = depthOfField;
    made.state = urethraState(made.setup, pose);
    return made;
}

inline std::map<QString, UrethraPicture> urethraPictures() {
    constexpr double kDegree = core::kPi / 180.0;
    std::map<QString, UrethraPicture> all;
    all["a_entrance"] = urethraPicture({.s_m = 0.0005});
    all["a_before"] = urethraPicture({.s_m = -0.012});
    all["b_up"] = urethraPicture({.s_m = 0.030, .pitch_rad = 14 * kDegree});
    all["c_left"] = urethraPicture({.s_m = 0.030, .yaw_rad = 14 * kDegree});
    all["d_middle"] = urethraPicture({.s_m = 0.060});
    all["d_middle_focus"] = urethraPicture({.s_m = 0.060}, true);
    all["e_offset"] = urethraPicture({.s_m = 0.080, .ex_m = 0.002, .en_m = -0.002, .pitch_rad = -0.15});
    all["e_offset"].state.tool[0].force_N = {0.8, -0.6, 1.4};
    all["f_neck"] = urethraPicture({.s_m = 0.132});
    all["g_bladder"] = urethraPicture({.s_m = 0.152});
    all["g_bladder_focus"] = urethraPicture({.s_m = 0.152}, true);
    all["h_ureters"] = urethraPicture({.s_m = 0.160, .pitch_rad = -45 * kDegree});
    all["h_ureters_focus"] = urethraPicture({.s_m = 0.160, .pitch_rad = -45 * kDegree}, true);
    all["i_seen"] = all["h_ureters"];
    all["i_seen"].state.exercise.own<simulation::EndoscopeCues>().landmarksSeen = 1U << 3;
    all["i_seen"].state.exercise.own<simulation::EndoscopeCues>().dwell = 0.6;
    all["i_seen"].state.exercise.own<simulation::EndoscopeCues>().toLumen_T = {};
    all["j_over"] = all["e_offset"];
    all["j_over"].state.tool[0].force_N = {3.4, -2.6, 2.4};
    all["k_off"] = all["d_middle"];
    all["k_off"].setup.cues.object = false;
    all["l_unguided"] = all["d_middle"];
    all["l_unguided"].setup.cues = {.tool = true, .arrow = false, .object = true};
    all["m_dark"] = all["e_offset"];
    all["m_dark"].setup.colours = dark();
    return all;
}

} // namespace chiron::scene3d::samples
