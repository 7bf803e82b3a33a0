// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

namespace chiron::desktop {

/// Everything that P1's Info window shows for one moment. Forces and torques act on the endoscope
/// (models.md §1).
/// Unit: SI.
/// Frame: A (models.md §0): x normal to the plane of symmetry, y up, z into the patient.
struct InsertionValues {
    core::Vec3 tip_A_m = core::Vec3::Zero();
    double depth_m = 0.0;                      ///< s_t, along the urethra; below 0 before the entrance
    double offset_m = 0.0;                     ///< of the tip from the centre-line, ≥ 0
    double alignment_rad = 0.0;                ///< between the endoscope and the urethra's tangent, ≥ 0
    double resistance_N = 0.0;                 ///< along the urethra; positive values push the endoscope out
    double lateral_N = 0.0;                    ///< across the urethra, ≥ 0
    core::Vec3 force_A_N = core::Vec3::Zero(); ///< F_x, F_y, F_z
    /// P1's torques: T_x = −k_φ φ_x about x̂, T_y = −k_φ φ_y about y′ (y turned about x̂ with the endoscope),
    /// T_z about the endoscope's axis (friction and viscosity). With the wrench's torque τ = T_x x̂ + T_y y′ −
    /// T_x tan φ_y z″ + T_z a they are T_z = τ·a, T_y = τ·y′, T_x = τ·x̂ − T_z sin φ_y.
    core::Vec3 torque_Nm = core::Vec3::Zero();
};

/// Converts pose and tissue wrench in W to displayed values, with the exercise's own geometry. Pure.
/// Thread: any.
class InsertionGauge {
public:
    explicit InsertionGauge(const simulation::UrethraInsertionParameters& parameters);

    /// `wrench_W`: the action of the tissue on the endoscope, torque about its tip.
    InsertionValues at(const core::Vec3& p_WT, const core::Quat& q_WT,
                       const core::Wrench& wrench_W) const noexcept;
    double length_m() const noexcept { return m_centreline.length_m(); } ///< L, to the bladder neck
    /// The depth that the tip must reach to complete the insertion (models.md §1.3): the level's, or L + 10
    /// mm.
    double goal_m() const noexcept { return m_goal_m; }

private:
    simulation::AnatomyPose m_pose;
    simulation::UrethraCentreline m_centreline;
    double m_goal_m;
};

} // namespace chiron::desktop
