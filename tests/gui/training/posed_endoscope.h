// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/desktop/insertion_values.h"

#include <cmath>

namespace chiron::tests {

/// An endoscope at a place of the canal, `off` beside it and tilted about x and then about the turned y.
struct Posed {
    core::Vec3 p_W = core::Vec3::Zero();
    core::Quat q_WT = core::Quat::Identity();
    core::Vec3 axis_A = core::Vec3::UnitZ(); ///< looks along
    core::Vec3 y_A = core::Vec3::UnitY();    ///< y′
};

inline Posed posedAt(const simulation::UrethraInsertionParameters& p, double s_m,
                     const core::Vec3& off_A = core::Vec3::Zero(), double tiltX_rad = 0.0,
                     double tiltY_rad = 0.0) {
    const simulation::UrethraCentreline line(p.anatomy);
    const simulation::CentrelinePoint at = line.at(s_m);
    const double pitch = at.psi_rad + tiltX_rad;
    const core::Vec3 z(0.0, std::sin(pitch), std::cos(pitch));
    Posed posed;
    posed.y_A = core::Vec3(0.0, std::cos(pitch), -std::sin(pitch));
    posed.axis_A = std::sin(tiltY_rad) * core::Vec3::UnitX() + std::cos(tiltY_rad) * z;
    posed.p_W = p.pose.pointToW(at.p_A + off_A);
    posed.q_WT = core::Quat::FromTwoVectors(-core::Vec3::UnitZ(), p.pose.vectorToW(posed.axis_A));
    return posed;
}

} // namespace chiron::tests
