// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_cues.h"

#include <array>
#include <cstdint>
#include <span>

namespace chiron::desktop {

/// Turns cues into samples. Contact begins with a click. A tone rises in pitch with force (220 Hz at first
/// touch, one octave per half of the limit) and becomes brighter as the force leans (through its third
/// harmonic, so that it is neither a second voice nor a change of pitch). A warning tone pulses while the
/// force is above the limit. All levels and pitches are assumptions, chosen to be distinguishable at low
/// volume. Each sound level approaches its target through a first-order filter with a time constant of a few
/// milliseconds, so that a change is not audible as a click. The peaks of the parts add up to less than 1, so
/// that nothing clips; at rest the samples are exactly 0. Masking replaces the cues with pink noise (white
/// noise through first-order filters an octave and a half apart, each passing its share of power).
/// Thread: one, the audio callback's; render() uses no Qt, takes no lock and allocates nothing.
class CueSynthesiser {
public:
    explicit CueSynthesiser(double rate_Hz);

    void set(const SoundCues& cues) noexcept;
    /// Mono samples, -1..1.
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
    double m_follow;     ///< filter coefficient per sample
    double m_clickDecay; ///< per sample
    SoundCues m_cues;
    std::uint32_t m_heard = 0; ///< number of contacts that have already clicked
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
    /// State of the xorshift generator: the same noise in each run.
    std::uint64_t m_noise = 0x9E3779B97F4A7C15ULL;
    std::array<double, kNoisePoles> m_noisePole{};
    std::array<double, kNoisePoles> m_noiseShare{};
};

} // namespace chiron::desktop
