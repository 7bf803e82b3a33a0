// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "report/trial_outcome.h"
#include "scoring/score_calculator.h"
#include "scoring/trace.h"

#include <initializer_list>
#include <optional>
#include <vector>

namespace chiron::session_report {

// The values of a trace's trial for a report. Pure functions.

report::TrialOutcome outcomeOf(const scoring::TrialTrace& trial);
/// One value per sample of the first tool; null if it was not recorded in this form.
const std::vector<double>* quantityIn(const scoring::TrialTrace& trial, const char* id);

/// Each trial's own values of some metrics, in the version by which the level scores them.
class TrialScores {
public:
    TrialScores(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level,
                std::initializer_list<const char*> ids);
    /// Empty if the trial has no such value.
    std::optional<double> of(std::size_t trial, const char* id) const;

private:
    std::vector<std::vector<scoring::MetricValue>> m_trials;
};

} // namespace chiron::session_report
