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

/// One judged palpation trial: which lumps there were, what was reported, and how each finding was judged.
/// Metrics, debrief, report and ROC all use this one judgement.
struct PalpationAnswer {
    PalpationTruth truth;
    std::vector<TimedReport> reports;
    simulation::FindingsBook findings; ///< at the trial's end, without findings that were taken back
    std::vector<FindingMatch> matches;
    std::vector<DetectionRegion> regions;

    int hits() const noexcept;
    int misses() const noexcept { return static_cast<int>(truth.lumps.size()) - hits(); }
    int falseAlarms() const noexcept { return static_cast<int>(matches.size()) - hits(); }
};

/// A trial's answer, or the reason why there is none.
struct JudgedTrial {
    std::optional<PalpationAnswer> answer;
    UndefinedReason reason = reasons::kNoTrials; ///< valid if there is no answer
};

/// Judges a trial. A trial that ended because its time was up is judged by what had been reported until then.
JudgedTrial judgePalpation(const TrialTrace& trial);

} // namespace chiron::scoring
