// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::haptics {

/// Commanded force and tool position along one line, per tick, for the analysed second of each burst. The
/// record is written in the tick, where it never grows: samples beyond the reserved room are left out.
struct DelayRecord {
    static constexpr int kWindow_ticks = 1000;
    /// Frequencies of the sines. Each has whole periods in a window, lies above a hand's tremor (8-12 Hz) and
    /// above the oscillation of its grip, and is farther from its neighbours than the two bins of a Hann
    /// window.
    static constexpr std::array<double, 9> kFrequencies_Hz{31, 37, 45, 53, 63, 75, 89, 103, 120};

    void reserve(int bursts) {
        const auto size = static_cast<std::size_t>(bursts) * kWindow_ticks;
        force_N.assign(size, 0.0);
        place_m.assign(size, 0.0);
        broken.assign(static_cast<std::size_t>(bursts), 0);
        places = forces = 0;
        damped = 0;
    }
    void place(double x_m) noexcept {
        if (places < place_m.size())
            place_m[places++] = x_m;
        writing = true;
    }
    /// `inTime`: no tick was skipped since the one before.
    void force(double f_N, bool inTime) noexcept {
        if (forces >= force_N.size())
            return;
        if (!inTime && forces % kWindow_ticks != 0)
            broken[forces / kWindow_ticks] = 1;
        force_N[forces++] = f_N;
    }

    std::vector<double> force_N, place_m;
    std::vector<std::uint8_t> broken;   ///< bursts in which ticks were skipped: their samples are not evenly
                                        ///< spaced in time
    std::size_t places = 0, forces = 0; ///< numbers of samples written
    int damped = 0;                     ///< ticks in which the passivity stage took part of the force
    bool writing = false;               ///< this tick's position was written, so its force belongs here as
                                        ///< well
};

/// Delay of the loop through a device, and the mass that moved.
struct DelayEstimate {
    /// t_d of devices.md §6: from a command to the samples that show its effect, beyond the half tick of the
    /// hold.
    double delay_s = 0.0;
    double standardError_s = 0.0; ///< jackknife over the bursts
    /// Moving mass at these frequencies: the tool, the device and the part of the hand that moves with them.
    double mass_kg = 0.0;
    int bursts = 0;
};

/// Estimates t_d from the frequency response. With X and F the Fourier coefficients of position and command
/// at each sine,
///   F/X = (k − m ω² + j (b ω + e/ω)) e^{jω(t_d + T/2)}.
/// Whatever tool and hand weigh, a delay turns the phase by more at higher frequencies, and nothing else
/// does. m is the tool's mass, k and b are stiffness and damping of tool and grip, and e is the first term
/// that a hand behind a compliant grip adds (for a hand of mass M behind a grip K, B: e = 2 K B/M). For each
/// t_d up to 25 ms, weighted least squares gives k, m, b and e, with weights from the scatter between bursts;
/// the estimate is the t_d with the smallest residual. No force sensor is needed. A motor's lag counts as
/// delay as far as it turns phases like one: a lag of 0.3 ms counts in full, one of 1 ms as 0.7 ms. Not for
/// the tick.
///
/// Source: devices.md §6 (delay and stiffness); frequency domain identification with a multisine: Pintelon &
/// Schoukens, System Identification (2012), ch. 2; the model of tool, grip and hand is ours.
/// Errors: badInput for fewer than 3 whole bursts without skipped ticks, or values that are not finite;
/// doesNotHold, with the reason, if nothing moved, if noise hides the response (standard error above 0.5 ms),
/// or if the response is not that of a mass (a clamped tool).
core::Result<DelayEstimate> estimateDelay(const DelayRecord& record);

} // namespace chiron::haptics
