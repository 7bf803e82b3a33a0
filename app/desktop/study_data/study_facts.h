// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_store.h"
#include "session/study/study_analysis.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// One run with what it says.
struct RunFacts {
    std::size_t participant = 0; ///< in OpenStudy::participants
    std::size_t condition = 0;   ///< in the design's conditions
    database::StudyRun run;
    std::vector<database::StudyTrial> trials;
    psychophysics::RunEstimate estimate;
    session::ReplayedChoices replayed;
    int scored = 0;
    int spoiled = 0;
    std::optional<psychophysics::ApexSummary> apex{}; ///< of a condition in which an apex is looked for
    psychophysics::RankingSummary ranking{}; ///< of task rank3; else of none
};

/// A condition in which an apex is looked for: everybody's marks, and whose they are by the summary's numbers.
struct ApexFacts {
    psychophysics::ApexSummary summary;
    std::vector<QString> names; ///< empty: nobody has done it
};

/// Everything that the data of a study are shown from.
struct StudyFacts {
    OpenStudy study;
    std::vector<RunFacts> runs;
    std::vector<psychophysics::GroupEstimate> groups; ///< of each condition of the design
    std::vector<psychophysics::RankingSummary> rankings; ///< the same, where its task is rank3
    std::vector<database::QuestionnaireAnswer> answers;
    std::vector<std::optional<ApexFacts>> apexes{}; ///< of each condition of the design
};

/// Reads a study and analyses it as exports and reports do (session::analyseStudy), with the study's own seed. Blocking: a worker's task.
/// Failure: the reader's; badInput.
core::Result<StudyFacts> studyFacts(database::StudyReader& reader, database::StudyNumber study);

} // namespace chiron::desktop
