// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/gimbal_kinematics.h"

#include "core/units.h"

#include <cmath>

namespace chiron::mechanisms {

using core::Vec3;

namespace {

/// Sines and cosines of heading and pitch, and the unit vectors along which each axis moves the tip (vendor
/// axes).
struct Frame {
    double sh, ch, sp, cp;
    Frame(double h, double p) : sh(std::sin(h)), ch(std::cos(h)), sp(std::sin(p)), cp(std::cos(p)) {}
    Vec3 alongHeading() const { return {ch, 0.0, -sh}; }
    Vec3 alongPitch() const { return {-sh * sp, cp, -ch * sp}; }
    Vec3 alongDepth() const { return {sh * cp, sp, ch * cp}; }
    Vec3 pitchAxis() const { return {-ch, 0.0, sh}; } ///< R_y(h)(−x): positive pitch lifts u towards +y
};

} // namespace

Vec3 GimbalKinematics::axis_V(double h, double p) noexcept {
    return Frame(h, p).alongDepth();
}

Vec3 GimbalKinematics::tip_D(const GimbalCoordinates& q) const noexcept {
    return directionToD(q.d * axis_V(q.h, q.p)) + Vec3(0.0, 0.0, m_pivotHeight_m);
}

core::Quat GimbalKinematics::orientation_DT(const GimbalCoordinates& q) const noexcept {
    // Turning by 180° about x conjugates the vendor rotation: y and z components of the quaternion change
    // sign.
    const core::Quat turn_V = Eigen::AngleAxisd(q.h, Vec3::UnitY()) * Eigen::AngleAxisd(-q.p, Vec3::UnitX()) *
                              Eigen::AngleAxisd(q.r, Vec3::UnitZ());
    return {turn_V.w(), turn_V.x(), -turn_V.y(), -turn_V.z()};
}

GimbalJacobian GimbalKinematics::jacobian_D(const GimbalCoordinates& q) const noexcept {
    const Frame f(q.h, q.p);
    GimbalJacobian j = GimbalJacobian::Zero();
    j.col(0) << directionToD(q.d * f.cp * f.alongHeading()), directionToD(Vec3::UnitY());
    j.col(1) << directionToD(q.d * f.alongPitch()), directionToD(f.pitchAxis());
    j.col(2) << Vec3::Zero(), directionToD(f.alongDepth());
    j.col(3) << directionToD(f.alongDepth()), Vec3::Zero();
    return j;
}

GimbalVector GimbalKinematics::efforts(const GimbalCoordinates& q, const core::Wrench& wrench_D,
                                       PolarMap map) noexcept {
    const Frame f(q.h, q.p);
    const Vec3 force = directionToVendor(wrench_D.force);
    const Vec3 torque = directionToVendor(wrench_D.torque);
    const PolarForces polar =
        map == PolarMap::exact ? polarExact(q.h, q.p, force) : polarAsPublished(q.h, q.p, force);
    return {q.d * f.cp * polar.heading_N + torque.y(), q.d * polar.pitch_N + f.pitchAxis().dot(torque),
            f.alongDepth().dot(torque), polar.depth_N};
}

Vec3 GimbalKinematics::force_D(const GimbalCoordinates& q, const GimbalVector& efforts) noexcept {
    const Frame f(q.h, q.p);
    return directionToD(efforts[0] / (q.d * f.cp) * f.alongHeading() + efforts[1] / q.d * f.alongPitch() +
                        efforts[3] * f.alongDepth());
}

PolarForces GimbalKinematics::polarAsPublished(double h, double p, const Vec3& f_V) noexcept {
    const Frame f(h, p);
    return {f_V.x() * f.ch - f_V.z() * f.sh, f_V.y() * f.cp - f_V.z() * f.sp,
            f_V.x() * f.sh + f_V.y() * f.sp + f_V.z() * f.ch * f.cp};
}

PolarForces GimbalKinematics::polarExact(double h, double p, const Vec3& f_V) noexcept {
    const Frame f(h, p);
    return {f.alongHeading().dot(f_V), f.alongPitch().dot(f_V), f.alongDepth().dot(f_V)};
}

PolarForces GimbalKinematics::weightAsPublished(double h, double p, double mass_kg) noexcept {
    const double weight = mass_kg * core::kStandardGravity;
    return {weight * std::sin(h), weight * std::sin(p), weight * std::cos(h) * std::cos(p)};
}

} // namespace chiron::mechanisms
