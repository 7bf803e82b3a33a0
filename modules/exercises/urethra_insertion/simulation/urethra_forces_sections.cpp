// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_sections.h"

#include "core/units.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_springs.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// Sums of one section for springs of stiffness 1: normal = Σ Δ(1 + βΔ); along ê and across it, weighted with
/// c_j and s_j.
struct SpringResult {
    double energy;
    double normal;
    double along;
    double across;
    double alongSlope, acrossSlope, coupling; ///< Σ (1 + 2βΔ) of c², s², |sc|
};

/// All springs are compressed: uses the trigonometric sums of a full circle.
inline SpringResult taut(double A, double b, double beta) noexcept {
    constexpr double n = RadialSprings::kCount;
    const double square = A * A + 0.5 * b * b;
    const double half = n * (0.5 + beta * A);
    return {n * (0.5 * square + beta / 3.0 * A * (square + b * b)),
            n * (A + beta * square),
            b * half,
            0.0,
            half,
            half,
            0.0};
}

/// Some springs are slack: the same sums over the compressed ones.
inline SpringResult slack(const SpringSums& s, double A, double b, double beta) noexcept {
    const double AA = A * A, Ab2 = 2.0 * A * b, bb = b * b;
    const double square = AA * s.count + Ab2 * s.c + bb * s.c2;
    const double cube = A * AA * s.count + 3.0 * AA * b * s.c + 3.0 * A * bb * s.c2 + b * bb * s.c3;
    const double s2 = s.count - s.c2; // Σ s_j²
    return {0.5 * square + beta / 3.0 * cube,
            A * s.count + b * s.c + beta * square,
            A * s.c + b * s.c2 + beta * (AA * s.c + Ab2 * s.c2 + bb * s.c3),
            A * s.s + b * s.sc + beta * (AA * s.s + Ab2 * s.sc + bb * s.sc2),
            s.c2 + 2.0 * beta * (A * s.c2 + b * s.c3),
            s2 + 2.0 * beta * (A * s2 + b * (s.c - s.c3)),
            std::abs(s.sc + 2.0 * beta * (A * s.sc + b * s.sc2))};
}

class Summation {
    static constexpr double kLeastOpen = 1e-9; ///< least opening of a window; energy is its square

public:
    /// `centred` holds the sums of all sections behind the tip as if it were centred.
    Summation(double ex_m, double en_m, double beta, const UrethraForcePassed& centred) noexcept
        : m_springs(ex_m, en_m), m_offset_m(m_springs.offset_m()), m_beta(beta), m_sums(centred) {}

    /// Adds a section behind the tip, whose centre follows the tip by B.
    void addBehind(const UrethraForceSection& at, const UrethraForcePassed* centred, double B,
                   double slopeOfB) noexcept {
        const double b = at.constrained * B * m_offset_m, touching = touchingWeight(at.squeeze_m + b);
        m_sums.length_m += at.step_m * touching - at.dragged_m;
        addYielding(at, at.squeeze_m, B, touching);
        if (b > at.squeeze_m) {
            const SpringResult r = slack(m_springs.compressed(at.squeeze_m, b), at.squeeze_m, b, m_beta);
            m_sums.energy_J += at.stiffness_N_per_m * r.energy - (centred[1].energy_J - centred[0].energy_J);
            addNormal(at, at.stiffness_N_per_m * r.normal - (centred[1].normal_N - centred[0].normal_N));
            addLateral(at, r, B, slopeOfB);
            const double moved_m = at.constrained * m_offset_m;
            m_axialBehind += at.stiffness_N_per_m * moved_m *
                             (moved_m * B * (1.0 - B) * r.alongSlope + 0.5 * std::abs(r.along));
            m_crossBehind += at.stiffness_N_per_m * at.constrained * std::abs(slopeOfB) *
                             (b * r.alongSlope + std::abs(r.along));
            return;
        }
        const double follow = at.follow_N_per_m * B;
        m_followSquare += follow * B;
        m_axialFollow += follow * (1.5 - B);
        m_followSlope += follow * slopeOfB;
        const double press = at.press_N_per_m2 * B * B;
        m_press += press;
        m_pressFriction += at.friction * press;
    }

    /// Adds a section ahead of the tip. It is opened by W, and its centre follows the tip by W, too.
    void addAhead(const UrethraForceSection& at, double W, double slopeOfW) noexcept {
        const double A = W * at.squeeze_m;
        const double b = at.constrained * W * m_offset_m;
        const SpringResult r = b <= A ? taut(A, b, m_beta) : slack(m_springs.compressed(A, b), A, b, m_beta);
        const double N = at.stiffness_N_per_m * r.normal;
        m_sums.energy_J += at.stiffness_N_per_m * r.energy;
        const double touching = touchingWeight(A + b);
        m_sums.length_m += W * at.step_m * touching;
        addYielding(at, A, W, touching);
        m_slope += slopeOfW * at.squeeze_m * N;
        addNormal(at, N);
        addLateral(at, r, W, slopeOfW);
        if (W > kLeastOpen)
            m_axialAhead += 3.0 * at.stiffness_N_per_m * r.energy * (1.5 - W) / W;
        m_crossAhead += 3.0 * at.stiffness_N_per_m * at.constrained * slopeOfW * std::abs(r.along);
    }

