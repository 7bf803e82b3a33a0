// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace chiron::simulation {

/// A smooth function over an ellipse in the x-y plane of W: height · (1 − t²)³ where t < 1, else 0, with t² =
/// rᵀ·shape·r and r = xy − centre. It is twice continuously differentiable. It describes one bump of a
/// surface (height in m) or one stiffer region (height is dimensionless). Pure.
struct SmoothPatch {
    core::Vec2 centre_m = core::Vec2::Zero();
    Eigen::Matrix2d shape = Eigen::Matrix2d::Zero(); ///< 1/m²
    double height = 0.0;

    static SmoothPatch over(const core::Vec2& centre_m, const core::Vec2& radii_m, double turn_rad,
                            double height) noexcept {
        const Eigen::Matrix2d axes = Eigen::Rotation2Dd(turn_rad).toRotationMatrix();
        const Eigen::Vector2d inverse2(1.0 / (radii_m.x() * radii_m.x()), 1.0 / (radii_m.y() * radii_m.y()));
        return {centre_m, axes * inverse2.asDiagonal() * axes.transpose(), height};
    }

    /// Adds the value and its gradient with respect to x and y.
    void add(const core::Vec2& xy_m, double& value, core::Vec2& slope) const noexcept {
        const core::Vec2 r = xy_m - centre_m;
        const core::Vec2 half = shape * r; // ½ ∇t²
        const double rest = 1.0 - r.dot(half);
        if (rest <= 0.0)
            return;
        value += height * rest * rest * rest;
        slope -= 6.0 * height * rest * rest * half;
    }

    /// Adds the second derivatives as well.
    void add(const core::Vec2& xy_m, double& value, core::Vec2& slope,
             Eigen::Matrix2d& curvature) const noexcept {
        const core::Vec2 r = xy_m - centre_m;
        const core::Vec2 half = shape * r;
        const double rest = 1.0 - r.dot(half);
        if (rest <= 0.0)
            return;
        value += height * rest * rest * rest; // with u = 1 − t²: ∇u = −2·half, ∇²u = −2·shape
        slope -= 6.0 * height * rest * rest * half;
        curvature += height * rest * (24.0 * half * half.transpose() - 6.0 * rest * shape);
    }
};

} // namespace chiron::simulation
