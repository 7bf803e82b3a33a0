// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

/// Monogram notation: p_WT is the position of T measured from and expressed in W; v_WT and w_WT are its
/// linear and angular velocity; f_T_W is a force on the tool at T expressed in W. Frames (models.md §0): W
/// world (z up), D device base, T tool tip, A anatomy, C camera. All frames are right-handed.
namespace chiron::core {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// Force (N) and torque about the tip (N·m) on the tool, expressed in W unless a name says otherwise.
struct Wrench {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
};

using Array6 = std::array<double, 6>; ///< force then torque, for storage (trivially copyable)

inline Array6 toArray(const Wrench& w) {
    return {w.force.x(), w.force.y(), w.force.z(), w.torque.x(), w.torque.y(), w.torque.z()};
}
inline Wrench toWrench(const Array6& a) {
    return {Vec3(a[0], a[1], a[2]), Vec3(a[3], a[4], a[5])};
}

} // namespace chiron::core
