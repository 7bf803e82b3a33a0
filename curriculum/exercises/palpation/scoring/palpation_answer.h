// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/palpation/scoring/detection_regions.h"
#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "curriculum/exercises/palpation/scoring/findings_trace.h"
#include "curriculum/exercises/palpation/scoring/palpation_truth.h"
#include "scoring/undefined_reason.h"

#include <string>
#include <vector>

namespace chiron::scoring {

/// One trial of a palpation, judged: what was there, what was reported, and what became of each finding. The one judgement behind
/// metrics, debrief, report and ROC.
struct PalpationAnswer {
    PalpationTruth truth;
    std::vector<TimedReport> reports;
    simulation::FindingsBook findings; ///< at the trial's end: what was taken back is not in it
    std::vector<FindingMatch> matches;
    std::vector<DetectionRegion> regions;

    int hits() const noexcept;
    int misses() const noexcept { return static_cast<int>(truth.lumps.size()) - hits(); }
    int falseAlarms() const noexcept { return static_cast<int>(matches.size()) - hits(); }
};

/// A trial's answer, or the reason why there is none.
struct JudgedTrial {
    std::optional<PalpationAnswer> answer;
    UndefinedReason reason = UndefinedReason::noTrials; ///< where there is none
};

/// A trial that time ended is judged by what had been reported.
JudgedTrial judgePalpation(const TrialTrace& trial);

} // namespace chiron::scoring
