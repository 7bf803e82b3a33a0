// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_blinding.h"
#include "database/repositories/study_reader.h"
#include "psychophysics/study/apex_study.h"
#include "psychophysics/measures/ranking_summary.h"
#include "psychophysics/study/group_estimate.h"
#include "psychophysics/study/run_estimate.h"
#include "session/study/group_roll.h"
#include "session/study/study_comparisons.h"
#include "session/study/study_progress.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// One run as it came out.
struct AnalysedRun {
    database::Participant participant;
    database::StudyRun run;
    std::vector<database::StudyTrial> trials; ///< all of them
    int scored = 0, spoiled = 0, practice = 0;
    std::optional<bool> felt; ///< false where any trial was only shown; nothing where nothing was rendered
    bool pooled = true;       ///< the group is of it, too, where it has an estimate
    Presence presence = Presence::noValue; ///< whether the group's value uses it, or why not
    psychophysics::RunEstimate estimate;
    ReplayedChoices replayed;
    std::optional<psychophysics::ApexSummary> apex; ///< of a study of the apex: this run's marks alone
    psychophysics::RankingSummary ranking; ///< where three are ranked; else of none
};

struct AnalysedCondition {
    std::string condition; ///< id, or sealed code while blinded
    std::vector<AnalysedRun> runs; ///< by participant
    /// Of the people who still take part and felt the objects; of simulated participants only where there are no people. Who was left out is
    /// among its warnings (withdrawn, simulated_left_out, simulated, not_rendered, shown_left_out); its members' `index` counts `runs`.
    psychophysics::GroupEstimate group;
    /// Of a study of the apex: the marks of those whom the group is of; a participant's number is the row of its first run in `runs`.
    std::optional<psychophysics::ApexSummary> apex;
    psychophysics::RankingSummary ranking; ///< of the same members; where three are ranked, else of none
    GroupRoll roll; ///< what the group's value rests on
};

struct StudyAnalysis {
    database::StudyRecord record;
    psychophysics::StudyDesign design;
    std::vector<AnalysedCondition> conditions; ///< in the design's order; while blinded by sealed code
    std::vector<ComparedConditions> comparisons; ///< every two of them; none while blinded
    database::Blinding blinding;

    bool blind() const { return blinding.on; }
    bool sealed() const { return blinding.seals(); } ///< runs are listed, and nothing is said of them; quality can be watched
    std::vector<database::ParticipantQuality> quality; ///< by participant
    std::map<database::ParticipantNumber, std::string> codes; ///< of all participants
    /// What the runs of conditions[at] are analysed by: analysedBy() of it.
    const psychophysics::Condition* designed(std::size_t at) const;
};

/// What an analysis may be asked to do otherwise.
struct AnalysisChoices {
    bool withShown = false; ///< runs on devices that render no force belong to the group
};

/// Says so where trials were shown, not felt: warning shown.
void warnShown(psychophysics::RunEstimate& estimate, const std::vector<database::StudyTrial>& trials);

/// Says so where a simulated participant's trials were not rendered (a quick run): warning not_rendered.
void warnNotRendered(psychophysics::RunEstimate& estimate, const database::Participant& participant, const std::vector<database::StudyTrial>& trials);

/// The condition that a run is analysed by: its own; while the study is blinded any, where the analysis of all of them is the same, else
/// null: nothing but its trials can be counted then.
const psychophysics::Condition* analysedBy(const psychophysics::StudyDesign& design, const database::Blinding& blinding, const std::string& condition);
/// What a run says, without what is known of a condition in physical units while the study is blinded. `condition`: null as above.
psychophysics::RunEstimate estimateOf(const psychophysics::Condition* condition, const std::vector<psychophysics::ScoredTrial>& trials,
                                      const database::Blinding& blinding, std::uint64_t seed);

/// Every run of a study with trials, analysed anew; `seed`: of bootstraps. Stopped runs of a withdrawn participant are left out.
/// Failure: the reader's; badInput (a design or a trial that cannot be read).
core::Result<StudyAnalysis> analyseStudy(database::StudyReader& reader, database::StudyNumber study, std::uint64_t seed, const AnalysisChoices& choices = {});

} // namespace chiron::session
