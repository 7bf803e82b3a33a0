// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "mechanisms/encoder_line.h"

#include <algorithm>
#include <cstdint>

namespace chiron::mechanisms {

/// Parameters of a grasper's handle and the fingers in it. P2 fitted "a potentiometer to allow continual
/// tracking of the grasper position" and names neither range nor converter; all numbers are ASSUMPTIONS.
struct JawParameters {
    double widest_rad = 1.6;   ///< opening angle between the jaws at the handle's stop; 0 is closed
    int steps = 1023;          ///< over that range: a 10-bit converter, as P3 names for its sensors
    double fingerLag_s = 0.04; ///< lag of the handle behind the fingers' intention, > 0
    /// Largest speed, > 0: open to closed in a quarter of a second.
    double fingerSpeed_rad_per_s = 6.0;

    double resolution_rad() const noexcept { return widest_rad / steps; }
};

/// A grasper's jaw as the hand moves it: a rate-limited first-order lag,
///   x˙ = clamp((x_d − x)/T, ±v_max),  0 ≤ x ≤ x_max,
/// read once per tick by a potentiometer without noise and with the same delay as the device's encoders. It
/// has no motor (P2): a squeezed object does not push back. The same intentions give the same counts. Source:
/// P2, "Analogue Clamping".
/// Thread: haptic; allocates nothing.
class Jaw {
public:
    Jaw(const JawParameters& parameters, int delay_ticks) noexcept
        : m_parameters(parameters), m_potentiometer({parameters.resolution_rad()}, delay_ticks) {}

    void reset() noexcept { ///< closed, and settled there
        m_angle_rad = 0.0;
        m_potentiometer.settle({0.0});
    }
    /// Advances by one tick towards the angle that the fingers want, rad.
    void advance(double wanted_rad) noexcept {
        const double wanted = std::clamp(wanted_rad, 0.0, m_parameters.widest_rad);
        const double speed =
            std::clamp((wanted - m_angle_rad) / m_parameters.fingerLag_s, -m_parameters.fingerSpeed_rad_per_s,
                       m_parameters.fingerSpeed_rad_per_s);
        m_angle_rad = std::clamp(m_angle_rad + core::kTickSeconds * speed, 0.0, m_parameters.widest_rad);
        m_potentiometer.push({m_angle_rad});
    }
    double angle_rad() const noexcept { return m_angle_rad; } ///< the true angle
    std::int32_t counts() const noexcept { return m_potentiometer.counts()[0]; }

private:
    JawParameters m_parameters;
    EncoderLine<1> m_potentiometer;
    double m_angle_rad = 0.0;
};

} // namespace chiron::mechanisms
