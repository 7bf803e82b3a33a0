// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/demo_study.h"

#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "core/random.h"
#include "database/repositories/study_repository.h"
#include "session/replayer.h"
#include "session/study/study_runner.h"

#include <algorithm>
#include <iterator>

namespace chiron::session {

namespace {

constexpr const char* kStudy = "stiffness_elastic_tube";
constexpr const char* kDraft = "surgeons";

struct DemoParticipant {
    const char* code;
    const char* observer;
    bool rendered;
};

constexpr DemoParticipant kParticipants[] = {
    {"SIM-1", "weber:0.08,lapse:0.02", false}, {"SIM-2", "weber:0.1,lapse:0.02", false},
    {"SIM-3", "weber:0.12,lapse:0.02", false}, {"SIM-4", "weber:0.14,lapse:0.02", false},
    {"SIM-5", "weber:0.17,lapse:0.02", false}, {"SIM-6", "weber:0.2,lapse:0.02", false},
    {"SIM-7", "weber:0.12,lapse:0.02", true},
};

/// Adds a study of the content, frozen if requested.
core::Result<database::StudyNumber> addStudy(database::Database& database, const database::Actor& author,
                                             const catalogue::StudyCatalogue& content, const char* id,
                                             bool freeze) {
    const psychophysics::StudyDesign* design = content.find(id);
    if (design == nullptr)
        return core::fail(core::ErrorCode::notFound, std::string("content: no study \"") + id + "\"");
    return database.write([&](database::WriteContext& context) -> core::Result<database::StudyNumber> {
        database::StudyRepository studies(context.connection(), author);
        auto made = studies.createStudy(design->id, design->title.at("en"),
                                        catalogue::studyJson(*design).toStdString());
        if (!made || !freeze)
            return made;
        CHIRON_TRY(studies.freezeStudy(*made));
        return made;
    });
}

/// Enrols a participant who then does the study. Returns the session in which it was recorded, or 0.
core::Result<database::SessionId> runParticipant(database::Database& database, const database::Actor& author,
                                                 database::StudyNumber study, const DemoParticipant& who,
                                                 std::uint64_t seed, const std::atomic<bool>* cancel) {
    const auto observer = psychophysics::parseObserver(who.observer);
    CHIRON_TRY(observer);
    const auto enrolled = database.write([&](database::WriteContext& context) {
        return database::StudyRepository(context.connection(), author)
            .enrolParticipant(study, {}, 0, psychophysics::observerText(*observer), who.code);
    });
    CHIRON_TRY(enrolled);
    StudyRunRequest request;
    request.study = study;
    request.participantCode = who.code;
    request.observer = *observer;
    request.seed = core::Random::mix(seed, who.code);
    request.quick = !who.rendered;
    request.cancel = cancel;
    const auto report = runStudyHeadless(database, author, request);
    CHIRON_TRY(report);
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed))
        return core::fail(core::ErrorCode::cancelled, "the demonstration was stopped before it was complete");
    if (!report->completed)
        return core::fail(core::ErrorCode::wrongUse, std::string("study ") + kStudy + ", participant " +
                                                         who.code + ": did not complete");
    return report->runs.front().session;
}

core::Result<bool> replaysAlike(database::Database& database, const database::Actor& author,
                                database::SessionId session) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    auto stored = SessionView::open(**connection, author, session);
    CHIRON_TRY(stored);
    const auto replay = replaySession(**stored);
    CHIRON_TRY(replay);
    return replay->identical;
}

/// Analyses the study as for everybody who opens it.
core::Result<void> analyse(database::Database& database, const database::Actor& author, std::uint64_t seed,
                           DemoStudy& made) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    database::StudyReader reader(**connection, author);
    auto analysis = analyseStudy(reader, made.study, seed);
    CHIRON_TRY(analysis);
    AnalysedCondition& condition = analysis->conditions.front();
    made.key = analysis->record.summary.key;
    made.condition = condition.condition;
    made.group = std::move(condition.group);
    for (AnalysedRun& run : condition.runs) {
        const database::SessionId session = run.trials.front().session;
        made.runs.push_back({run.participant.code, run.participant.observer, session, std::move(run.estimate),
                             run.replayed.identical()});
        if (session == 0)
            continue;
        const auto alike = replaysAlike(database, author, session);
        CHIRON_TRY(alike);
        made.replayIdentical = *alike;
    }
    return {};
}

} // namespace

int demoStudyParticipants() {
    return static_cast<int>(std::size(kParticipants));
}

core::Result<DemoStudy> makeDemoStudy(database::Database& database, const database::Actor& author,
                                      std::uint64_t seed,
                                      const std::function<void(const std::string& doing)>& progress,
                                      const std::atomic<bool>* cancel) {
    const auto content = catalogue::StudyCatalogue::load();
    CHIRON_TRY(content);
    const auto study = addStudy(database, author, *content, kStudy, true);
    CHIRON_TRY(study);
    const auto draft = addStudy(database, author, *content, kDraft, false);
    CHIRON_TRY(draft);
    DemoStudy made;
    made.study = *study;
    made.draft = *draft;
    for (const DemoParticipant& who : kParticipants) {
        if (cancel != nullptr && cancel->load(std::memory_order_relaxed))
            return core::fail(core::ErrorCode::cancelled,
                              "the demonstration was stopped before it was complete");
        progress(std::string("study ") + kStudy + ", " + who.code +
                 (who.rendered ? "" : ", without rendering"));
        CHIRON_TRY(runParticipant(database, author, *study, who, seed, cancel));
    }
    CHIRON_TRY(analyse(database, author, seed, made));
    return made;
}

} // namespace chiron::session
