// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/observers/observer_spec.h"
#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/study_design.h"

#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

/// What a two-outcome procedure hears of an outcome as outcomeOf(task, ...) counts it: rank3, rank3_ties: all correct or not; others as they are.
/// A procedure of 6 or 13 outcomes hears the order itself.
int scoredOutcome(Task task, int outcome, int outcomesOfProcedure) noexcept;

/// D that a procedure's x stands for, and x of a D; x of a D not above 0 on the logarithmic scale: -20.
double differenceOf(ProcedureScale scale, double x) noexcept;
double scaledDifference(ProcedureScale scale, double difference) noexcept;

/// The row of the candidate table nearest to D; the lower of two alike. -1: the table is empty.
int nearestCandidate(const std::vector<double>& candidates, double difference) noexcept;

/// Whether an arrangement shows the difference at all: in same_different and yes_no some do not, and say nothing to an adaptive procedure.
bool showsDifference(Task task, int arrangement) noexcept;

/// Runs a condition with simulated observers, without rendering: each place is felt as it was meant.
class RunSimulator {
public:
    /// Failure: badInput where there is no procedure or candidate, or a procedure is refused.
    static core::Result<RunSimulator> make(const Condition& condition);

    /// One run until all procedures are done (at most 10,000 trials).
    std::vector<ScoredTrial> run(const ObserverSpec& observer, std::uint64_t seed) const;

private:
    Condition m_condition;
    std::vector<ProcedureFactory> m_factories;
};

} // namespace chiron::psychophysics
