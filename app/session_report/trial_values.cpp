// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/trial_values.h"

#include <algorithm>

namespace chiron::session_report {

report::TrialOutcome outcomeOf(const scoring::TrialTrace& trial) {
    return trial.completed  ? report::TrialOutcome::done
           : trial.failed   ? report::TrialOutcome::failed
           : trial.timedOut ? report::TrialOutcome::timedOut
                            : report::TrialOutcome::unfinished;
}

const std::vector<double>* quantityIn(const scoring::TrialTrace& trial, const char* id) {
    if (trial.tools.empty())
        return nullptr;
    for (const scoring::QuantityTrace& quantity : trial.quantities)
        if (quantity.id == id && quantity.values.size() == trial.tools.front().t_s.size())
            return &quantity.values;
    return nullptr;
}

TrialScores::TrialScores(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level,
                         std::initializer_list<const char*> ids) {
    std::vector<scoring::MetricRequest> requests;
    for (const char* id : ids) {
        const auto chosen = std::find_if(level.metrics.begin(), level.metrics.end(),
                                         [id](const auto& metric) { return metric.id == id; });
        requests.push_back({id, chosen == level.metrics.end() ? 0 : chosen->version});
    }
    if (auto card = scoring::calculateScore(trace, requests, {}, false))
        m_trials = std::move(card->trials);
}

std::optional<double> TrialScores::of(std::size_t trial, const char* id) const {
    if (trial >= m_trials.size())
        return std::nullopt;
    const auto found = std::find_if(m_trials[trial].begin(), m_trials[trial].end(),
                                    [id](const auto& value) { return value.id == id; });
    return found == m_trials[trial].end() ? std::nullopt : found->value;
}

} // namespace chiron::session_report
