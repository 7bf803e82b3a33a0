// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/attributes/roughness.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// Returns a uniformly distributed rotation (Shoemake 1992), so that no direction of a track is special.
core::Quat randomRotation(core::Random& random) noexcept {
    const double u = random.uniform();
    const double a = random.uniform(0.0, 2.0 * core::kPi);
    const double b = random.uniform(0.0, 2.0 * core::kPi);
    return core::Quat(std::sqrt(u) * std::cos(b), std::sqrt(1.0 - u) * std::sin(a),
                      std::sqrt(1.0 - u) * std::cos(a), std::sqrt(u) * std::sin(b));
}

} // namespace

Roughness::Roughness(double rms_m, double shortestWavelength_m, std::uint64_t seed) noexcept
    : m_amplitude_m(std::max(0.0, rms_m) * std::sqrt(2.0 / kWaves)),
      m_wavelength_m(std::max(kShortestWavelength_m, shortestWavelength_m)) {
    core::Random random = core::Random::stream(seed, "roughness");
    const core::Quat turn = randomRotation(random);
    // A wave and its opposite are the same, so directions on a half sphere suffice: the points of a Fibonacci
    // spiral, even to within a few per cent.
    const double golden = core::kPi * (3.0 - std::sqrt(5.0));
    for (std::size_t i = 0; i < kWaves; ++i) {
        const double z = (static_cast<double>(i) + 0.5) / kWaves;
        const double rho = std::sqrt(1.0 - z * z);
        const double around = golden * static_cast<double>(i);
        const core::Vec3 wave =
            turn * core::Vec3(rho * std::cos(around), rho * std::sin(around), z) / m_wavelength_m;
        m_x[i] = wave.x();
        m_y[i] = wave.y();
        m_z[i] = wave.z();
        m_phase[i] = random.uniform();
    }
}

} // namespace chiron::simulation
