// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/least_squares.h"
#include "operators/hand/instrument_feel.h"
#include "modules/exercises/comparison/simulation/comparison_parameters.h"

#include <array>
#include <cstddef>

namespace chiron::operators {

/// One tick of what a hand feels at a place. W, SI.
struct FeltSample {
    double displacement_m = 0.0;  ///< stretch, height above the ring, depth below the pad's rest surface: as seen at the tip
    core::Vec3 force = core::Vec3::Zero(); ///< on the hand
    core::Vec3 velocity = core::Vec3::Zero();
    core::Vec3 acceleration = core::Vec3::Zero();
    InstrumentFeel::Own own{}; ///< what of f_z may be the instrument's
};

/// What an instrument feels like when nothing is touched, along y and along z: it takes force to move it.
class AirStroke {
public:
    void add(const FeltSample& felt) noexcept;
    void learn() noexcept; ///< fits what was added so far
    double force_N(const FeltSample& felt) const noexcept; ///< −f_y that is the device's own; 0 before it learned
    double lift_N(const FeltSample& felt) const noexcept;  ///< f_z, up to a constant

private:
    core::LeastSquares<4> m_line;
    std::array<double, 4> m_slope{};
    core::LeastSquares<InstrumentFeel::kOwn> m_own;
    InstrumentFeel::Own m_ownSlope{};
};

/// What every object of a kind has in common, known from practice.
struct KnownObject {
    double stiffness_N_per_m = 200.0; ///< k of a pad
    double share = 0.0;               ///< k₁/k
};

/// What was felt at one place, and the attribute fitted to it. All fits carry the drives' own part as regressors of their own (Coulomb
/// friction as tanh(v/v₀), viscosity, moved mass), so that what is left is the object's:
///   stiffness    −f_z = k x + c + f_c tanh(v_z/v₀) + b v_z + m a_z                 k
///   mass         −f_z = w + f_c tanh(v_z/v₀) + b v_z + m a_z  in the air            w/g
///   deformation  f_z − k d − k₁(d − q_τ) = c + b v_z + f_c tanh(v_z/v₀) + m a_z over a bank of 41 τ, q_τ′ = (d − q_τ)/τ, k and k₁ known
///                from practice: the least residual, by a parabola                  τ
///   roughness    f_z − k d − device = c while stroking, k known from practice; rms of what is left, over k  rms height
///   friction     −(f_y + device)·v̂ = μ f_z  while stroking along y                   μ
///   viscosity    −(f_y + device) = b v_y + c                                         b
/// The device's own −f_y = b v_y + f_c tanh(v_y/v₀) + m a_y + c of the last two, and f_z of roughness (InstrumentFeel), are fitted to strokes in
/// the air (AirStroke): fitted to the strokes themselves, a moved mass would take what the heights do to the hand for its own.
/// No allocation. Source: psychophysics.md §6 (own fit to felt force); the regressors are our choice.
class ExploredPlace {
public:
    ExploredPlace() noexcept { reset(); }
    void reset() noexcept;
    void add(simulation::ComparedAttribute attribute, const FeltSample& felt, const AirStroke& air, const KnownObject& known) noexcept;
    /// SI; not a number where nothing usable was felt.
    double estimate(simulation::ComparedAttribute attribute) const noexcept;
    int samples() const noexcept { return m_n; }

private:
    static constexpr std::size_t kTimes = 41;
    static constexpr double kShortest_s = 0.01, kLongest_s = 3.0; ///< of the bank
    double fitted(simulation::ComparedAttribute attribute) const noexcept;
    double roughness() const noexcept;
    double recoveryTime() const noexcept;

    core::LeastSquares<5> m_line;
    core::LeastSquares<1> m_rough;
    double m_known_N_per_m = 0.0;
    std::array<core::LeastSquares<4>, kTimes> m_bank;
    std::array<double, kTimes> m_dent{};
    std::array<double, kTimes> m_share{}; ///< of what is left, that a dent gives way by in a tick
    int m_n = 0;
};

} // namespace chiron::operators
