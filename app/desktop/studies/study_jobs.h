// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/study_json.h"
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

/// Reads on a worker with its own connection. `job(StudyReader&)` returns a Result, which `done` receives on
/// the GUI thread.
template <class Job, class Done>
std::shared_ptr<WorkToken> readStudies(AppContext& context, QObject* owner, Job job, Done done) {
    using Answer = std::invoke_result_t<Job, database::StudyReader&>;
    return context.background().run(
        owner,
        [&database = context.site().database(), actor = context.actor(),
         job = std::move(job)](WorkToken&) -> Answer {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            database::StudyReader reader(**connection, actor);
            return job(reader);
        },
        std::move(done));
}

/// Writes on a worker in one transaction. `job(StudyRepository&)` returns a Result, which `done` receives on
/// the GUI thread.
template <class Job, class Done> void writeStudies(AppContext& context, QObject* owner, Job job, Done done) {
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

/// The progress of an interrupted run.
struct LeftRun {
    database::StudyRunNumber run = 0;
    int scored = 0;      ///< number of scored trials
    int atMost = 0;      ///< largest number of trials of the condition; 0: not known
    std::string lastUtc; ///< time of the last trial, or of the run's start if there is none
};

/// A participant with their runs so far.
struct ParticipantRow {
    database::Participant participant;
    std::vector<database::StudyRun> runs;
    std::vector<LeftRun> left; ///< the open runs
};

/// A pilot: a person's trial run of a draft.
struct PilotRow {
    database::StudySummary summary;
    int scored = 0;               ///< number of scored trials
    int spoiled = 0;              ///< number of repeated trials (database::isRepeated)
    double secondsPerTrial = 0.0; ///< mean over the scored trials, without practice
};

/// One study with everything that its screens need.
struct OpenStudy {
    database::StudySummary summary;
    psychophysics::StudyDesign design;
    std::vector<database::SealedCondition> sealed; ///< StudyReader::conditionCodes
    std::vector<ParticipantRow> participants;
    /// Which participant has answered which questionnaire, for any condition.
    std::set<std::pair<database::ParticipantNumber, std::string>> answered;
    /// For questionnaires asked after each condition: after which run which one was answered.
    std::set<std::pair<database::StudyRunNumber, std::string>> answeredAfter{};
    database::Blinding blinding{};
    bool masked = false;          ///< StudyRecord::masked
    std::vector<PilotRow> pilots; ///< of its draft, in order of time

    bool editable() const { return summary.state == database::StudyState::draft; }
    /// Whether experimenters' screens show conditions by their sealed codes.
    bool blind() const { return blinding.on; }
};

/// Reads one study.
/// Thread: worker; blocks.
/// Errors: those of the reader; badInput if the stored design cannot be read.
core::Result<OpenStudy> openStudy(database::StudyReader& reader, database::StudyNumber study);

/// Number of pilots with at least one scored trial.
int pilotsTried(const OpenStudy& study);

/// The name of a condition on an experimenter's screen: its title, or its sealed code. `label`:
/// session::labelOf.
QString conditionName(const OpenStudy& study, const std::string& label, const QString& language);
/// Labels of the conditions in the order of their analysis: the design's order, or sorted by code while
/// blind.
std::vector<std::string> conditionLabels(const OpenStudy& study);

} // namespace chiron::desktop
