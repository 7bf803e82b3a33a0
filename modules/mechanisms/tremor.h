// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"

#include <array>

namespace chiron::mechanisms {

/// Physiological tremor: per axis six sines with frequencies drawn uniformly from 8–12 Hz and random phases,
/// so that the displacement is strictly band-limited and has the requested long-run rms. Each sine is a
/// rotating phasor (no sin or cos per tick), whose velocity and acceleration are exact.
class Tremor {
public:
    Tremor(double rmsPerAxis_m, core::Random random) noexcept;
    void advance() noexcept; ///< advances by one tick of 1 ms
    const core::Vec3& displacement_m() const noexcept { return m_displacement; }
    const core::Vec3& velocity() const noexcept { return m_velocity; }         ///< m/s
    const core::Vec3& acceleration() const noexcept { return m_acceleration; } ///< m/s²

private:
    static constexpr int kSines = 6;
    struct Phasor {
        double re = 0.0, im = 0.0; ///< amplitude included
        double c = 1.0, s = 0.0;   ///< rotation per tick
        double omega = 0.0;        ///< rad/s
    };
    void sum() noexcept;
    std::array<std::array<Phasor, kSines>, 3> m_phasors{};
    core::Vec3 m_displacement = core::Vec3::Zero();
    core::Vec3 m_velocity = core::Vec3::Zero();
    core::Vec3 m_acceleration = core::Vec3::Zero();
};

} // namespace chiron::mechanisms
