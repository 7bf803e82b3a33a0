// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/database.h"
#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// The data that a run needs from the database: study, participant, and the runs so far. Conditions are
/// identified by labels: their ids, or their sealed codes while the study is blinded.
struct OpenedStudy {
    /// True if conditions are currently identified by sealed codes.
    bool blind() const { return record.blinding.on; }
    /// True if the participant has completed no condition other than the one with this label.
    bool firstPart(const std::string& label) const;
    /// Number of conditions other than the one with this label that the participant has not completed.
    int partsBeside(const std::string& label) const;

    database::StudyRecord record;
    psychophysics::StudyDesign design; ///< masked if the record is, until a run of it is conducted
    database::Participant participant;
    std::vector<database::StudyRun> runs; ///< of the participant, in the order in which they began
    std::vector<std::string> order;       ///< labels in the participant's order
};

/// Opens a study for a participant.
/// Errors: notFound, notAllowed, wrongUse (a draft), badInput.
core::Result<OpenedStudy> openStudy(database::Database& database, const database::Actor& actor,
                                    database::StudyNumber study, const std::string& participantCode);
/// The label of a condition, or of the condition of a run.
std::string labelOf(const database::SealedCondition& condition);
std::string labelOf(const database::StudyRun& run);
/// Labels in the order in which a participant with this row does the conditions. `conditions`:
/// StudyReader::conditionCodes.
std::vector<std::string> labelsInOrder(const psychophysics::StudyDesign& design,
                                       const std::vector<database::SealedCondition>& conditions, int row);
/// The conditions still to be done, in order.
std::vector<std::string> openConditions(const OpenedStudy& study);
/// The name of a run's condition in a session: its sealed code while the experimenter is blind, else empty
/// (its own id).
std::string sessionLabel(const OpenedStudy& study, const std::string& sealedCode);
/// Refuses a device that renders less than the one on which the run began, because later trials would use
/// another table.
/// Errors: wrongUse.
core::Result<void> sameTable(const database::StudyRun& run, double limit);
/// Refuses a run whose procedures have other versions than this program's (`now`:
/// StudyProgress::procedureIds()): a version never continues the run of another one (psychophysics.md §6).
/// Errors: wrongUse.
core::Result<void> sameVersions(const database::StudyRun& run, const std::string& now);

/// The condition with this label and its open run, which are needed to render and to resume.
/// Errors: those of the repository.
core::Result<database::ConductedRun> conduct(database::Database& database, const database::Actor& actor,
                                             const OpenedStudy& study, const std::string& label);
/// The study with its unmasked design, for whoever conducts a run of it.
/// Errors: badInput.
core::Result<OpenedStudy> unmasked(OpenedStudy study, const database::ConductedRun& run);
/// The error of a run, with its sealed code in place of its condition while the study is blinded.
core::Error sealedError(const OpenedStudy& study, const database::ConductedRun& run, core::Error error);
/// Begins a run of a condition. `procedures`: StudyProgress::procedureIds().
core::Result<database::StudyRunNumber> beginRun(database::Database& database, const database::Actor& actor,
                                                const OpenedStudy& study, const std::string& label,
                                                std::uint64_t seed, const std::string& procedures);
core::Result<void> storeTrial(database::Database& database, const database::Actor& actor,
                              const database::StudyTrial& trial);
/// Ends the run; with the last condition, also ends the participant's part.
core::Result<void> finishRun(database::Database& database, const database::Actor& actor,
                             const OpenedStudy& study, database::StudyRunNumber run);
/// The seed of a new run, derived from the study's seed, the participant's code and the condition's label, so
/// that it is known in advance and does not reveal a blinded condition.
std::uint64_t runSeed(const OpenedStudy& study, const std::string& label);

} // namespace chiron::session
