// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"
#include "simulation/geometry/urethra/smoothstep.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

/// Limits of the lean of P3's platform: 30° in all, with pitch up to ±30° and roll up to ±20°.
struct LeanLimits {
    double pitch_rad = 0.52359877559829887; ///< > 0
    double roll_rad = 0.34906585039886592;  ///< > 0
    double lean_rad = 0.52359877559829887;  ///< > 0; limit of √(pitch² + roll²)
};

/// Computes atan2(‖F_t‖, F_n) for ‖F_t‖ > 0, within 2e-15 rad, by an odd polynomial (Chebyshev interpolation
/// of degree 19 over |u| ≤ tan 22.5°) about the nearest of 0, 45° and 90°. The library's atan2 was the most
/// expensive part of a contact. Pure.
inline double leanAngle(double lateral_N, double along_N) noexcept {
    constexpr double kTan = 0.41421356237309503, kQuarter = 0.78539816339744831;
    const double a = std::abs(along_N);
    double u = lateral_N - a, by = lateral_N + a, middle = kQuarter;
    if (lateral_N <= kTan * a) {
        u = lateral_N;
        by = a;
        middle = 0.0;
    } else if (a <= kTan * lateral_N) {
        u = -a;
        by = lateral_N;
        middle = 2.0 * kQuarter;
    }
    u /= by;
    const double w = u * u, w2 = w * w, w4 = w2 * w2;
    const double low =
        (0.999999999999999 - 0.33333333333221343 * w) + (0.1999999997837687 - 0.14285712660659053 * w) * w2;
    const double high = (0.11111048820585145 - 0.09089529357362555 * w) +
                        (0.07673529098467827 - 0.06505944155503311 * w) * w2;
    const double top = 0.05024634245596043 - 0.025314729731942324 * w;
    const double angle = middle + u * (low + w4 * (high + w4 * top));
    return along_N < 0.0 ? 4.0 * kQuarter - angle : angle;
}

/// How the fingertip platform shows a force.
struct Lean {
    double angle_rad = 0.0;     ///< α, eq. 2, unlimited
    double normalForce_N = 0.0; ///< eq. 3, F_ext·S_n, ≥ 0, with the unlimited angle
    core::DisplayPose display;  ///< limited
    bool saturated = false;     ///< the limits cut the lean
};

/// Computes how the platform shows a force by P3's eq. 2 and 3 (models.md §3). The angle is α = atan2(‖F_t‖,
/// F_n) · smoothstep(‖F‖/0.05 N), so that the direction of a negligible force tilts nothing. The displayed
/// normal force is F·S_n, whatever the limits below cut. The lean vector l lies in the contact plane along
/// the lateral force and is as long as α. It is split with x_F, the tool's x axis projected on the plane, and
/// y_F = S_n × x_F: roll = l·x_F, pitch = −l·y_F. Both are scaled by one factor until |pitch|, |roll| and
/// √(pitch² + roll²) are within limits. A tool whose x axis is perpendicular to the plane (within 11°) has no
/// such split, and the lean fades out there. `normal` and `xTool` are unit vectors in W. The result is
/// continuous in the force and, except for x_T on the normal, in both directions. Pure.
inline Lean leanOf(const core::Vec3& force, const core::Vec3& normal, const core::Vec3& xTool,
                   const LeanLimits& limits = {}) noexcept {
    constexpr double kFullForce_N = 0.05;
    constexpr double kFlatEnough = 0.2; // length of x_T's projection below which the lean fades
    Lean out;
    const double along_N = force.dot(normal);
    const core::Vec3 lateral = force - along_N * normal;
    const double lateral2 = lateral.squaredNorm();
    out.normalForce_N = out.display.normalForce_N = along_N > 0.0 ? along_N : 0.0;
    if (!(lateral2 > 1e-24)) // 1 pN
        return out;
    const double lateral_N = std::sqrt(lateral2);
    out.angle_rad = leanAngle(lateral_N, along_N);
    const double whole2 = lateral2 + along_N * along_N;
    if (whole2 < kFullForce_N * kFullForce_N)
        out.angle_rad *= smoothstep(std::sqrt(whole2) / kFullForce_N);

    const double upright = xTool.dot(normal);
    const double flat2 = std::max(0.0, 1.0 - upright * upright);
    if (!(flat2 > 1e-12))
        return out;
    const double flat = std::sqrt(flat2);
    double scale = out.angle_rad / (lateral_N * flat);
    if (flat < kFlatEnough)
        scale *= smoothstep(flat / kFlatEnough);
    out.display.roll_rad = scale * lateral.dot(xTool);
    out.display.pitch_rad = -scale * lateral.dot(normal.cross(xTool));
    const double pitch = std::abs(out.display.pitch_rad), roll = std::abs(out.display.roll_rad);
    const double over = std::max({pitch / limits.pitch_rad, roll / limits.roll_rad,
                                  std::sqrt(pitch * pitch + roll * roll) / limits.lean_rad});
    if (over > 1.0) {
        out.saturated = true;
        out.display.pitch_rad /= over;
        out.display.roll_rad /= over;
    }
    return out;
}

} // namespace chiron::simulation
