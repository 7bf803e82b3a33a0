// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_kinematics.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

using core::Mat3;
using core::Vec3;

namespace {

constexpr double kHalfRoot3 = 0.86602540378443864676;
constexpr std::array<double, 3> kCos{1.0, -0.5, -0.5};
constexpr std::array<double, 3> kSin{0.0, kHalfRoot3, -kHalfRoot3};

/// M and its derivatives by pitch and roll, including the forced rotation γ.
struct Turned {
    Mat3 m, byPitch, byRoll;
};

Turned turnedBy(double pitch, double roll) noexcept {
    const double sb = std::sin(pitch), cb = std::cos(pitch), sa = std::sin(roll), ca = std::cos(roll);
    Mat3 m0, m0b, m0a;
    m0 << ca, 0.0, sa, sb * sa, cb, -sb * ca, -cb * sa, sb, cb * ca;
    m0b << 0.0, 0.0, 0.0, cb * sa, -sb, -cb * ca, sb * sa, cb, -sb * ca;
    m0a << -sa, 0.0, ca, sb * ca, 0.0, sb * sa, -cb * ca, 0.0, -cb * sa;
    const double y = m0(0, 1) - m0(1, 0), x = m0(0, 0) + m0(1, 1), r2 = x * x + y * y;
    const double r = std::sqrt(r2), cg = x / r, sg = y / r;
    const auto gammaBy = [&](const Mat3& d) {
        return (x * (d(0, 1) - d(1, 0)) - y * (d(0, 0) + d(1, 1))) / r2;
    };
    Mat3 z, zBy;
    z << cg, -sg, 0.0, sg, cg, 0.0, 0.0, 0.0, 1.0;
    zBy << -sg, -cg, 0.0, cg, -sg, 0.0, 0.0, 0.0, 0.0;
    return {m0 * z, m0b * z + gammaBy(m0b) * (m0 * zBy), m0a * z + gammaBy(m0a) * (m0 * zBy)};
}

Vec3 centreOf(const Mat3& m, double r) noexcept {
    return {0.5 * r * (m(0, 0) - m(1, 1)), -r * m(1, 0), 0.0};
}

} // namespace

FingertipLoop FingertipKinematics::loop(const FingertipPose& pose) const noexcept {
    const double r = m_geometry.platformRadius_m, leg = m_geometry.leg_m;
    const Turned t = turnedBy(pose.pitch_rad, pose.roll_rad);
    FingertipLoop out;
    out.centre = centreOf(t.m, r) + Vec3(0.0, 0.0, pose.z_m);
    out.centreBy << Vec3::UnitZ(), centreOf(t.byPitch, r), centreOf(t.byRoll, r);
    out.turn = t.m;
    out.normal = t.m.col(2);
    out.normalBy << Vec3::Zero(), t.byPitch.col(2), t.byRoll.col(2);
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Vec3 arm(r * kCos[k], r * kSin[k], 0.0);
        const Vec3 p = out.centre + t.m * arm;
        Mat3 pBy;
        pBy << out.centreBy.col(0), out.centreBy.col(1) + t.byPitch * arm,
            out.centreBy.col(2) + t.byRoll * arm;
        const double s = m_geometry.railRadius_m - (kCos[k] * p.x() + kSin[k] * p.y());
        const double rise2 = leg * leg - s * s;
        out.reached = out.reached && rise2 > kLeastLegRise * kLeastLegRise * leg * leg;
        const double rise = std::sqrt(std::max(rise2, kLeastLegRise * kLeastLegRise * leg * leg));
        out.drives[i] = p.z() - rise;
        // ∂q = ∂p_z + (s/rise) ∂s, ∂s = −(cos φ ∂p_x + sin φ ∂p_y)
        out.jacobian.row(i) = pBy.row(2) - s / rise * (kCos[k] * pBy.row(0) + kSin[k] * pBy.row(1));
    }
    return out;
}

bool FingertipKinematics::forward(const Vec3& drives, FingertipPose& pose) const noexcept {
    for (int step = 0; step < 30; ++step) {
        const FingertipLoop at = loop(pose);
        const Vec3 missing = drives - at.drives;
        if (!missing.allFinite())
            return false;
        if (missing.cwiseAbs().maxCoeff() < 1e-14)
            return at.reached;
        Vec3 change = at.jacobian.partialPivLu().solve(missing);
        // The angles change by at most a quarter radian per step, so that Newton's method stays in this
        // assembly mode.
        change *= std::min(1.0, 0.25 / std::max(1e-12, change.tail<2>().cwiseAbs().maxCoeff()));
        pose = FingertipPose::of(pose.vector() + change);
    }
    return (drives - loop(pose).drives).cwiseAbs().maxCoeff() < 1e-12;
}

FingertipPose FingertipKinematics::limited(const FingertipPose& pose) const noexcept {
    const FingertipGeometry& g = m_geometry;
    return {std::clamp(pose.z_m, g.minimumZ_m, g.maximumZ_m),
            std::clamp(pose.pitch_rad, -g.maximumPitch_rad, g.maximumPitch_rad),
            std::clamp(pose.roll_rad, -g.maximumRoll_rad, g.maximumRoll_rad)};
}

} // namespace chiron::mechanisms
