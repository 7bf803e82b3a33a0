// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/study_reader.h"
#include "database/database.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "desktop/frame/app_context.h"

#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace chiron::desktop {

/// Reads on a worker with a connection of its own: `job(StudyReader&)` returns a Result, which `done` gets on the GUI thread.
template <class Job, class Done>
std::shared_ptr<WorkToken> readStudies(AppContext& context, QObject* owner, Job job, Done done) {
    using Answer = std::invoke_result_t<Job, database::StudyReader&>;
    return context.background().run(
        owner,
        [&database = context.site().database(), actor = context.actor(), job = std::move(job)](WorkToken&) -> Answer {
            auto connection = database.openReader();
            if (!connection)
                return tl::unexpected(connection.error());
            database::StudyReader reader(**connection, actor);
            return job(reader);
        },
        std::move(done));
}

/// Writes on a worker, in one transaction: `job(StudyRepository&)` returns a Result, which `done` gets on the GUI thread.
template <class Job, class Done>
void writeStudies(AppContext& context, QObject* owner, Job job, Done done) {
    context.background().run(
        owner,
        [&database = context.site().database(), actor = context.actor(), job = std::move(job)](WorkToken&) {
            return database.write([&](database::WriteContext& writing) {
                database::StudyRepository studies(writing.connection(), actor);
                return job(studies);
            });
        },
        std::move(done));
}

/// A run that was interrupted, as far as it got.
struct LeftRun {
    database::StudyRunNumber run = 0;
    int scored = 0;      ///< trials
    int atMost = 0;      ///< of the condition; 0: not known
    std::string lastUtc; ///< of the last trial; of the run's beginning where there is none
};

/// A participant with what they have done so far.
struct ParticipantRow {
    database::Participant participant;
    std::vector<database::StudyRun> runs;
    std::vector<LeftRun> left; ///< of the open ones
};

/// Somebody's trial of a draft.
struct PilotRow {
    database::StudySummary summary;
    int scored = 0;  ///< trials
    int spoiled = 0; ///< trials
    double secondsPerTrial = 0.0; ///< of the scored ones, without practice
};

/// One study as its screens need it.
struct OpenStudy {
    database::StudySummary summary;
    psychophysics::StudyDesign design;
    std::vector<database::SealedCondition> sealed; ///< StudyReader::conditionCodes
    std::vector<ParticipantRow> participants;
    std::set<std::pair<database::ParticipantNumber, std::string>> answered; ///< who has answered which questionnaire, of any condition
    std::set<std::pair<database::StudyRunNumber, std::string>> answeredAfter{}; ///< after which run which of those that are asked after each
    database::Blinding blinding{};
    bool masked = false; ///< StudyRecord::masked
    std::vector<PilotRow> pilots; ///< of its draft, in the order tried

    bool editable() const { return summary.state == database::StudyState::draft; }
    /// Whether conditions go by their sealed codes on experimenters' screens.
    bool blind() const { return blinding.on; }
};

/// Blocking. Failure: the reader's; badInput where the stored design does not read.
core::Result<OpenStudy> openStudy(database::StudyReader& reader, database::StudyNumber study);

/// How many pilots came to a trial that counts.
int pilotsTried(const OpenStudy& study);

/// What a condition is called on an experimenter's screen: its title, or its sealed code. `label`: session::labelOf.
QString conditionName(const OpenStudy& study, const std::string& label, const QString& language);
/// Labels of the conditions as their analysis lists them: the design's order, while blind by code.
std::vector<std::string> conditionLabels(const OpenStudy& study);

} // namespace chiron::desktop
