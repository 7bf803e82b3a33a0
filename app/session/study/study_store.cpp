// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_store.h"

#include "catalogue/study_json.h"
#include "core/random.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "psychophysics/designs/latin_square.h"
#include "session/study/study_progress.h"

#include <algorithm>

namespace chiron::session {

namespace {

bool hasRun(const OpenedStudy& study, const std::string& label, database::StudyRunState state) {
    return std::any_of(study.runs.begin(), study.runs.end(), [&](const database::StudyRun& run) {
        return labelOf(run) == label && run.state == state;
    });
}

} // namespace

core::Result<OpenedStudy> openStudy(database::Database& database, const database::Actor& actor,
                                    database::StudyNumber number, const std::string& participantCode) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    database::StudyReader reader(**connection, actor);
    OpenedStudy study;
    auto record = reader.study(number);
    CHIRON_TRY(record);
    study.record = std::move(*record);
    if (study.record.summary.state == database::StudyState::draft)
        return core::fail(core::ErrorCode::wrongUse,
                          "study " + std::to_string(number) +
                              " is a draft: it is frozen before anybody takes part");
    auto design = catalogue::readStudy(QByteArray::fromStdString(study.record.designJson),
                                       "study " + std::to_string(number));
    CHIRON_TRY(design);
    study.design = std::move(*design);
    auto participant = reader.participantByCode(number, participantCode);
    CHIRON_TRY(participant);
    study.participant = std::move(*participant);
    auto runs = reader.runs(study.participant.id);
    CHIRON_TRY(runs);
    study.runs = std::move(*runs);
    const auto conditions = reader.conditionCodes(number);
    CHIRON_TRY(conditions);
    study.order = labelsInOrder(study.design, *conditions, study.participant.order);
    return study;
}

bool OpenedStudy::firstPart(const std::string& label) const {
    return std::none_of(order.begin(), order.end(), [&](const std::string& other) {
        return other != label && hasRun(*this, other, database::StudyRunState::completed);
    });
}

int OpenedStudy::partsBeside(const std::string& label) const {
    const std::vector<std::string> open = openConditions(*this);
    return static_cast<int>(
        std::count_if(open.begin(), open.end(), [&](const std::string& other) { return other != label; }));
}

std::string labelOf(const database::SealedCondition& condition) {
    return condition.condition.empty() ? condition.sealedCode : condition.condition;
}

std::string labelOf(const database::StudyRun& run) {
    return run.condition.empty() ? run.sealedCode : run.condition;
}

std::vector<std::string> labelsInOrder(const psychophysics::StudyDesign& design,
                                       const std::vector<database::SealedCondition>& conditions, int row) {
    std::vector<std::string> labels;
    for (const int index :
         psychophysics::orderFor(design.order, static_cast<int>(conditions.size()), row, design.seed))
        labels.push_back(labelOf(conditions[static_cast<std::size_t>(index)]));
    return labels;
}

std::vector<std::string> openConditions(const OpenedStudy& study) {
    std::vector<std::string> open;
    for (const std::string& condition : study.order)
        if (!hasRun(study, condition, database::StudyRunState::completed))
            open.push_back(condition);
    return open;
}

std::string sessionLabel(const OpenedStudy& study, const std::string& sealedCode) {
    return study.blind() ? sealedCode : std::string();
}

core::Result<void> sameTable(const database::StudyRun& run, double limit) {
    if (limit < StudyProgress::limitOf(run.procedures))
        return core::fail(
            core::ErrorCode::wrongUse,
            "run " + std::to_string(run.id) +
                " was begun on a device that renders larger differences: it goes on with such a one alone");
    return {};
}

core::Result<void> sameVersions(const database::StudyRun& run, const std::string& now) {
    if (run.procedures != now) // unnamed in the message, because procedures can reveal the condition
        return core::fail(core::ErrorCode::wrongUse,
                          "run " + std::to_string(run.id) +
                              " was begun with another version of its procedures than this program has: no "
                              "version continues "
                              "another one's run; expected another participant for this condition");
    return {};
}

core::Result<database::ConductedRun> conduct(database::Database& database, const database::Actor& actor,
                                             const OpenedStudy& study, const std::string& label) {
    return database.write([&](database::WriteContext& context) {
        return database::StudyRepository(context.connection(), actor).conductRun(study.participant.id, label);
    });
}

core::Result<OpenedStudy> unmasked(OpenedStudy study, const database::ConductedRun& run) {
    if (!study.record.masked)
        return study;
    auto design =
        catalogue::readStudy(QByteArray::fromStdString(run.designJson), "study " + study.record.summary.key);
    CHIRON_TRY(design);
    study.design = std::move(*design);
    return study;
}

core::Error sealedError(const OpenedStudy& study, const database::ConductedRun& run, core::Error error) {
    const std::string& name = run.condition;
    for (std::size_t at = 0;
         study.blind() && !name.empty() && (at = error.message.find(name, at)) != std::string::npos;
         at += run.sealedCode.size())
        error.message.replace(at, name.size(), run.sealedCode);
    return error;
}

core::Result<database::StudyRunNumber> beginRun(database::Database& database, const database::Actor& actor,
                                                const OpenedStudy& study, const std::string& label,
                                                std::uint64_t seed, const std::string& procedures) {
    database::NewStudyRun run;
    run.participant = study.participant.id;
    run.condition = label;
    run.position =
        static_cast<int>(std::find(study.order.begin(), study.order.end(), label) - study.order.begin());
    run.seed = seed;
    run.procedures = procedures;
    return database.write([&](database::WriteContext& context) {
        return database::StudyRepository(context.connection(), actor).beginRun(run);
    });
}

core::Result<void> storeTrial(database::Database& database, const database::Actor& actor,
                              const database::StudyTrial& trial) {
    return database.write([&](database::WriteContext& context) {
        return database::StudyRepository(context.connection(), actor).storeStudyTrial(trial);
    });
}

core::Result<void> finishRun(database::Database& database, const database::Actor& actor,
                             const OpenedStudy& study, database::StudyRunNumber run) {
    auto ended = database.write([&](database::WriteContext& context) {
        return database::StudyRepository(context.connection(), actor)
            .finishRun(run, database::StudyRunState::completed);
    });
    CHIRON_TRY(ended);
    auto now = openStudy(database, actor, study.record.summary.id, study.participant.code);
    CHIRON_TRY(now);
    if (!openConditions(*now).empty())
        return {};
    return database.write([&](database::WriteContext& context) {
        return database::StudyRepository(context.connection(), actor)
            .completeParticipant(study.participant.id);
    });
}

std::uint64_t runSeed(const OpenedStudy& study, const std::string& label) {
    // Shifted to 63 bits, because SQLite's integers are signed.
    return core::Random::mix(study.design.seed, "run " + study.participant.code + " " + label) >> 1;
}

} // namespace chiron::session
