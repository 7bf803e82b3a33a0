// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_cues.h"

#include <array>
#include <cstdint>
#include <span>

namespace chiron::desktop {

/// Turns cues into samples: a click when contact begins, a tone whose pitch rises with force (220 Hz at first touch, an
/// octave each half of the limit) and which turns brighter as the force leans (its third harmonic, so that it is neither a second
/// voice nor a change of pitch), a warning of two beats a tone above the limit. All levels and pitches are assumptions,
/// chosen to be told apart at low volume. Every level follows its target through a one-pole of some milliseconds, so that
/// nothing jumps; the parts' peaks add up to less than 1, so that nothing clips; at rest the samples are exactly 0.
/// Masking is pink noise (white noise through one-poles an octave and a half apart, each passing its share of power) instead of the cues.
/// No Qt, no lock, no allocation: render() is called by the audio callback. One thread.
class CueSynthesiser {
public:
    explicit CueSynthesiser(double rate_Hz);

    void set(const SoundCues& cues) noexcept;
    /// Mono, -1..1.
    void render(std::span<float> samples) noexcept;

    static constexpr double kTonePeak = 0.28;
    static constexpr double kClickPeak = 0.32;
    static constexpr double kWarningPeak = 0.30;
    static constexpr double kMaskingPeak = 0.70;

private:
    float next() noexcept;
    double click() noexcept;
    double tone() noexcept;
    double warning() noexcept;
    double masking() noexcept;
    double sine(double& phase, double frequency_Hz) const noexcept;

    double m_rate_Hz;
    double m_follow;      ///< one-pole share a sample
    double m_clickDecay;  ///< a sample
    SoundCues m_cues;
    std::uint32_t m_heard = 0; ///< contacts that have clicked
    bool m_first = true;

    double m_toneLevel = 0.0;
    double m_toneFrequency_Hz = 220.0;
    double m_tonePhase = 0.0;
    double m_brightness = 0.0; ///< share of the third harmonic
    double m_clickLevel = 0.0;
    double m_clickTarget = 0.0;
    double m_clickPhase = 0.0;
    double m_warningLevel = 0.0;
    double m_warningPhase = 0.0;
    double m_beatPhase = 0.0;
    static constexpr std::size_t kNoisePoles = 6;
    double m_maskingLevel = 0.0;
    std::uint64_t m_noise = 0x9E3779B97F4A7C15ULL; ///< xorshift state: the same noise in each run
    std::array<double, kNoisePoles> m_noisePole{};
    std::array<double, kNoisePoles> m_noiseShare{};
};

} // namespace chiron::desktop
