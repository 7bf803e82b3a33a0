// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/least_squares.h"
#include "operators/hand/instrument_feel.h"
#include "simulation/comparison/comparison_parameters.h"

#include <array>
#include <cstddef>

namespace chiron::operators {

/// Sensations of a hand at a place in one tick.
/// Unit: SI.
/// Frame: W.
struct FeltSample {
    /// As seen at the tip: stretch, height above the ring, or depth below the pad's rest surface.
    double displacement_m = 0.0;
    core::Vec3 force = core::Vec3::Zero(); ///< on the hand
    core::Vec3 velocity = core::Vec3::Zero();
    core::Vec3 acceleration = core::Vec3::Zero();
    InstrumentFeel::Own own{}; ///< terms of f_z that may be due to the instrument
};

/// Model of the force that it takes to move the instrument when nothing is touched, along y and along z.
class AirStroke {
public:
    void add(const FeltSample& felt) noexcept;
    void learn() noexcept;                                 ///< fits the model to all samples so far
    double force_N(const FeltSample& felt) const noexcept; ///< the device's own −f_y; 0 before learn()
    double lift_N(const FeltSample& felt) const noexcept;  ///< the device's own f_z, up to a constant

private:
    core::LeastSquares<4> m_line;
    std::array<double, 4> m_slope{};
    core::LeastSquares<InstrumentFeel::kOwn> m_own;
    InstrumentFeel::Own m_ownSlope{};
};

/// Properties that all objects of a study share, known from practice.
struct KnownObject {
    double stiffness_N_per_m = 200.0; ///< k of a pad
    double share = 0.0;               ///< k₁/k
};

/// The observations made at one place, and the attribute fitted to them. All fits include the drives' own
/// force as separate regressors (Coulomb friction as tanh(v/v₀), viscosity, moved mass), so that the
/// remainder belongs to the object:
///
/// - Stiffness, k:  −f_z = k x + c + f_c tanh(v_z/v₀) + b v_z + m a_z
/// - Mass, w/g:  −f_z = w + f_c tanh(v_z/v₀) + b v_z + m a_z, in the air
/// - Deformation, τ:  f_z − k d − k₁(d − q_τ) = c + b v_z + f_c tanh(v_z/v₀) + m a_z over a bank
///   of 41 τ, with q_τ′ = (d − q_τ)/τ, and k and k₁ known from practice: the least residual, by a parabola
/// - Roughness, rms height:  f_z − k d − device = c while stroking, with k known from practice:
///   the rms of the residual, over k
/// - Friction, μ:  −(f_y + device)·v̂ = μ f_z while stroking along y
/// - Viscosity, b:  −(f_y + device) = b v_y + c
///
/// For the last two, the device's own −f_y = b v_y + f_c tanh(v_y/v₀) + m a_y + c is fitted to strokes in the
/// air (AirStroke), and so is f_z for roughness (InstrumentFeel). If they were fitted to the strokes over the
/// object, the moved mass would absorb the effect of the surface's heights on the hand. Source:
/// psychophysics.md §6 (own fit to felt force); the regressors are our choice.
/// Thread: haptic; allocates nothing.
class ExploredPlace {
public:
    ExploredPlace() noexcept { reset(); }
    void reset() noexcept;
    void add(simulation::ComparedAttribute attribute, const FeltSample& felt, const AirStroke& air,
             const KnownObject& known) noexcept;
    /// The fitted attribute in SI units; NaN where nothing usable was felt.
    double estimate(simulation::ComparedAttribute attribute) const noexcept;
    int samples() const noexcept { return m_n; }

private:
    static constexpr std::size_t kTimes = 41;
    static constexpr double kShortest_s = 0.01, kLongest_s = 3.0; ///< time constants of the bank
    double fitted(simulation::ComparedAttribute attribute) const noexcept;
    double roughness() const noexcept;
    double recoveryTime() const noexcept;

    core::LeastSquares<5> m_line;
    core::LeastSquares<1> m_rough;
    double m_known_N_per_m = 0.0;
    std::array<core::LeastSquares<4>, kTimes> m_bank;
    std::array<double, kTimes> m_dent{};
    /// Share of the remaining distance by which a dent follows in a tick.
    std::array<double, kTimes> m_share{};
    int m_n = 0;
};

} // namespace chiron::operators
