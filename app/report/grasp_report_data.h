// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace chiron::report {

/// How a trial of a task without a mark ended.
enum class TrialOutcome {
    done,
    timedOut,
    failed,     ///< it could not be done any more
    unfinished, ///< the session ended before
};

/// One trial on an elastic tube. Absent: the task has no such target, or it was never held.
struct TubeTrialRow {
    int trial = 0; ///< from 0; people see it from 1
    TrialOutcome outcome = TrialOutcome::unfinished;
    std::optional<double> target_N;
    std::optional<double> error_N; ///< root mean square over its holds
    std::optional<double> inBand_s;
    double stretchMax_mm = 0.0;
    std::optional<double> overStretches;
    std::optional<double> drops;
    std::optional<double> retractionInBand_percent; ///< of a fold that had to be held back
};

/// What an elastic tube came to, at 100 Hz (of each 10 ms the value farthest from zero). Between trials, and where a trial asks for
/// no band or no mark, values are not numbers.
struct TubeReport {
    struct Span {
        double begin_s = 0.0;
        double end_s = 0.0;
    };
    std::vector<double> t_s;
    std::vector<double> tension_N;
    std::vector<double> bandLow_N, bandHigh_N;
    std::vector<double> stretch_mm;
    std::vector<double> markLow_mm, markHigh_mm;
    std::vector<double> retraction_N; ///< pull on the fold over the tube; none where there is none
    double retractionLow_N = 0.0, retractionHigh_N = 0.0;
    double overStretch_mm = 0.0; ///< 0: not known
    std::vector<Span> paused;
    std::vector<double> trialStart_s;
    std::vector<TubeTrialRow> rows;
};

/// One trial of object handling. Where the object lay at the end: from the target's middle, seen from above.
struct HandlingTrialRow {
    int trial = 0;
    TrialOutcome outcome = TrialOutcome::unfinished;
    std::optional<double> squeezeMax_N;
    std::optional<double> overLimit_s;
    std::optional<double> x_mm, y_mm;
    std::optional<double> fromTarget_mm;
    bool taken = false;           ///< it was held; else it is only the nearest one
    std::optional<bool> heaviest; ///< of a weighing that was done: whether the heaviest was chosen
};

struct HandlingReport {
    double squeezeLimit_N = 0.0;
    double targetRadius_mm = 0.0;
    std::vector<HandlingTrialRow> rows;
};

} // namespace chiron::report
