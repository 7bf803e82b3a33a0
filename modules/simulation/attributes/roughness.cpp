// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/attributes/roughness.h"

namespace chiron::simulation {

namespace {

/// Adding and then subtracting 1.5·2⁵² rounds |t| < 2⁵¹ to the nearest integer without a function call.
constexpr double kRound = 6755399441055744.0;

/// S(t) = t (1 − 4t²) Q(t²) on |t| ≤ ½ interpolates sin 2πt at the Chebyshev points of t², with an error of
/// 3.3·10⁻¹¹. The first two factors make it zero where the phase wraps, so that S and S' are continuous
/// there.
constexpr double kQ[] = {6.283185307009146, -16.208960944848467, 16.769400945426586, -9.628135704707535,
                         3.54455356482471,  -0.9046675556551789, 0.1523560546312187};

} // namespace

RoughnessSample Roughness::sample(const core::Vec3& p) const noexcept {
    RoughnessSample out;
    if (smooth())
        return out;
    double height = 0.0;
    double gx = 0.0;
    double gy = 0.0;
    double gz = 0.0;
    for (std::size_t i = 0; i < kWaves; ++i) {
        const double turns = m_x[i] * p.x() + m_y[i] * p.y() + m_z[i] * p.z() + m_phase[i];
        const double t = turns - ((turns + kRound) - kRound);
        const double w = t * t;
        const double q =
            kQ[0] + w * (kQ[1] + w * (kQ[2] + w * (kQ[3] + w * (kQ[4] + w * (kQ[5] + w * kQ[6])))));
        const double dq =
            kQ[1] +
            w * (2.0 * kQ[2] + w * (3.0 * kQ[3] + w * (4.0 * kQ[4] + w * (5.0 * kQ[5] + w * 6.0 * kQ[6]))));
        const double slope = (1.0 - 12.0 * w) * q + 2.0 * w * (1.0 - 4.0 * w) * dq;
        height += t * (1.0 - 4.0 * w) * q;
        gx += slope * m_x[i];
        gy += slope * m_y[i];
        gz += slope * m_z[i];
    }
    out.height_m = m_amplitude_m * height;
    out.gradient = m_amplitude_m * core::Vec3(gx, gy, gz);
    return out;
}

} // namespace chiron::simulation
