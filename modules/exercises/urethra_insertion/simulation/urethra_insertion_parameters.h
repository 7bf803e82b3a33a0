// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_surface.h"
#include "simulation/yield.h"

#include <string>
#include <vector>

namespace chiron::simulation {

/// Pose of the anatomy on the table: A in W. By default the patient lies on the back, and the plane of
/// symmetry is W's y–z plane: z_A = +y_W (into the patient, away from the trainee), y_A = +z_W (up),
/// x_A = −x_W.
struct AnatomyPose {
    core::Vec3 p_WA{0.0, -0.044, 0.0};
    core::Quat q_WA{0.0, 0.0, 0.7071067811865476, 0.7071067811865476}; ///< w, x, y, z

    core::Vec3 pointToA(const core::Vec3& p_W) const noexcept { return q_WA.conjugate() * (p_W - p_WA); }
    core::Vec3 pointToW(const core::Vec3& p_A) const noexcept { return p_WA + q_WA * p_A; }
    core::Vec3 vectorToA(const core::Vec3& v_W) const noexcept { return q_WA.conjugate() * v_W; }
    core::Vec3 vectorToW(const core::Vec3& v_A) const noexcept { return q_WA * v_A; }
};

/// A point on the bladder's wall, as seen from the bladder's centre: polar angle from t(C), azimuth about it
/// from x̂ towards n.
struct BladderLandmark {
    std::string id; ///< e.g. "right_ureter"; the screen supplies the displayed text
    double polar_rad = 0.0;
    double azimuth_rad = 0.0;
};

/// One level of urethra insertion (models.md §1), filled from content by the catalogue, which checks the
/// ranges.
/// Unit: SI.
struct UrethraInsertionParameters {
    UrethraAnatomy anatomy;
    Endoscope endoscope;
    UrethraForceSettings forces;
    UrethraMeshSettings mesh;
    AnatomyPose pose;

    std::string tissue = "normal"; ///< name of the preset, shown to people: normal, tight, stricture
    YieldLaw yield;                ///< when the wall gives way to a false passage; by default never
    /// The shaft enters only within this distance of the centre-line (MeatusGate); 0: anywhere.
    double meatus_m = 0.0;
    /// Depth of the tip that ends the insertion; 0: the bladder neck C and 10 mm beyond.
    double goalDepth_m = 0.0;
    /// True: the trial ends outside again; false: at the goal (or the last landmark).
    bool withdraws = true;
    std::vector<BladderLandmark> landmarks; ///< to be inspected after the goal; at most 16
    /// A landmark counts as seen within this angle of the centre of the view …
    double landmarkHalfAngle_rad = 0.2617993877991494;
    double landmarkDistance_m = 0.080;    ///< … and nearer than this …
    double landmarkHold_s = 1.0;          ///< … for this long …
    double landmarkSpeed_m_per_s = 0.005; ///< … with the tip no faster than this
    double trialLimit_s = 180.0;
    double maximumForce_N = 4.0; ///< the exercise's cap and the limit of force metrics
    double maximumTorque_Nm = 0.150;
    double lateralLimit_N = 2.0;    ///< trauma: lateral force above this for 20 ms, re-armed below 80 %
    bool depthOfField = false;      ///< initial setting of the level
    bool depthOfFieldFixed = false; ///< the user may not switch it
    std::vector<std::string> cues;
};

} // namespace chiron::simulation
