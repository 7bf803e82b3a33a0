// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/five_bar_kinematics.h"

#include <algorithm>
#include <cmath>

namespace chiron::mechanisms {

using core::Vec2;

FiveBarLoop FiveBarKinematics::loop(double theta1, double theta2) const noexcept {
    const FiveBarGeometry& g = m_geometry;
    const std::array<double, 2> theta{theta1, theta2};
    FiveBarLoop result;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec2 base(g.baseForward_m + (i == 0 ? -g.halfBase_m : g.halfBase_m), g.baseUp_m);
        const double s = std::sin(theta[i]), c = std::cos(theta[i]);
        result.elbow[i] = base + g.proximal_m * Vec2(c, s);
        result.tangent[i] = g.proximal_m * Vec2(-s, c);
    }
    const Vec2 across = result.elbow[1] - result.elbow[0];
    const double distance = across.norm();
    const double height2 = g.distal_m * g.distal_m - 0.25 * distance * distance;
    result.closed = distance > 0.0 && height2 >= 0.0;
    const Vec2 upright = Vec2(-across.y(), across.x()) / distance;
    result.tip = result.elbow[0] + 0.5 * across + std::sqrt(std::max(height2, 0.0)) * upright;

    const Vec2 a1 = result.tip - result.elbow[0], a2 = result.tip - result.elbow[1];
    result.determinant = a1.x() * a2.y() - a1.y() * a2.x();
    result.jacobian.col(0) = a1.dot(result.tangent[0]) / result.determinant * Vec2(a2.y(), -a2.x());
    result.jacobian.col(1) = a2.dot(result.tangent[1]) / result.determinant * Vec2(-a1.y(), a1.x());
    return result;
}

Vec2 FiveBarLoop::elbowBias(int leg, double rate) const noexcept {
    const Vec2& t = tangent[static_cast<std::size_t>(leg)];
    return rate * rate * Vec2(-t.y(), t.x()); // the tangent turned by 90° is −l1 (cos θ, sin θ)
}

Vec2 FiveBarLoop::biasAcceleration(const Vec2& rates) const noexcept {
    const Vec2 velocity = jacobian * rates;
    std::array<Vec2, 2> rod{tip - elbow[0], tip - elbow[1]};
    Vec2 right;
    for (int i = 0; i < 2; ++i) {
        const auto leg = static_cast<std::size_t>(i);
        right[i] = rod[leg].dot(elbowBias(i, rates[i])) - (velocity - rates[i] * tangent[leg]).squaredNorm();
    }
    return Vec2(rod[1].y() * right[0] - rod[0].y() * right[1],
                rod[0].x() * right[1] - rod[1].x() * right[0]) /
           determinant;
}

core::Vec3 FiveBarKinematics::force_D(const FiveBarLoop& loop, const Vec2& efforts) noexcept {
    const Eigen::Matrix2d& j = loop.jacobian;
    const double det = j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0);
    return toD(
        Vec2(j(1, 1) * efforts[0] - j(1, 0) * efforts[1], j(0, 0) * efforts[1] - j(0, 1) * efforts[0]) / det);
}

double FiveBarKinematics::conditionNumber(const FiveBarLoop& loop) noexcept {
    const Eigen::Matrix2d& j = loop.jacobian;
    const double sum = j.squaredNorm();
    const double product = std::abs(j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0));
    const double root = std::sqrt(std::max(0.0, sum * sum - 4.0 * product * product));
    return (sum + root) / (2.0 * product); // σ1/σ2 = σ1²/(σ1 σ2)
}

} // namespace chiron::mechanisms
