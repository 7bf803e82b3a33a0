// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/session_report/tube_report_of.h"

#include "curriculum/exercises/elastic_tube/scoring/tube_truth.h"
#include "session_report/trial_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::session_report {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kSamplesPerPoint = 10; // 1 kHz -> 100 Hz

/// The value farthest from zero among samples [from, to).
double farthest(const std::vector<double>& values, std::size_t from, std::size_t to) {
    double found = values[from];
    for (std::size_t i = from; i < to; ++i)
        if (std::abs(values[i]) > std::abs(found))
            found = values[i];
    return found;
}

/// Adds a trial's samples to the series of a tube.
class TubeSeries {
public:
    explicit TubeSeries(report::TubeReport& tube) : m_tube(tube) {}

    void add(const scoring::TrialTrace& trial, const scoring::TubeTruth& truth) {
        const std::vector<double>* tension = quantityIn(trial, "tension_N");
        const std::vector<double>* stretch = quantityIn(trial, "stretch_m");
        if (tension == nullptr || stretch == nullptr || tension->empty())
            return;
        const std::vector<double>* retraction = quantityIn(trial, "retraction_N");
        const scoring::ToolTrace& tool = trial.tools.front();
        const bool band = truth.target_N && truth.band_N, mark = truth.mark_m && truth.markTolerance_m;
        for (std::size_t i = 0; i < tension->size(); i += kSamplesPerPoint) {
            const std::size_t end = std::min(i + kSamplesPerPoint, tension->size());
            point(tool.t_s[i], farthest(*tension, i, end), 1e3 * farthest(*stretch, i, end));
            m_tube.retraction_N.push_back(retraction ? farthest(*retraction, i, end) : kNothing);
            m_tube.bandLow_N.push_back(band ? *truth.target_N - *truth.band_N : kNothing);
            m_tube.bandHigh_N.push_back(band ? *truth.target_N + *truth.band_N : kNothing);
            m_tube.markLow_mm.push_back(mark ? 1e3 * (*truth.mark_m - *truth.markTolerance_m) : kNothing);
            m_tube.markHigh_mm.push_back(mark ? 1e3 * (*truth.mark_m + *truth.markTolerance_m) : kNothing);
        }
        gap(tool.t_s.back());
        notePauses(tool);
    }

private:
    void point(double t_s, double tension_N, double stretch_mm) {
        m_tube.t_s.push_back(t_s);
        m_tube.tension_N.push_back(tension_N);
        m_tube.stretch_mm.push_back(stretch_mm);
    }
    /// Adds a gap, so that no line joins one trial to the next.
    void gap(double t_s) {
        point(t_s, kNothing, kNothing);
        for (auto* values : {&m_tube.retraction_N, &m_tube.bandLow_N, &m_tube.bandHigh_N, &m_tube.markLow_mm,
                             &m_tube.markHigh_mm})
            values->push_back(kNothing);
    }
    void notePauses(const scoring::ToolTrace& tool) {
        bool open = false;
        for (std::size_t i = 0; i < tool.paused.size() && i < tool.t_s.size(); ++i) {
            const bool paused = tool.paused[i] != 0;
            if (paused && !open)
                m_tube.paused.push_back({tool.t_s[i], tool.t_s[i]});
            if (paused)
                m_tube.paused.back().end_s = tool.t_s[i];
            open = paused;
        }
    }

    report::TubeReport& m_tube;
};

double largestOf(const std::vector<double>* values) {
    return values == nullptr || values->empty() ? 0.0 : *std::max_element(values->begin(), values->end());
}

} // namespace

report::TubeReport tubeReportOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) {
    report::TubeReport tube;
    const TrialScores scores(
        trace, level,
        {"tension_error_rms", "time_in_band", "over_stretches", "drops", "retraction_time_in_band"});
    TubeSeries series(tube);
    for (std::size_t i = 0; i < trace.trials.size(); ++i) {
        const scoring::TrialTrace& trial = trace.trials[i];
        if (trial.tools.empty() || trial.tools.front().t_s.empty())
            continue;
        const scoring::TubeTruth truth = scoring::tubeTruthIn(trial);
        tube.trialStart_s.push_back(trial.tools.front().t_s.front());
        tube.rows.push_back({trial.trial, outcomeOf(trial), truth.target_N, scores.of(i, "tension_error_rms"),
                             scores.of(i, "time_in_band"), 1e3 * largestOf(quantityIn(trial, "stretch_m")),
                             scores.of(i, "over_stretches"), scores.of(i, "drops"),
                             scores.of(i, "retraction_time_in_band")});
        tube.retractionLow_N = truth.retractionLow_N.value_or(0.0);
        tube.retractionHigh_N = truth.retractionHigh_N.value_or(0.0);
        tube.overStretch_mm = 1e3 * truth.overStretch_m.value_or(0.0);
        series.add(trial, truth);
    }
    return tube;
}

} // namespace chiron::session_report
