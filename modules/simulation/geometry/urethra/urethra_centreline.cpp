// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/urethra_centreline.h"

#include "simulation/geometry/urethra/smoothstep.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

using core::Vec3;

/// Both equations below are convex and increasing to the right of their root, and Newton's method starts to
/// the right of it. It descends monotonically and at least halves its distance in each step until convergence
/// is quadratic. From these starts it takes 5 to 7 steps.
constexpr int kMostSteps = 12;
/// The foot moves along the centre-line at most 1/kLeastDenominator times as fast as the tool. Beyond three
/// quarters of the way to the centre of curvature the nearest point would run away from the tool, and at the
/// centre itself it is not unique.
constexpr double kLeastDenominator = 0.25;

/// u of 4cs = u√(1+u²) + asinh u, for s ≥ 0; u = 2cz.
double scaledRoot(double target) noexcept {
    double u = std::min(0.5 * target, std::sqrt(target)); // the sum is ≥ 2u and ≥ u²
    for (int step = 0; step < kMostSteps; ++step) {
        const double root = std::sqrt(1.0 + u * u);
        const double change = (u * root + std::asinh(u) - target) / (2.0 * root);
        u -= change;
        if (std::abs(change) <= 1e-16 * u)
            break;
    }
    return u;
}

/// The positive root of z³ + qz − r, r > 0.
double cubicRoot(double q, double r) noexcept {
    const double edge = std::cbrt(r);
    double z = q >= 0.0 ? std::min(edge, q > 0.0 ? r / q : edge) : std::sqrt(-q) + edge;
    for (int step = 0; step < kMostSteps; ++step) {
        const double change = ((z * z + q) * z - r) / (3.0 * z * z + q);
        z -= change;
        if (std::abs(change) <= 1e-16 * z)
            break;
    }
    return z;
}

} // namespace

UrethraCentreline::UrethraCentreline(double curvature_per_m, double zEnd_m, double straight_m) noexcept
    : m_c(curvature_per_m), m_straight_m(straight_m), m_length_m(arcLengthAt(zEnd_m)) {}

double UrethraCentreline::arcLengthAt(double z_m) const noexcept {
    const double past_m = z_m - m_straight_m;
    if (past_m <= 0.0)
        return z_m;
    const double u = 2.0 * m_c * past_m;
    return m_straight_m + (0.5 * past_m * std::sqrt(1.0 + u * u) + std::asinh(u) / (4.0 * m_c));
}

double UrethraCentreline::zAt(double s_m) const noexcept {
    const double past_m = s_m - m_straight_m;
    if (past_m <= 0.0)
        return s_m;
    return m_straight_m + scaledRoot(4.0 * m_c * past_m) / (2.0 * m_c);
}

CentrelinePoint UrethraCentreline::at(double s_m) const noexcept {
    CentrelinePoint point = atZ(zAt(s_m));
    point.s_m = s_m;
    return point;
}

CentrelinePoint UrethraCentreline::atZ(double z_m) const noexcept {
    CentrelinePoint point;
    point.z_m = z_m;
    point.s_m = arcLengthAt(z_m);
    const double past_m = z_m - m_straight_m;
    if (past_m < 0.0) {
        point.p_A = Vec3(0.0, 0.0, z_m);
        return point;
    }
    const double slope = 2.0 * m_c * past_m;
    const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
    point.p_A = Vec3(0.0, m_c * past_m * past_m, z_m);
    point.t_A = Vec3(0.0, slope * cosine, cosine);
    point.n_A = Vec3(0.0, cosine, -slope * cosine);
    point.psi_rad = std::atan(slope);
    point.curvature_per_m = 2.0 * m_c * cosine * cosine * cosine;
    point.bending_per_m2 = -3.0 * point.curvature_per_m * point.curvature_per_m * slope;
    return point;
}

CentrelineFoot UrethraCentreline::foot(const Vec3& p_A) const noexcept {
    return p_A.z() > m_straight_m ? footOnParabola(p_A) : footBeforeVertex(p_A);
}

CentrelineFoot UrethraCentreline::footOnParabola(const Vec3& p_A) const noexcept {
    const double scale = 1.0 / (2.0 * m_c * m_c);
    CentrelineFoot foot;
    foot.at =
        atZ(m_straight_m + cubicRoot((1.0 - 2.0 * m_c * p_A.y()) * scale, (p_A.z() - m_straight_m) * scale));
    const Vec3 offset = p_A - foot.at.p_A;
    foot.ex_m = offset.x();
    foot.en_m = foot.at.n_A.dot(offset);
    const double denominator = std::max(kLeastDenominator, 1.0 - foot.at.curvature_per_m * foot.en_m),
                 along = 1.0 / denominator;
    foot.gradientOfS_A = foot.at.t_A / denominator;
    foot.bendOfS_per_m =
        along * along * (foot.at.curvature_per_m + along * std::abs(foot.at.bending_per_m2 * foot.en_m));
    return foot;
}

CentrelineFoot UrethraCentreline::footBeforeVertex(const Vec3& p_A) const noexcept {
    const double past_m = p_A.z() - m_straight_m; // ≤ 0
    const double u = 1.0 + past_m / kLeadIn_m;
    const double bend = 2.0 * m_c * p_A.y(); // curvature at B times the offset
    const double g = smoothstep(u);
    const double denominator = 1.0 - bend * g;
    CentrelineFoot foot;
    double alongZ = 1.0 / kLeastDenominator;
    double alongY = 0.0;
    if (denominator > kLeastDenominator) {
        const double rise_per_m = smoothstepSlope(u) / kLeadIn_m, along = 1.0 / denominator;
        const double pull = past_m * along * along;
        alongZ = along + pull * bend * rise_per_m;
        alongY = pull * 2.0 * m_c * g;
        const double steepens_per_m2 = u > 0.0 && u < 1.0 ? 6.0 / (kLeadIn_m * kLeadIn_m) : 0.0;
        const double across = 2.0 * m_c * g, turn = std::abs(bend) * rise_per_m, back_m = -past_m;
        const double both = 2.0 * back_m * along; // of the squares of D's derivatives
        foot.bendOfS_per_m =
            along * along *
            (across + back_m * 2.0 * m_c * rise_per_m + both * across * turn +             // ∂²s/∂y∂z
             both * across * across +                                                      // ∂²s/∂y²
             2.0 * turn + back_m * std::abs(bend) * steepens_per_m2 + both * turn * turn); // ∂²s/∂z²
    }
    const double s = m_straight_m + past_m / std::max(kLeastDenominator, denominator);
    foot.at.s_m = s;
    foot.at.z_m = s;
    foot.at.p_A = Vec3(0.0, 0.0, s);
    foot.at.curvature_per_m = s < m_straight_m ? 0.0 : 2.0 * m_c;
    foot.ex_m = p_A.x();
    foot.en_m = p_A.y();
    foot.gradientOfS_A = Vec3(0.0, alongY, alongZ);
    return foot;
}

} // namespace chiron::simulation
