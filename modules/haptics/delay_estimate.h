// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::haptics {

/// Force and place along one line, tick by tick, of the analysed second of each burst. Written in the tick, where it never grows: what is
/// beyond the room is left out.
struct DelayRecord {
    static constexpr int kWindow_ticks = 1000;
    /// Whole periods in a window, above a hand's tremor (8-12 Hz) and what its grip swings with, and more than a Hann window's two bins apart.
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
    /// `inTime`: no tick was left out since the one before.
    void force(double f_N, bool inTime) noexcept {
        if (forces >= force_N.size())
            return;
        if (!inTime && forces % kWindow_ticks != 0)
            broken[forces / kWindow_ticks] = 1;
        force_N[forces++] = f_N;
    }

    std::vector<double> force_N, place_m;
    std::vector<std::uint8_t> broken;   ///< a burst in which ticks were left out: its time is not that of its samples
    std::size_t places = 0, forces = 0; ///< written
    int damped = 0;                     ///< ticks in which the passivity stage took part of the force
    bool writing = false;               ///< this tick's place was written, so its force belongs here as well
};

/// Delay of the loop through a device, and of what it moved.
struct DelayEstimate {
    double delay_s = 0.0;         ///< t_d of devices.md §6: from a command to what the samples show of it, beyond the half tick of the hold
    double standardError_s = 0.0; ///< jackknife over the bursts
    double mass_kg = 0.0;         ///< that moves at these frequencies: the tool, the device and what of the hand goes along
    int bursts = 0;
};

/// t_d from the frequency response: with X and F the Fourier coefficients of place and command at each sine,
///   F/X = (k − m ω² + j (b ω + e/ω)) e^{jω(t_d + T/2)},
/// that is, whatever tool and hand weigh, a delay turns the phase by more the higher the frequency, and nothing else does. m is the tool's
/// mass, k and b are those of tool and grip, and e is the first term of what a hand behind a yielding grip adds (for a hand of mass M
/// behind a grip K, B: e = 2 K B/M). k, m, b and e follow by weighted least squares for each t_d up to 25 ms, weights from the scatter
/// between bursts; t_d is where the rest is least. Needs no force sensor. A motor's lag counts as delay as far as it turns phases as one: of
/// 0.3 ms all, of 1 ms 0.7. Not for the tick.
/// Failure: badInput for fewer than 3 whole bursts with all their ticks, or what is not finite; doesNotHold where nothing moved, the answer drowns in noise
/// (standard error above 0.5 ms) or is none of a mass (a tool that is clamped), naming which.
/// Source: devices.md §6 (delay and stiffness); frequency domain identification with a multisine: Pintelon & Schoukens,
/// System Identification (2012), ch. 2; the model of tool, grip and hand is ours.
core::Result<DelayEstimate> estimateDelay(const DelayRecord& record);

} // namespace chiron::haptics
