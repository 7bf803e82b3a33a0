// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/grasp_report_of.h"

#include "curriculum/exercises/object_handling/scoring/handling_samples.h"
#include "scoring/score_calculator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::session_report {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kSamplesPerPoint = 10; // 1 kHz -> 100 Hz

report::TrialOutcome outcomeOf(const scoring::TrialTrace& trial) {
    return trial.completed  ? report::TrialOutcome::done
           : trial.failed   ? report::TrialOutcome::failed
           : trial.timedOut ? report::TrialOutcome::timedOut
                            : report::TrialOutcome::unfinished;
}

std::optional<double> truthIn(const scoring::TrialTrace& trial, const char* id) {
    for (const scoring::NamedValue& value : trial.truth)
        if (value.id == id)
            return value.value;
    return std::nullopt;
}

const std::vector<double>* quantityIn(const scoring::TrialTrace& trial, const char* id) {
    if (trial.tools.empty())
        return nullptr;
    for (const scoring::QuantityTrace& quantity : trial.quantities)
        if (quantity.id == id && quantity.values.size() == trial.tools.front().t_s.size())
            return &quantity.values;
    return nullptr;
}

/// Each trial's own values of some metrics, in the version that the level scores them by.
class TrialScores {
public:
    TrialScores(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level, std::initializer_list<const char*> ids) {
        std::vector<scoring::MetricRequest> requests;
        for (const char* id : ids) {
            const auto chosen = std::find_if(level.metrics.begin(), level.metrics.end(), [id](const auto& metric) { return metric.id == id; });
            requests.push_back({id, chosen == level.metrics.end() ? 0 : chosen->version});
        }
        if (auto card = scoring::calculateScore(trace, requests, {}, false))
            m_trials = std::move(card->trials);
    }
    std::optional<double> of(std::size_t trial, const char* id) const {
        if (trial >= m_trials.size())
            return std::nullopt;
        const auto found = std::find_if(m_trials[trial].begin(), m_trials[trial].end(), [id](const auto& value) { return value.id == id; });
        return found == m_trials[trial].end() ? std::nullopt : found->value;
    }

private:
    std::vector<std::vector<scoring::MetricValue>> m_trials;
};

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

    void add(const scoring::TrialTrace& trial) {
        const std::vector<double>* tension = quantityIn(trial, "tension_N");
        const std::vector<double>* stretch = quantityIn(trial, "stretch_m");
        if (tension == nullptr || stretch == nullptr || tension->empty())
            return;
        const std::vector<double>* retraction = quantityIn(trial, "retraction_N");
        const scoring::ToolTrace& tool = trial.tools.front();
        const auto target = truthIn(trial, "target_N");
        const auto band = truthIn(trial, "band_N");
        const auto mark = truthIn(trial, "mark_m");
        const auto tolerance = truthIn(trial, "mark_tolerance_m");
        for (std::size_t i = 0; i < tension->size(); i += kSamplesPerPoint) {
            const std::size_t end = std::min(i + kSamplesPerPoint, tension->size());
            point(tool.t_s[i], farthest(*tension, i, end), 1e3 * farthest(*stretch, i, end));
            m_tube.retraction_N.push_back(retraction ? farthest(*retraction, i, end) : kNothing);
            m_tube.bandLow_N.push_back(target && band ? *target - *band : kNothing);
            m_tube.bandHigh_N.push_back(target && band ? *target + *band : kNothing);
            m_tube.markLow_mm.push_back(mark && tolerance ? 1e3 * (*mark - *tolerance) : kNothing);
            m_tube.markHigh_mm.push_back(mark && tolerance ? 1e3 * (*mark + *tolerance) : kNothing);
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
    /// Nothing joins one trial to the next.
    void gap(double t_s) {
        point(t_s, kNothing, kNothing);
        for (auto* values : {&m_tube.retraction_N, &m_tube.bandLow_N, &m_tube.bandHigh_N, &m_tube.markLow_mm, &m_tube.markHigh_mm})
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

/// Where the trial's object lay at its end.
void addPlace(const scoring::TrialTrace& trial, report::HandlingTrialRow& row) {
    scoring::PreparedTrial prepared; // of which the answer reads quantities and truth alone
    prepared.trial = &trial;
    prepared.tool = &trial.tools.front();
    const auto answer = scoring::answerOf(prepared);
    const auto x_m = truthIn(trial, "target_x_m");
    const auto y_m = truthIn(trial, "target_y_m");
    if (!answer || !x_m || !y_m)
        return;
    const std::string body = "body_" + std::to_string(answer->number);
    const std::vector<double>* bodyX = quantityIn(trial, (body + "_x_m").c_str());
    const std::vector<double>* bodyY = quantityIn(trial, (body + "_y_m").c_str());
    if (bodyX == nullptr || bodyY == nullptr || bodyX->empty())
        return;
    row.taken = answer->taken;
    row.x_mm = 1e3 * (bodyX->back() - *x_m);
    row.y_mm = 1e3 * (bodyY->back() - *y_m);
    row.fromTarget_mm = 1e3 * answer->fromTarget_m;
    const auto task = truthIn(trial, "task");
    const auto heaviest = truthIn(trial, "heaviest");
    if (task && heaviest && static_cast<simulation::HandlingTask>(static_cast<int>(*task)) == simulation::HandlingTask::weigh && trial.completed)
        row.heaviest = answer->number == static_cast<int>(*heaviest);
}

} // namespace

report::TubeReport tubeReportOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) {
    report::TubeReport tube;
    const TrialScores scores(trace, level, {"tension_error_rms", "time_in_band", "over_stretches", "drops", "retraction_time_in_band"});
    TubeSeries series(tube);
    for (std::size_t i = 0; i < trace.trials.size(); ++i) {
        const scoring::TrialTrace& trial = trace.trials[i];
        if (trial.tools.empty() || trial.tools.front().t_s.empty())
            continue;
        tube.trialStart_s.push_back(trial.tools.front().t_s.front());
        tube.rows.push_back({trial.trial, outcomeOf(trial), truthIn(trial, "target_N"), scores.of(i, "tension_error_rms"),
                             scores.of(i, "time_in_band"), 1e3 * largestOf(quantityIn(trial, "stretch_m")), scores.of(i, "over_stretches"),
                             scores.of(i, "drops"), scores.of(i, "retraction_time_in_band")});
        tube.retractionLow_N = truthIn(trial, "retraction_low_N").value_or(0.0);
        tube.retractionHigh_N = truthIn(trial, "retraction_high_N").value_or(0.0);
        tube.overStretch_mm = 1e3 * truthIn(trial, "over_stretch_m").value_or(0.0);
        series.add(trial);
    }
    return tube;
}

report::HandlingReport handlingReportOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) {
    report::HandlingReport handling;
    const TrialScores scores(trace, level, {"squeeze_max", "squeeze_time_over_limit"});
    for (std::size_t i = 0; i < trace.trials.size(); ++i) {
        const scoring::TrialTrace& trial = trace.trials[i];
        if (trial.tools.empty() || trial.tools.front().t_s.empty())
            continue;
        report::HandlingTrialRow row;
        row.trial = trial.trial;
        row.outcome = outcomeOf(trial);
        row.squeezeMax_N = scores.of(i, "squeeze_max");
        row.overLimit_s = scores.of(i, "squeeze_time_over_limit");
        addPlace(trial, row);
        handling.squeezeLimit_N = truthIn(trial, "squeeze_limit_N").value_or(0.0);
        handling.targetRadius_mm = 1e3 * truthIn(trial, "target_radius_m").value_or(0.0);
        handling.rows.push_back(row);
    }
    return handling;
}

} // namespace chiron::session_report
