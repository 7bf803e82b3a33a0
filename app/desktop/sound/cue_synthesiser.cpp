// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sound/cue_synthesiser.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kSilence = 1e-4;   // a lower level counts as silence
constexpr double kFollow_s = 0.006; // time constant with which levels and pitch approach their targets
constexpr double kClickDecay_s = 0.012;
constexpr double kTouch_Hz = 220.0;
constexpr double kClick_Hz = 1500.0;
constexpr double kWarning_Hz = 988.0; // far from the tone's octaves
constexpr double kBeat_Hz = 5.0;
constexpr double kFirstForce_N = 0.02; // a smaller force counts as no contact
constexpr double kLoudestShare = 3.0;  // pitch stops rising at three times the limit
// Corner frequency of the lowest first-order filter; the others follow by a constant ratio.
constexpr double kLowestNoise_Hz = 60.0;
constexpr double kNoiseRatio = 2.83;
constexpr double kBrightest = 0.4; // share of the tone that its third harmonic takes at full lean

/// One step from `level` towards `target`. The remainder of a fading sound becomes exactly zero.
double followed(double level, double target, double share) noexcept {
    const double next = level + share * (target - level);
    return target < kSilence && next < kSilence ? 0.0 : next;
}

} // namespace

CueSynthesiser::CueSynthesiser(double rate_Hz)
    : m_rate_Hz(std::max(rate_Hz, 8000.0)), m_follow(1.0 - std::exp(-1.0 / (kFollow_s * m_rate_Hz))),
      m_clickDecay(std::exp(-1.0 / (kClickDecay_s * m_rate_Hz))) {
    for (std::size_t i = 0; i < kNoisePoles; ++i)
        m_noiseShare[i] = 1.0 - std::exp(-kTwoPi * kLowestNoise_Hz *
                                         std::pow(kNoiseRatio, static_cast<double>(i)) / m_rate_Hz);
}

void CueSynthesiser::set(const SoundCues& cues) noexcept {
    m_cues = cues;
    m_cues.limit_N = std::isfinite(cues.limit_N) && cues.limit_N > 0.0 ? cues.limit_N : 4.0;
    m_cues.force_N = std::isfinite(cues.force_N) ? std::max(cues.force_N, 0.0) : 0.0;
    m_cues.masking = std::isfinite(cues.masking) ? std::clamp(cues.masking, 0.0, 1.0) : 0.0;
    if (m_cues.masking > 0.0)
        m_cues.on = {.contact = false, .force = false, .lean = false, .warning = false};
    m_cues.lean = std::isfinite(cues.lean) ? std::clamp(cues.lean, 0.0, 1.0) : 0.0;
    if (cues.contacts != m_heard && cues.audible && cues.on.contact && !m_first)
        m_clickTarget = kClickPeak;
    m_heard = cues.contacts;
    m_first = false;
}

void CueSynthesiser::render(std::span<float> samples) noexcept {
    for (float& sample : samples)
        sample = next();
}

float CueSynthesiser::next() noexcept {
    return static_cast<float>(tone() + click() + warning() + masking());
}

double CueSynthesiser::masking() noexcept {
    m_maskingLevel = followed(m_maskingLevel, m_cues.audible ? kMaskingPeak * m_cues.masking : 0.0, m_follow);
    if (m_maskingLevel == 0.0)
        return 0.0;
    m_noise ^= m_noise << 13;
    m_noise ^= m_noise >> 7;
    m_noise ^= m_noise << 17;
    const double white = 2.0 * static_cast<double>(m_noise >> 11) / 9007199254740992.0 - 1.0;
    double pink = 0.0;
    // A first-order filter with coefficient a passes a / (2 - a) of the power.
    for (std::size_t i = 0; i < kNoisePoles; ++i) {
        const double share = m_noiseShare[i];
        m_noisePole[i] += share * (white - m_noisePole[i]);
        pink += m_noisePole[i] * std::sqrt((2.0 - share) / share);
    }
    constexpr double kHeadroom = 0.06;
    return m_maskingLevel * std::clamp(kHeadroom * pink, -1.0, 1.0);
}

double CueSynthesiser::sine(double& phase, double frequency_Hz) const noexcept {
    phase += frequency_Hz / m_rate_Hz;
    phase -= std::floor(phase);
    return std::sin(kTwoPi * phase);
}

double CueSynthesiser::tone() noexcept {
    const double share = std::min(m_cues.force_N / m_cues.limit_N, kLoudestShare);
    const bool sounds = m_cues.audible && m_cues.on.force && m_cues.force_N > kFirstForce_N;
    const double level = sounds ? kTonePeak * (0.35 + 0.65 * std::min(share, 1.0)) : 0.0;
    m_toneLevel = followed(m_toneLevel, level, m_follow);
    if (sounds)
        m_toneFrequency_Hz += m_follow * (kTouch_Hz * std::exp2(2.0 * share) - m_toneFrequency_Hz);
    m_brightness =
        followed(m_brightness, sounds && m_cues.on.lean ? kBrightest * m_cues.lean : 0.0, m_follow);
    if (m_toneLevel == 0.0) {
        m_tonePhase = 0.0;
        return 0.0;
    }
    const double ground = sine(m_tonePhase, m_toneFrequency_Hz);
    return m_toneLevel *
           ((1.0 - m_brightness) * ground + m_brightness * std::sin(3.0 * kTwoPi * m_tonePhase));
}

double CueSynthesiser::click() noexcept {
    m_clickTarget *= m_clickDecay;
    // The level rises twice as fast as it follows other targets, which keeps the click short; the level and
    // the sine both start at 0.
    m_clickLevel = followed(m_clickLevel, m_clickTarget, 2.0 * m_follow);
    if (m_clickLevel == 0.0 && m_clickTarget < kSilence) {
        m_clickTarget = 0.0;
        m_clickPhase = 0.0;
        return 0.0;
    }
    return m_clickLevel * sine(m_clickPhase, kClick_Hz);
}

double CueSynthesiser::warning() noexcept {
    const bool sounds = m_cues.audible && m_cues.on.warning && m_cues.force_N > m_cues.limit_N;
    const bool beat = m_beatPhase < 0.5;
    const double target = sounds && beat ? kWarningPeak : 0.0;
    m_warningLevel = followed(m_warningLevel, target, m_follow);
    if (sounds) {
        m_beatPhase += kBeat_Hz / m_rate_Hz;
        m_beatPhase -= std::floor(m_beatPhase);
    } else {
        m_beatPhase = 0.0; // so that the next warning starts with an audible beat
    }
    if (m_warningLevel == 0.0) {
        m_warningPhase = 0.0;
        return 0.0;
    }
    return m_warningLevel * sine(m_warningPhase, kWarning_Hz);
}

} // namespace chiron::desktop
