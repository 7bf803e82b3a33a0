// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstdint>

namespace chiron::simulation {

/// Micro-height at a place and its slope.
struct RoughnessSample {
    double height_m = 0.0;
    core::Vec3 gradient = core::Vec3::Zero(); ///< ∇h, m/m, all three directions
};

/// Roughness as a pseudo-random micro-height fixed by a seed:
///   h(p) = rms √(2/N) Σ S(κ u_i·p/2π + φ_i),   S(t) = sin 2πt,   κ = 2π/λ,   N = kWaves
/// a sum of plane waves of the one wavelength λ = `shortestWavelength_m` (≥ 1 mm) whose directions u_i are even over the
/// sphere. Their wave numbers along any straight track are then even over 0..κ (Archimedes: the sphere's projection on a line
/// is uniform), so along every track, in whichever direction and on whichever plane, h is white up to 1/λ and has nothing
/// beyond: N lines at a spacing of about 1/(Nλ). Over many λ h is Gaussian with the rms asked for (m, 0..1 mm).
///
/// Added to the depth, d' = d + h, U = U_e(d'), f = −∇U with its lateral part: conservative, fixed in place (a still probe
/// feels a constant; the same path the same force), and felt as strongly as one presses. On a surface it is read at the foot
/// point C of the tool, with ∇h projected and scaled by how C moves with the tool (object_contact.h).
/// S is a polynomial of our own within 4·10⁻¹¹ of the sine, continuous with its slope over the wrap, and the gradient is the
/// exact derivative of what is summed: same bits on every machine, energy kept to rounding, about 0.3 µs a sample.
/// Pure after construction; fixed size, no allocation. Thread: any. Source: P2 "a random white noise type function";
/// models.md §2.2; the even directions are our choice.
class Roughness {
public:
    static constexpr int kWaves = 64;
    static constexpr double kShortestWavelength_m = 0.001;

    Roughness() = default; ///< smooth
    /// `rms_m` ≥ 0; a wavelength below kShortestWavelength_m is taken as that.
    Roughness(double rms_m, double shortestWavelength_m, std::uint64_t seed) noexcept;

    /// `p` m, in the object's frame.
    RoughnessSample sample(const core::Vec3& p) const noexcept;

    bool smooth() const noexcept { return m_amplitude_m == 0.0; }
    /// No place is higher: rms √(2N).
    double bound_m() const noexcept { return m_amplitude_m * kWaves; }
    double shortestWavelength_m() const noexcept { return m_wavelength_m; }

private:
    double m_amplitude_m = 0.0; ///< of each wave
    double m_wavelength_m = kShortestWavelength_m;
    std::array<double, kWaves> m_x{}; ///< wave vectors, turns per metre
    std::array<double, kWaves> m_y{};
    std::array<double, kWaves> m_z{};
    std::array<double, kWaves> m_phase{}; ///< turns
};

} // namespace chiron::simulation
