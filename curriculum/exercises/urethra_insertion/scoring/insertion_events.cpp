// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"

#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace chiron::scoring {

namespace {

constexpr std::int64_t kTrauma_us = 20'000;        // models.md §6
constexpr double kRearmShare = 0.8;                // models.md §6
constexpr std::int64_t kHysteresis_nm = 1'000'000; // 1 mm: ten times the tremor of models.md §4

/// Convert to whole µs and nm, so that thresholds are met exactly and not to within a rounding error.
std::int64_t microseconds(double t_s) {
    return std::llround(t_s * 1e6);
}
std::int64_t nanometres(double s_m) {
    return std::llround(s_m * 1e9);
}

class TraumaCounter {
public:
    TraumaCounter(double limit_N, std::vector<InsertionEvent>& found) : m_limit_N(limit_N), m_found(found) {}

    void add(double t_s, double force_N) {
        hold(t_s);
        if (m_armed) {
            const bool over = force_N > m_limit_N;
            if (over && !m_over) {
                m_since_s = t_s;
                m_peak_N = 0.0;
            }
            m_peak_N = std::max(m_peak_N, force_N);
            m_over = over;
            return;
        }
        m_armed = force_N < kRearmShare * m_limit_N;
        if (m_open) {
            m_found.back().end_s = t_s;
            if (!m_armed)
                m_found.back().value = std::max(m_found.back().value, force_N);
        }
        m_open = m_open && !m_armed;
    }

    void pause(double t_s) {
        hold(t_s);
        if (m_open)
            m_found.back().end_s = t_s;
        m_open = false;
        m_over = false;
    }

private:
    /// The force of the last sample has held until now.
    void hold(double t_s) {
        if (!m_over || microseconds(t_s) - microseconds(m_since_s) < kTrauma_us)
            return;
        m_found.push_back({m_since_s, t_s, m_peak_N});
        m_over = false;
        m_armed = false;
        m_open = true;
    }

    double m_limit_N;
    std::vector<InsertionEvent>& m_found;
    bool m_armed = true; ///< the force has been below 80 % since the last event
    bool m_open = false; ///< the last event is not over yet
    bool m_over = false; ///< over the limit since m_since_s, but not yet for 20 ms
    double m_since_s = 0.0;
    double m_peak_N = 0.0;
};

class ReversalFinder {
public:
    explicit ReversalFinder(std::vector<InsertionEvent>& found) : m_found(found) {}

    void add(double t_s, double s_m) {
        if (!m_started) {
            m_started = true;
            m_farthest = {t_s, s_m};
        }
        if (!m_back) {
            if (s_m >= m_farthest.s_m)
                m_farthest = {t_s, s_m};
            m_turn = {t_s, s_m};
            m_back = nanometres(m_farthest.s_m) - nanometres(s_m) >= kHysteresis_nm;
        } else if (s_m < m_turn.s_m) {
            m_turn = {t_s, s_m};
        } else if (nanometres(s_m) - nanometres(m_turn.s_m) >= kHysteresis_nm) {
            close();
            m_farthest = {t_s, s_m};
        }
    }

    void stop() {
        if (m_back)
            close();
        m_started = false;
    }

private:
    struct Place {
        double t_s = 0.0;
        double s_m = 0.0;
    };
    void close() {
        m_found.push_back({m_farthest.t_s, m_turn.t_s, m_farthest.s_m - m_turn.s_m});
        m_back = false;
    }

    std::vector<InsertionEvent>& m_found;
    bool m_started = false;
    bool m_back = false;
    Place m_farthest; ///< while the tip goes back: where that began
    Place m_turn;     ///< while the tip goes back: the least depth so far
};

} // namespace

InsertionEvents insertionEvents(const TrialTrace& trial) {
    InsertionEvents events;
    const InsertionSeries* found = insertionOf(trial);
    if (found == nullptr || trial.tools.empty())
        return events;
    const InsertionSeries& series = *found;
    const ToolTrace& tool = trial.tools.front();
    TraumaCounter trauma(series.lateralLimit_N, events.trauma);
    ReversalFinder reversals(events.reversals);
    for (std::size_t i = 0; i < tool.t_s.size(); ++i) {
        if (tool.paused[i] != 0)
            trauma.pause(tool.t_s[i]);
        else
            trauma.add(tool.t_s[i], series.lateral_N[i]);
        const bool inserts =
            series.stage[i] == static_cast<std::uint8_t>(simulation::ProcedureStage::insertion);
        if (tool.paused[i] == 0 && inserts)
            reversals.add(tool.t_s[i], series.s_m[i]);
        else
            reversals.stop();
    }
    reversals.stop();
    return events;
}

std::vector<CriticalSpan> criticalTrauma(const TrialTrace& trial) {
    std::vector<CriticalSpan> spans;
    for (const InsertionEvent& trauma : insertionEvents(trial).trauma)
        if (isCritical(trauma))
            spans.push_back({trauma.begin_s, trauma.end_s});
    return spans;
}

} // namespace chiron::scoring
