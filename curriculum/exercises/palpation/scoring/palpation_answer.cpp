// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/palpation_answer.h"

#include "curriculum/exercises/palpation/scoring/palpation_reasons.h"

#include <algorithm>

namespace chiron::scoring {

int PalpationAnswer::hits() const noexcept {
    return static_cast<int>(
        std::count_if(matches.begin(), matches.end(), [](const FindingMatch& o) { return o.hit(); }));
}

JudgedTrial judgePalpation(const TrialTrace& trial) {
    auto truth = palpationTruthOf(trial.truth);
    if (!truth)
        return {std::nullopt, reasons::kNoLumpsAndArea};
    auto reports = reportsOf(trial);
    if (!reports)
        return {std::nullopt, reasons::kNoReports};
    if (reports->lost > 0)
        return {std::nullopt, reasons::kLostReports};
    PalpationAnswer answer;
    answer.truth = std::move(*truth);
    answer.reports = std::move(reports->reports);
    answer.findings = findingsAfter(answer.reports);
    answer.matches = matchesOf(answer.findings, answer.truth);
    answer.regions = regionsOf(answer.truth, answer.findings, answer.matches);
    return {std::move(answer), {}};
}

} // namespace chiron::scoring
