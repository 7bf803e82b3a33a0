// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_blinding.h"
#include "database/repositories/study_reader.h"
#include "psychophysics/measures/ranking_summary.h"
#include "psychophysics/study/apex_study.h"
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

/// The results of one run.
struct AnalysedRun {
    database::Participant participant;
    database::StudyRun run;
    std::vector<database::StudyTrial> trials; ///< all of them
    int scored = 0, practice = 0;
    int spoiled = 0;          ///< repeated trials (database::isRepeated)
    std::optional<bool> felt; ///< false if any trial was only shown; empty if nothing was rendered
    bool pooled = true;       ///< the run belongs to the group if it has an estimate
    Presence presence = Presence::noValue; ///< whether the group's value uses it, or why not
    Remedy remedy = Remedy::none;          ///< what would give it a value
    psychophysics::RunEstimate estimate;
    ReplayedChoices replayed;
    std::optional<psychophysics::ApexSummary> apex; ///< study of the apex: this run's marks alone
    psychophysics::RankingSummary ranking;          ///< for ranking of three objects; otherwise empty
};

struct AnalysedCondition {
    std::string condition;         ///< id, or sealed code while blinded
    std::vector<AnalysedRun> runs; ///< by participant
    /// Group value of the people who have not withdrawn and felt the objects; of simulated participants only
    /// if there are no people. Its warnings state who was left out (withdrawn, simulated_left_out, simulated,
    /// not_rendered, shown_left_out); its members' `index` refers to `runs`.
    psychophysics::GroupEstimate group;
    /// Study of the apex: the marks of the group's members; a participant's number is the index of their
    /// first run in `runs`.
    std::optional<psychophysics::ApexSummary> apex;
    psychophysics::RankingSummary ranking; ///< of the same members, for ranking of three objects; otherwise
                                           ///< empty
    GroupRoll roll;                        ///< the runs on which the group's value is based
};

struct StudyAnalysis {
    database::StudyRecord record;
    psychophysics::StudyDesign design;
    std::vector<AnalysedCondition> conditions;   ///< in the design's order; ordered by sealed code while
                                                 ///< blinded
    std::vector<ComparedConditions> comparisons; ///< every pair of conditions; empty while blinded
    database::Blinding blinding;

    bool blind() const { return blinding.on; }
    /// Runs are listed without results; the quality is still available.
    bool sealed() const { return blinding.seals(); }
    std::vector<database::ParticipantQuality> quality;        ///< by participant
    std::map<database::ParticipantNumber, std::string> codes; ///< of all participants
    /// The condition by which the runs of conditions[at] are analysed: analysedBy() of it.
    const psychophysics::Condition* designed(std::size_t at) const;
};

/// Options of an analysis.
struct AnalysisChoices {
    bool withShown = false; ///< runs on devices that render no force belong to the group
};

/// Adds the warning "shown" to an estimate if trials were shown, not felt.
void warnShown(psychophysics::RunEstimate& estimate, const std::vector<database::StudyTrial>& trials);

/// Adds the warning "not_rendered" if a simulated participant's trials were not rendered (a quick run).
void warnNotRendered(psychophysics::RunEstimate& estimate, const database::Participant& participant,
                     const std::vector<database::StudyTrial>& trials);

/// The condition by which a run is analysed: its own. While the study is blinded, any condition if all of
/// them have the same analysis, else null; then only the run's trials can be counted.
const psychophysics::Condition* analysedBy(const psychophysics::StudyDesign& design,
                                           const database::Blinding& blinding, const std::string& condition);
/// The estimate of a run; while the study is blinded, without values in physical units. `condition`: may be
/// null as in analysedBy().
psychophysics::RunEstimate estimateOf(const psychophysics::Condition* condition,
                                      const std::vector<psychophysics::ScoredTrial>& trials,
                                      const database::Blinding& blinding, std::uint64_t seed);

/// Analyses every run of a study that has trials; `seed` is that of the bootstraps. Stopped runs of a
/// withdrawn participant are left out.
/// Errors: those of the reader; badInput (a design or a trial that cannot be read).
core::Result<StudyAnalysis> analyseStudy(database::StudyReader& reader, database::StudyNumber study,
                                         std::uint64_t seed, const AnalysisChoices& choices = {});

} // namespace chiron::session
