// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/database.h"
#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// What a sitting needs of the database: study, participant, the run that is to be begun or gone on with. Conditions go by labels: their
/// ids, or while the study is blinded their sealed codes.
struct OpenedStudy {
    /// Whether conditions go by sealed codes now.
    bool blind() const { return record.blinding.on; }
    /// Whether the participant has completed no other condition than the one of this label.
    bool firstPart(const std::string& label) const;

    database::StudyRecord record;
    psychophysics::StudyDesign design; ///< masked where the record is, until a run of it is conducted
    database::Participant participant;
    std::vector<database::StudyRun> runs; ///< of the participant, in the order begun
    std::vector<std::string> order;       ///< labels in the participant's order
};

/// Failure: notFound, notAllowed, wrongUse (a draft), badInput.
core::Result<OpenedStudy> openStudy(database::Database& database, const database::Actor& actor, database::StudyNumber study,
                                    const std::string& participantCode);
/// What a condition, or that of a run, goes by.
std::string labelOf(const database::SealedCondition& condition);
std::string labelOf(const database::StudyRun& run);
/// Labels in the order that a participant with this row does them. `conditions`: StudyReader::conditionCodes.
std::vector<std::string> labelsInOrder(const psychophysics::StudyDesign& design, const std::vector<database::SealedCondition>& conditions, int row);
/// The conditions that are still to be done, in order.
std::vector<std::string> openConditions(const OpenedStudy& study);
/// What a sitting's session calls the condition of a run: its sealed code while the experimenter is blind, else empty (its own id).
std::string sessionLabel(const OpenedStudy& study, const std::string& sealedCode);
/// Failure: wrongUse, where the device renders less than the one the run was begun on: its later trials would be of another table.
core::Result<void> sameTable(const database::StudyRun& run, double limit);
/// Failure: wrongUse, where the run's procedures are of other versions than this program's (`now`: StudyProgress::procedureIds()): a version
/// never continues another one's run (psychophysics.md §6).
core::Result<void> sameVersions(const database::StudyRun& run, const std::string& now);

/// The condition of this label with its open run: what the sitting renders and goes on with. Failure: the repository's.
core::Result<database::ConductedRun> conduct(database::Database& database, const database::Actor& actor, const OpenedStudy& study,
                                             const std::string& label);
/// The study with the design as it is, for who conducts a run of it. Failure: badInput.
core::Result<OpenedStudy> unmasked(OpenedStudy study, const database::ConductedRun& run);
/// What went wrong with a run, by its sealed code instead of its condition while the study is blinded.
core::Error sealedError(const OpenedStudy& study, const database::ConductedRun& run, core::Error error);
/// Begins a run of a condition. `procedures`: StudyProgress::procedureIds().
core::Result<database::StudyRunNumber> beginRun(database::Database& database, const database::Actor& actor, const OpenedStudy& study,
                                                const std::string& label, std::uint64_t seed, const std::string& procedures);
core::Result<void> storeTrial(database::Database& database, const database::Actor& actor, const database::StudyTrial& trial);
/// Ends the run, and the participant with its last condition.
core::Result<void> finishRun(database::Database& database, const database::Actor& actor, const OpenedStudy& study,
                             database::StudyRunNumber run);
/// Of a run that is begun: from the study's seed, the participant's code and the condition's label, so that it is known before, and does
/// not tell a blinded condition.
std::uint64_t runSeed(const OpenedStudy& study, const std::string& label);

} // namespace chiron::session
