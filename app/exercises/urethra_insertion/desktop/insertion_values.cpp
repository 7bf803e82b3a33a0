// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/insertion_values.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

// models.md §1.3: the default goal of a level lies this far past C.
constexpr double kBeyondNeck_m = 0.010;

/// Splits the wrench's torque into P1's three torques (see InsertionValues::torque_Nm).
core::Vec3 torquesOf(const core::Vec3& torque_A, const core::Vec3& axis_A) {
    const double along = std::hypot(axis_A.y(), axis_A.z()); // cos φ_y
    if (along < 1e-9)
        // The endoscope points along x̂, so y′ is undefined.
        return {torque_A.x(), 0.0, torque_A.dot(axis_A)};
    const core::Vec3 y(0.0, axis_A.z() / along, -axis_A.y() / along); // z″ × x̂
    const double z_Nm = torque_A.dot(axis_A);
    return {torque_A.x() - z_Nm * axis_A.x(), torque_A.dot(y), z_Nm};
}

} // namespace

InsertionGauge::InsertionGauge(const simulation::UrethraInsertionParameters& parameters)
    : m_pose(parameters.pose), m_centreline(parameters.anatomy),
      m_goal_m(parameters.goalDepth_m > 0.0 ? parameters.goalDepth_m
                                            : m_centreline.length_m() + kBeyondNeck_m) {}

InsertionValues InsertionGauge::at(const core::Vec3& p_WT, const core::Quat& q_WT,
                                   const core::Wrench& wrench_W) const noexcept {
    InsertionValues values;
    values.tip_A_m = m_pose.pointToA(p_WT);
    const simulation::CentrelineFoot foot = m_centreline.foot(values.tip_A_m);
    values.depth_m = foot.at.s_m;
    values.offset_m = std::hypot(foot.ex_m, foot.en_m);
    const core::Vec3 axis_A = m_pose.vectorToA(q_WT * core::Vec3(0.0, 0.0, -1.0)); // it points along −z of T
    const core::Vec3& t_A = foot.at.t_A;
    values.alignment_rad = std::atan2(axis_A.cross(t_A).norm(), axis_A.dot(t_A));
    values.force_A_N = m_pose.vectorToA(wrench_W.force);
    const double along_N = values.force_A_N.dot(t_A);
    values.resistance_N = -along_N;
    values.lateral_N = (values.force_A_N - along_N * t_A).norm();
    values.torque_Nm = torquesOf(m_pose.vectorToA(wrench_W.torque), axis_A);
    return values;
}

} // namespace chiron::desktop
