// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/exercises/urethra_insertion/urethra_bladder.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

constexpr double kShortest = 1e-6;        // of lengths and angles; content refuses such data
constexpr double kSteepest = 1.5;         // largest slope of the smoothstep
constexpr double kMostCurved = 6.0;       // largest second derivative of the smoothstep

struct Weight {
    double value = 1.0;
    core::Vec3 gradient = core::Vec3::Zero();
};

/// 3x² − 2x³ on 0 … 1, and its gradient for x = `x` with ∇x = `xGradient`.
Weight smoothstep(double x, const core::Vec3& xGradient) noexcept {
    const double u = std::clamp(x, 0.0, 1.0);
    return {u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u) * xGradient};
}

} // namespace

UrethraBladder::UrethraBladder(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                               const CentrelinePoint& neck) noexcept
    : m_neck_A(neck.p_A), m_out_A(neck.t_A), m_centre_A(neck.p_A + anatomy.bladderRadius_m * neck.t_A),
      m_free_m(std::max(anatomy.bladderRadius_m - endoscope.radius_m, kShortest)),
      m_stiffness_N_per_m(anatomy.bladderStiffness_N_per_m), m_opening_rad(anatomy.bladderOpening_rad),
      m_edge_rad(std::max(anatomy.bladderOpeningEdge_rad, kShortest)), m_cosFull(std::cos(m_opening_rad + m_edge_rad)) {}

BladderResponse UrethraBladder::respond(const core::Vec3& p_A) const noexcept {
    BladderResponse response;
    const double past_m = (p_A - m_neck_A).dot(m_out_A);
    const core::Vec3 arm = p_A - m_centre_A;
    const double distance = arm.norm();
    const double d = distance - m_free_m;
    if (!(past_m > 0.0 && d > 0.0 && p_A.z() > 0.0))
        return response;
    const core::Vec3 u = arm / distance;
    const Weight q = smoothstep(past_m / kNeckDepth_m, m_out_A / kNeckDepth_m);
    const Weight h = smoothstep(p_A.z() / kBodyDepth_m, core::Vec3::UnitZ() / kBodyDepth_m);
    Weight g;
    const double cosine = std::min(1.0, -u.dot(m_out_A));
    if (cosine > m_cosFull) {
        const double sine = std::sqrt(std::max(1.0 - cosine * cosine, kShortest * kShortest));
        const core::Vec3 angleGradient = (m_out_A + cosine * u) / (distance * sine);
        g = smoothstep((std::acos(cosine) - m_opening_rad) / m_edge_rad, angleGradient / m_edge_rad);
    }
    const double weight = g.value * q.value * h.value;
    const core::Vec3 weightGradient = g.gradient * (q.value * h.value) + q.gradient * (g.value * h.value) +
                                      h.gradient * (g.value * q.value);
    const double k = m_stiffness_N_per_m;
    response.energy_J = 0.5 * k * d * d * weight;
    response.force_A = -k * d * weight * u - 0.5 * k * d * d * weightGradient;
    response.stiffness_N_per_m = k;
    if (weight < 1.0) { // bounds of the weights' first and second derivatives, each the sum of its parts
        const double rate = kSteepest * (1.0 / (m_edge_rad * m_free_m) + 1.0 / kNeckDepth_m + 1.0 / kBodyDepth_m);
        const double bend = kMostCurved / kSteepest / kSteepest * rate * rate;
        response.stiffness_N_per_m += k * d * (2.0 * rate + 0.5 * d * bend);
    }
    return response;
}

} // namespace chiron::simulation
