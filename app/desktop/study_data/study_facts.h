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
    std::size_t condition = 0;   ///< place in conditionLabels(), which is not the design's while blind
    database::StudyRun run;
    std::vector<database::StudyTrial> trials;
    psychophysics::RunEstimate estimate;
    session::ReplayedChoices replayed;
    int scored = 0;
    int spoiled = 0;
    std::optional<bool> felt{}; ///< false where any trial was only shown
    std::optional<psychophysics::ApexSummary> apex{}; ///< of a condition in which an apex is looked for
    psychophysics::RankingSummary ranking{}; ///< where three are ranked; else of none
    session::Presence presence = session::Presence::noValue; ///< whether the group's value uses it, or why not
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
    // Of each of conditionLabels():
    std::vector<psychophysics::GroupEstimate> groups;
    std::vector<session::GroupRoll> rolls; ///< what each group's value rests on
    std::vector<psychophysics::RankingSummary> rankings; ///< where three are ranked
    std::vector<std::optional<ApexFacts>> apexes;
    std::vector<std::optional<psychophysics::Condition>> designed; ///< what it is analysed by: StudyAnalysis::designed()
    std::vector<session::ComparedConditions> comparisons; ///< by places in conditionLabels(); none while blinded
    std::vector<database::QuestionnaireAnswer> answers;
    std::vector<database::ParticipantQuality> quality; ///< by participant: also while blinded
    bool sealed = false;    ///< runs are listed, and nothing is said of them
    bool withShown = false; ///< groups hold runs that were shown, not felt
    bool anyShown = false;  ///< there are such runs

    /// The task of a condition; unknown while blind where conditions differ.
    bool ranks(std::size_t condition) const { return designed[condition] && psychophysics::ranksThree(designed[condition]->task); }
};

/// Reads a study and analyses it as exports and reports do (session::analyseStudy), with the study's own seed. Blocking: a worker's task.
/// Failure: the reader's; badInput.
core::Result<StudyFacts> studyFacts(database::StudyReader& reader, database::StudyNumber study, bool withShown = false);

} // namespace chiron::desktop
