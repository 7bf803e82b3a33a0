// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/comparison/explored_place.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::operators {

using simulation::ComparedAttribute;

namespace {

/// Below this speed a drive's friction has not reached its full value.
constexpr double kSticking_m_per_s = 0.004;
constexpr double kStroking_m_per_s = 0.015;
/// Reached well after a reversal, when a sticking contact has begun to slide.
constexpr double kSliding_m_per_s = 0.060;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double way(double v) noexcept {
    return std::tanh(v / kSticking_m_per_s);
}

} // namespace

void ExploredPlace::reset() noexcept {
    m_line.reset();
    m_rough.reset();
    for (auto& fit : m_bank)
        fit.reset();
    m_dent.fill(0.0);
    for (std::size_t i = 0; i < kTimes; ++i)
        m_share[i] = 1.0 - std::exp(-core::kTickSeconds / (kShortest_s * std::pow(kLongest_s / kShortest_s,
                                                                                  double(i) / (kTimes - 1))));
    m_n = 0;
}

void AirStroke::add(const FeltSample& felt) noexcept {
    const double v = felt.velocity.y();
    m_line.add({v, way(v), felt.acceleration.y(), 1.0}, -felt.force.y());
    m_own.add(felt.own, felt.force.z());
}

void AirStroke::learn() noexcept {
    if (const auto fit = m_line.solve(); fit.good)
        m_slope = fit.slope;
    if (const auto fit = m_own.solve(); fit.good)
        m_ownSlope = fit.slope;
}

double AirStroke::force_N(const FeltSample& felt) const noexcept {
    const double v = felt.velocity.y();
    return m_slope[0] * v + m_slope[1] * way(v) + m_slope[2] * felt.acceleration.y() + m_slope[3];
}

double AirStroke::lift_N(const FeltSample& felt) const noexcept {
    double lift_N = 0.0;
    for (std::size_t i = 1; i < felt.own.size(); ++i)
        lift_N += m_ownSlope[i] * felt.own[i];
    return lift_N;
}

void ExploredPlace::add(ComparedAttribute attribute, const FeltSample& felt, const AirStroke& air,
                        const KnownObject& known) noexcept {
    const double v_z = felt.velocity.z();
    const double v_y = felt.velocity.y();
    const bool strokes = std::abs(v_y) > kStroking_m_per_s;
    const double tissue_N = -felt.force.y() - air.force_N(felt);
    ++m_n;
    switch (attribute) {
    case ComparedAttribute::stiffness:
        m_line.add({felt.displacement_m, 1.0, way(v_z), v_z, felt.acceleration.z()}, -felt.force.z());
        break;
    case ComparedAttribute::mass:
        m_line.add({1.0, way(v_z), v_z, felt.acceleration.z(), 0.0}, -felt.force.z());
        break;
    case ComparedAttribute::roughness:
        m_known_N_per_m = known.stiffness_N_per_m;
        if (strokes)
            m_rough.add({1.0},
                        felt.force.z() - known.stiffness_N_per_m * felt.displacement_m - air.lift_N(felt));
        break;
    case ComparedAttribute::friction:
        if (std::abs(v_y) > kSliding_m_per_s)
            m_line.add({felt.force.z(), 0.0, 0.0, 0.0, 0.0}, v_y > 0.0 ? tissue_N : -tissue_N);
        break;
    case ComparedAttribute::viscosity:
        m_line.add({v_y, 1.0, 0.0, 0.0, 0.0}, tissue_N);
        break;
    case ComparedAttribute::deformation: {
        const double k = known.stiffness_N_per_m;
        for (std::size_t i = 0; i < kTimes; ++i) {
            const double pad_N =
                k * felt.displacement_m + known.share * k * (felt.displacement_m - m_dent[i]);
            m_bank[i].add({1.0, v_z, way(v_z), felt.acceleration.z()}, felt.force.z() - pad_N);
            m_dent[i] += (felt.displacement_m - m_dent[i]) * m_share[i];
        }
        break;
    }
    }
}

double ExploredPlace::fitted(ComparedAttribute attribute) const noexcept {
    const auto fit = m_line.solve();
    if (!fit.good)
        return kNan;
    if (attribute == ComparedAttribute::mass)
        return fit.slope[0] / core::kStandardGravity;
    return fit.slope[0];
}

double ExploredPlace::roughness() const noexcept {
    const auto fit = m_rough.solve();
    return fit.good ? std::sqrt(fit.residual / fit.n) / m_known_N_per_m : kNan;
}

double ExploredPlace::recoveryTime() const noexcept {
    std::array<double, kTimes> left{};
    std::size_t best = 0;
    for (std::size_t i = 0; i < kTimes; ++i) {
        const auto fit = m_bank[i].solve();
        if (!fit.good)
            return kNan;
        left[i] = fit.residual;
        if (left[i] < left[best])
            best = i;
    }
    double at = static_cast<double>(best);
    if (best > 0 && best + 1 < kTimes) {
        const double bend = left[best - 1] - 2.0 * left[best] + left[best + 1];
        if (bend > 0.0)
            at += 0.5 * (left[best - 1] - left[best + 1]) / bend;
    }
    return kShortest_s * std::pow(kLongest_s / kShortest_s, at / (kTimes - 1));
}

double ExploredPlace::estimate(ComparedAttribute attribute) const noexcept {
    const double value = attribute == ComparedAttribute::deformation ? recoveryTime()
                         : attribute == ComparedAttribute::roughness ? roughness()
                                                                     : fitted(attribute);
    return value > 0.0 ? value : kNan;
}

} // namespace chiron::operators
