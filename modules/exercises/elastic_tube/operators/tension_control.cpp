// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/elastic_tube/operators/tension_control.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

namespace {
// Habits that all operators share: assumptions.
constexpr double kForget = 0.985;     ///< share of past observations that is kept per observation: 0.7 s
constexpr double kTelling_m = 0.0012; ///< least SD of the length from which a slope can be estimated
constexpr double kSoftest_N_per_m = 15.0, kStiffest_N_per_m = 400.0;
constexpr double kTaut_N = 0.2;      ///< below this tension the tube is not pulled yet
constexpr double kPatience_s = 0.8;  ///< time without counting before it searches for the tension again
constexpr double kFeltBand_N = 0.10; ///< half width of the range that feels the same to it
constexpr double kSweep_s = 3.0;     ///< searches in one direction for this time, then in the other
} // namespace

void StiffnessSense::begin() noexcept {
    m_weight = m_length = m_tension = m_spread = m_both = 0.0;
    m_slope = m_assumed;
}

void StiffnessSense::notice(double length_m, double tension_N) noexcept {
    m_weight = kForget * m_weight + 1.0;
    const double share = 1.0 / m_weight;
    const double off_m = length_m - m_length, off_N = tension_N - m_tension;
    m_length += share * off_m;
    m_tension += share * off_N;
    m_spread = (1.0 - share) * (m_spread + share * off_m * off_m);
    m_both = (1.0 - share) * (m_both + share * off_m * off_N);
    if (m_spread > kTelling_m * kTelling_m && m_both > 0.0)
        m_slope = std::clamp(m_both / m_spread, kSoftest_N_per_m, kStiffest_N_per_m);
}

void TensionControl::begin() noexcept {
    m_stiffness.begin();
    m_dwell = 0.0;
    m_counted_s = m_lost_s = -1.0;
    m_remembered_N = 0.0;
}

void TensionControl::look(const TensionView& view) noexcept {
    if (view.tension_N > kTaut_N)
        m_stiffness.notice(view.length_m, view.tension_N);
    const bool counts = view.dwell > m_dwell + 1e-9;
    if (counts) {
        // average of the felt tension while the screen counts, over a second
        m_remembered_N =
            m_remembered_N > 0.0 ? m_remembered_N + 0.01 * (view.tension_N - m_remembered_N) : view.tension_N;
        m_counted_s = view.time_s;
        m_lost_s = -1.0;
    } else if (m_lost_s < 0.0) {
        m_lost_s = view.time_s;
    }
    m_dwell = view.dwell;
}

double TensionControl::speed_m_per_s(const TensionView& view) noexcept {
    const bool shown = view.high_N > 0.0;
    double speed =
        shown ? correct(0.5 * (view.low_N + view.high_N) - view.tension_N, 0.5 * (view.high_N - view.low_N))
              : search(view);
    if (view.length_m > m_settings.longestRatio * view.restLength_m)
        speed = std::min(speed, 0.0);
    return speed;
}

double TensionControl::search(const TensionView& view) noexcept {
    if (m_remembered_N <= 0.0) // nothing has counted yet: pull, and more slowly once the tube is taut
        return view.tension_N > kTaut_N ? m_settings.searchSpeed_m_per_s : m_settings.pullSpeed_m_per_s;
    if (m_lost_s < 0.0 || view.time_s - m_lost_s < kPatience_s)
        return correct(m_remembered_N - view.tension_N, kFeltBand_N);
    // It feels right but does not count: try a little more, then a little less.
    const double phase = std::fmod(view.time_s - m_lost_s - kPatience_s, 2.0 * kSweep_s);
    return (phase < kSweep_s ? 0.5 : -0.5) * m_settings.searchSpeed_m_per_s;
}

double TensionControl::correct(double wrong_N, double halfBand_N) const noexcept {
    if (std::abs(wrong_N) < m_settings.deadZone * halfBand_N)
        return 0.0;
    const double k =
        m_settings.learnsStiffness ? m_stiffness.stiffness_N_per_m() : m_settings.assumedStiffness_N_per_m;
    return std::clamp(m_settings.correctionRate_per_s * wrong_N / k, -m_settings.pullSpeed_m_per_s,
                      m_settings.pullSpeed_m_per_s);
}

} // namespace chiron::operators
