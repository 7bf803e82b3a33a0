// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/observers/observer_spec.h"
#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/study_design.h"

#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

/// Returns what a procedure with two outcomes is told about an outcome as outcomeOf(task, ...) counts it: for
/// rank3 and rank3_ties whether all is correct; for other tasks the outcome itself. A procedure with 6 or 13
/// outcomes is told the order itself.
int scoredOutcome(Task task, int outcome, int outcomesOfProcedure) noexcept;

/// Converts between a procedure's x and the difference D. A D that is not above 0 has x = -20 on the
/// logarithmic scale.
double differenceOf(ProcedureScale scale, double x) noexcept;
double scaledDifference(ProcedureScale scale, double difference) noexcept;

/// Returns the row of the candidate table nearest to D, the lower of two equally near ones; -1 if the table
/// is empty.
int nearestCandidate(const std::vector<double>& candidates, double difference) noexcept;

/// Returns whether an arrangement shows the difference at all. In same_different and yes_no some do not, and
/// an adaptive procedure learns nothing from them.
bool showsDifference(Task task, int arrangement) noexcept;

/// Runs a condition with simulated observers and without rendering: each object has exactly its intended
/// value.
class RunSimulator {
public:
    /// Errors: badInput if there is no procedure or no candidate, or a procedure is refused.
    static core::Result<RunSimulator> make(const Condition& condition);

    /// Runs until all procedures are done (at most 10,000 trials).
    std::vector<ScoredTrial> run(const ObserverSpec& observer, std::uint64_t seed) const;

private:
    Condition m_condition;
    std::vector<ProcedureFactory> m_factories;
};

} // namespace chiron::psychophysics
