// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/urethra_bladder.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

constexpr double kShortest = 1e-6; // least length and angle; content refuses smaller ones

/// A weight 0 … 1 with its gradient, and bounds of the norms of gradient and second derivative at this point.
struct Weight {
    double value = 1.0;
    core::Vec3 gradient = core::Vec3::Zero();
    double slope = 0.0;
    double bend = 0.0;
};

/// 3x² − 2x³ on 0 … 1 of an x with gradient ∇x, whose second derivative is at most `xBend`.
Weight weightAlong(double x, const core::Vec3& xGradient, double xBend) noexcept {
    const double u = std::clamp(x, 0.0, 1.0);
    const double slope = 6.0 * u * (1.0 - u);
    const double curvature = x > 0.0 && x < 1.0 ? std::abs(6.0 - 12.0 * u) : 0.0;
    return {u * u * (3.0 - 2.0 * u), slope * xGradient, slope * xGradient.norm(),
            curvature * xGradient.squaredNorm() + slope * xBend};
}

Weight operator*(const Weight& a, const Weight& b) noexcept {
    return {a.value * b.value, a.gradient * b.value + b.gradient * a.value,
            a.slope * b.value + b.slope * a.value,
            a.bend * b.value + b.bend * a.value + 2.0 * a.slope * b.slope};
}

} // namespace

UrethraBladder::UrethraBladder(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                               const CentrelinePoint& neck) noexcept
    : m_neck_A(neck.p_A), m_out_A(neck.t_A), m_centre_A(neck.p_A + anatomy.bladderRadius_m * neck.t_A),
      m_free_m(std::max(anatomy.bladderRadius_m - endoscope.radius_m, kShortest)),
      m_stiffness_N_per_m(anatomy.bladderStiffness_N_per_m), m_opening_rad(anatomy.bladderOpening_rad),
      m_edge_rad(std::max(anatomy.bladderOpeningEdge_rad, kShortest)),
      m_cosFull(std::cos(m_opening_rad + m_edge_rad)) {}

BladderResponse UrethraBladder::respond(const core::Vec3& p_A) const noexcept {
    BladderResponse response;
    const double past_m = (p_A - m_neck_A).dot(m_out_A);
    const core::Vec3 arm = p_A - m_centre_A;
    const double distance = arm.norm();
    const double d = distance - m_free_m;
    if (!(past_m > 0.0 && d > 0.0 && p_A.z() > 0.0))
        return response;
    const core::Vec3 u = arm / distance;
    Weight weight = weightAlong(past_m / kNeckDepth_m, m_out_A / kNeckDepth_m, 0.0) *
                    weightAlong(p_A.z() / kBodyDepth_m, core::Vec3::UnitZ() / kBodyDepth_m, 0.0);
    const double cosine = std::min(1.0, -u.dot(m_out_A));
    if (cosine > m_cosFull) {
        const double sine = std::sqrt(std::max(1.0 - cosine * cosine, kShortest * kShortest));
        const core::Vec3 angleGradient = (m_out_A + cosine * u) / (distance * sine);
        const double angleBend = (1.0 + std::abs(cosine) / sine) / (distance * distance);
        weight = weight * weightAlong((std::acos(cosine) - m_opening_rad) / m_edge_rad,
                                      angleGradient / m_edge_rad, angleBend / m_edge_rad);
    }
    const double k = m_stiffness_N_per_m;
    response.energy_J = 0.5 * k * d * d * weight.value;
    response.force_A = -k * d * weight.value * u - 0.5 * k * d * d * weight.gradient;
    response.stiffness_N_per_m = k * (weight.value + 2.0 * d * weight.slope + 0.5 * d * d * weight.bend);
    return response;
}

} // namespace chiron::simulation
