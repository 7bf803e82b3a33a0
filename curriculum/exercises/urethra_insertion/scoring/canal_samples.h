// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/urethra_insertion/scoring/canal_reasons.h"
#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace chiron::scoring {

/// Returns the reason why there is nothing to measure if any trial lacks its canal: a session's value must
/// not silently leave trials out.
inline std::optional<Measurement> withoutCanal(std::span<const PreparedTrial> trials) {
    if (trials.empty())
        return Measurement::undefined(reasons::kNoTrials);
    for (const PreparedTrial& trial : trials)
        if (trial.tool == nullptr || insertionOf(*trial.trial) == nullptr)
            return Measurement::undefined(reasons::kNoInsertionData);
    return std::nullopt;
}

inline bool isStage(const InsertionSeries& series, std::size_t i, simulation::ProcedureStage stage) {
    return series.stage[i] == static_cast<std::uint8_t>(stage);
}

/// Returns whether the tip is in the urethra, 0 ≤ s ≤ L, in either direction of travel.
inline bool isInUrethra(const InsertionSeries& series, std::size_t i) {
    return series.s_m[i] >= 0.0 && series.s_m[i] <= series.length_m;
}

/// Half the length of the stretch that counts as the bend, where the bend's forces set in (models.md §1.2,
/// a_i).
inline constexpr double kBendHalf_nm = 10e6;

/// Returns whether the tip is within 10 mm of s_B. Compared in whole nm, so that both ends are included.
inline bool isAtBend(const InsertionSeries& series, std::size_t i) {
    return std::abs(std::nearbyint(series.s_m[i] * 1e9) - std::nearbyint(series.bend_m * 1e9)) <=
           kBendHalf_nm;
}

/// Length of the sharpest part of the curve, past the bend: P1's parabola turns there by 36° of its 59°.
inline constexpr double kCurve_m = 0.030;

/// Returns whether the tip is within 30 mm past s_B. Compared in whole nm, so that both ends are included.
inline bool isInCurve(const InsertionSeries& series, std::size_t i) {
    const double past_nm = std::nearbyint(series.s_m[i] * 1e9) - std::nearbyint(series.bend_m * 1e9);
    return past_nm >= 0.0 && past_nm <= kCurve_m * 1e9;
}

/// Calls visit(series, i) for each unpaused sample of tool 0. Requires that withoutCanal() returns none.
template <class Visit> void forEachCanalSample(std::span<const PreparedTrial> trials, Visit&& visit) {
    for (const PreparedTrial& trial : trials) {
        const InsertionSeries& series = *insertionOf(*trial.trial);
        for (std::size_t i = 0; i < trial.tool->t_s.size(); ++i)
            if (trial.tool->paused[i] == 0)
                visit(series, i);
    }
}

/// Root mean square over the added samples. Every sample has the same weight, as in the force metrics.
class RootMeanSquare {
public:
    void add(double value) {
        m_squares += value * value;
        ++m_samples;
    }
    bool empty() const { return m_samples == 0; }
    double value() const { return std::sqrt(m_squares / static_cast<double>(m_samples)); }

private:
    double m_squares = 0.0;
    std::size_t m_samples = 0;
};

inline Measurement neverInUrethra() {
    return Measurement::undefined(reasons::kNeverInUrethra);
}

} // namespace chiron::scoring
