// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"
#include "core/units.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace chiron::simulation {

/// Smooth bumps in space that can be laid on a surface: h(x) = A/√6 · Σ sin(2π u_i·x/λ + φ_i), with six
/// directions u_i and phases φ_i from the seed. They are as strong as one sine of amplitude A (rms A/√2),
/// never exceed 2.45 A, and have no wavelength below λ on a surface. The sum of a few waves is our choice: it
/// is irregular to the touch and exactly known. Pure after construction.
class MeshBumps {
public:
    MeshBumps(double height_m, double wavelength_m, std::uint64_t seed) noexcept
        : m_scale_m(height_m / std::sqrt(static_cast<double>(kWaves))) {
        core::Random random = core::Random::stream(seed, "mesh.bumps");
        for (std::size_t i = 0; i < kWaves; ++i) {
            const double z = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, 2.0 * core::kPi);
            const double rho = std::sqrt(1.0 - z * z);
            m_waves[i] =
                2.0 * core::kPi / wavelength_m * core::Vec3(rho * std::cos(angle), rho * std::sin(angle), z);
            m_phases[i] = random.uniform(0.0, 2.0 * core::kPi);
        }
    }

    double height_m(const core::Vec3& x) const noexcept {
        if (m_scale_m == 0.0)
            return 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < kWaves; ++i)
            sum += std::sin(m_waves[i].dot(x) + m_phases[i]);
        return m_scale_m * sum;
    }

private:
    static constexpr std::size_t kWaves = 6;
    double m_scale_m = 0.0;
    std::array<core::Vec3, kWaves> m_waves;
    std::array<double, kWaves> m_phases{};
};

} // namespace chiron::simulation
