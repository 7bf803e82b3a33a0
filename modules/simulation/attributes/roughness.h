// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstdint>

namespace chiron::simulation {

/// Micro-height at one position, and its gradient.
struct RoughnessSample {
    double height_m = 0.0;
    core::Vec3 gradient = core::Vec3::Zero(); ///< ∇h, m/m, in all three directions
};

/// Roughness as a pseudo-random micro-height that is fixed by a seed:
///   h(p) = rms √(2/N) Σ S(κ u_i·p/2π + φ_i),   S(t) = sin 2πt,   κ = 2π/λ,   N = kWaves
/// It is a sum of plane waves, all of the wavelength λ = `shortestWavelength_m` (≥ 1 mm), whose directions
/// u_i are evenly distributed over the sphere. Their wave numbers along any straight track are then evenly
/// distributed over 0..κ (Archimedes: the projection of the sphere on a line is uniform). Along every track,
/// in whichever direction and on whichever plane, h is therefore white up to 1/λ and has nothing beyond: N
/// lines at a spacing of about 1/(Nλ). Over many λ, h is Gaussian with the requested rms (m, 0..1 mm).
///
/// h is added to the depth: d' = d + h, U = U_e(d'), f = −∇U with its lateral part. The contact is therefore
/// conservative and fixed in place (a still probe feels a constant, and the same path gives the same force),
/// and the roughness is felt the more strongly, the harder one presses. On a surface it is read at the foot
/// point C of the tool, with ∇h projected and scaled by how C moves with the tool (object_contact.h). S is a
/// polynomial of our own within 4·10⁻¹¹ of the sine; it and its slope are continuous where the phase wraps.
/// The gradient is the exact derivative of the sum, so every machine computes the same bits and energy is
/// kept to rounding, at about 0.3 µs per sample. Pure after construction; fixed size. Source: P2 "a random
/// white noise type function"; models.md §2.2; the even directions are our choice.
/// Thread: any; allocates nothing.
class Roughness {
public:
    static constexpr int kWaves = 64;
    static constexpr double kShortestWavelength_m = 0.001;

    Roughness() = default; ///< smooth
    /// `rms_m` ≥ 0; a wavelength below kShortestWavelength_m is raised to it.
    Roughness(double rms_m, double shortestWavelength_m, std::uint64_t seed) noexcept;

    /// Returns the micro-height and its gradient at `p` (m), in the object's frame.
    RoughnessSample sample(const core::Vec3& p) const noexcept;

    bool smooth() const noexcept { return m_amplitude_m == 0.0; }
    /// Upper bound of |h| at any position: rms √(2N).
    double bound_m() const noexcept { return m_amplitude_m * kWaves; }
    double shortestWavelength_m() const noexcept { return m_wavelength_m; }

private:
    double m_amplitude_m = 0.0; ///< amplitude of each wave
    double m_wavelength_m = kShortestWavelength_m;
    std::array<double, kWaves> m_x{}; ///< wave vectors, turns per metre
    std::array<double, kWaves> m_y{};
    std::array<double, kWaves> m_z{};
    std::array<double, kWaves> m_phase{}; ///< turns
};

} // namespace chiron::simulation