    /// The windows are cosines, so W′² = (π/ℓ)² W(1 − W) and |W″| ≤ ½ (π/ℓ)², and likewise B with ℓ_b. This
    /// bounds the change caused by a motion along the line.
    UrethraSectionSums result(double ahead_m, double behind_m) const noexcept {
        const double half2 = 0.5 * m_offset_m * m_offset_m;
        UrethraSectionSums sums;
        sums.energy_J = m_sums.energy_J + half2 * m_followSquare;
        sums.normal_N = std::max(0.0, m_sums.normal_N + half2 * m_press);
        sums.friction_N = std::max(0.0, m_sums.friction_N + half2 * m_pressFriction);
        sums.opened_m = std::max(0.0, m_sums.length_m);
        sums.slope_N = m_slope + 2.0 * half2 * m_followSlope;
        sums.gradient_N = m_springs.inSection(m_along + m_offset_m * m_followSquare, m_across);
        const double ahead2 = core::kPi * core::kPi / (ahead_m * ahead_m),
                     behind2 = core::kPi * core::kPi / (behind_m * behind_m);
        sums.axial_N_per_m = ahead2 * m_axialAhead + behind2 * (m_axialBehind + 2.0 * half2 * m_axialFollow);
        // The two have opposite signs
        sums.cross_N_per_m =
            std::max(m_crossAhead, m_crossBehind + 2.0 * m_offset_m * std::abs(m_followSlope));
        sums.yielding_N_per_m = 0.5 * RadialSprings::kCount * m_yielding;
        sums.stiffness_N_per_m = m_followSquare + std::max(m_alongSlope, m_acrossSlope) + m_coupling;
        return sums;
    }

private:
    void addNormal(const UrethraForceSection& at, double N) noexcept {
        m_sums.normal_N += N;
        m_sums.friction_N += at.friction * N;
    }
    void addYielding(const UrethraForceSection& at, double A, double B, double touching) noexcept {
        const double aB = at.constrained * B;
        m_yielding += at.stiffness_N_per_m * aB * aB * (1.0 + 2.0 * m_beta * std::max(0.0, A)) * touching;
    }
    void addLateral(const UrethraForceSection& at, const SpringResult& r, double B,
                    double slopeOfB) noexcept {
        const double ka = at.stiffness_N_per_m * at.constrained;
        const double square = ka * at.constrained * B * B;
        m_slope += ka * slopeOfB * m_offset_m * r.along;
        m_along += ka * B * r.along;
        m_across += ka * B * r.across;
        m_alongSlope += square * r.alongSlope;
        m_acrossSlope += square * r.acrossSlope;
        m_coupling += square * r.coupling;
    }

    RadialSprings m_springs;
    double m_offset_m;
    double m_beta;
    UrethraForcePassed m_sums;
    double m_followSquare = 0.0, m_followSlope = 0.0; ///< Σ follow B², Σ follow B B′
    double m_press = 0.0, m_pressFriction = 0.0;      ///< Σ press B², Σ μ press B²
    double m_slope = 0.0, m_along = 0.0, m_across = 0.0;
    double m_alongSlope = 0.0, m_acrossSlope = 0.0, m_coupling = 0.0;
    double m_axialAhead = 0.0, m_axialBehind = 0.0, m_axialFollow = 0.0;
    double m_crossAhead = 0.0, m_crossBehind = 0.0;
    double m_yielding = 0.0;
};

} // namespace

UrethraSectionSums sumUrethraSections(const UrethraForces::Tables& tables, double tip_s_m, double ex_m,
                                      double en_m) noexcept {
    const UrethraForceSection* const at = tables.sections.data();
    const int middle = tables.firstFrom(tip_s_m);
    const int end = tables.firstFrom(tip_s_m + tables.ahead_m);
    const int first =
        std::min(middle, std::max(tables.firstFrom(tip_s_m - tables.behind_m), tables.firstConstrained));
    const UrethraForcePassed* const passed = tables.passed.data();
    Summation sum(ex_m, en_m, tables.stiffening_per_m, passed[middle]);
    const double behind = core::kPi / tables.behind_m;
    const double cosB = std::cos(behind * tip_s_m), sinB = std::sin(behind * tip_s_m);
    for (int i = first; i < middle; ++i) {
        const double cosine = at[i].cosBehind * cosB + at[i].sinBehind * sinB;
        const double sine = at[i].cosBehind * sinB - at[i].sinBehind * cosB; // of π(s_t − s_i)/ℓ_b
        sum.addBehind(at[i], passed + i, 0.5 + 0.5 * cosine, -0.5 * behind * sine);
    }
    const double ahead = core::kPi / tables.ahead_m;
    const double cosA = std::cos(ahead * tip_s_m), sinA = std::sin(ahead * tip_s_m);
    for (int i = middle; i < end; ++i) {
        const double cosine = at[i].cosAhead * cosA + at[i].sinAhead * sinA;
        const double sine = at[i].sinAhead * cosA - at[i].cosAhead * sinA; // of π(s_i − s_t)/ℓ
        sum.addAhead(at[i], std::max(0.0, 0.5 + 0.5 * cosine), 0.5 * ahead * sine);
    }
    return sum.result(tables.ahead_m, tables.behind_m);
}

} // namespace chiron::simulation
