// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_jobs.h"
#include "session/study/study_analysis.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// One run with its results.
struct RunFacts {
    std::size_t participant = 0; ///< index into OpenStudy::participants
    /// Index into conditionLabels(), which is not in the design's order while blind.
    std::size_t condition = 0;
    database::StudyRun run;
    std::vector<database::StudyTrial> trials;
    psychophysics::RunEstimate estimate;
    session::ReplayedChoices replayed;
    int scored = 0;
    int spoiled = 0;
    std::optional<bool> felt{};                       ///< false if force was only shown in any trial
    std::optional<psychophysics::ApexSummary> apex{}; ///< for a condition with an apex search
    psychophysics::RankingSummary ranking{};          ///< if three objects are ranked; else empty
    /// Whether the group's value includes the run, or why not.
    session::Presence presence = session::Presence::noValue;
};

/// The marks of all participants in a condition with an apex search; the summary's numbers index their names.
struct ApexFacts {
    psychophysics::ApexSummary summary;
    std::vector<QString> names; ///< empty: nobody has done the condition
};

/// Everything from which the data of a study are shown.
struct StudyFacts {
    OpenStudy study;
    std::vector<RunFacts> runs;
    // One entry per entry of conditionLabels():
    std::vector<psychophysics::GroupEstimate> groups;
    std::vector<session::GroupRoll> rolls;               ///< which runs each group's value is based on
    std::vector<psychophysics::RankingSummary> rankings; ///< if three objects are ranked
    std::vector<std::optional<ApexFacts>> apexes;
    /// The condition that the analysis uses: StudyAnalysis::designed().
    std::vector<std::optional<psychophysics::Condition>> designed;
    /// Indexed as conditionLabels(); empty while blinded.
    std::vector<session::ComparedConditions> comparisons;
    std::vector<database::QuestionnaireAnswer> answers;
    std::vector<database::ParticipantQuality> quality; ///< by participant; also available while blinded
    bool sealed = false;                               ///< runs are listed without any results
    bool withShown = false;                            ///< groups include runs that were shown, not felt
    bool anyShown = false;                             ///< such runs exist

    /// Whether the task of a condition is to rank three objects; unknown, and therefore false, while blind if
    /// conditions differ.
    bool ranks(std::size_t condition) const {
        return designed[condition] && psychophysics::ranksThree(designed[condition]->task);
    }
};

/// Reads a study and analyses it like the exports and reports (session::analyseStudy), with the study's own
/// seed.
/// Thread: worker; blocks.
/// Errors: those of the reader; badInput.
core::Result<StudyFacts> studyFacts(database::StudyReader& reader, database::StudyNumber study,
                                    bool withShown = false);

} // namespace chiron::desktop
