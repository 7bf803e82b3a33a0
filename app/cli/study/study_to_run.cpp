// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study/study_to_run.h"

#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "cli/cli_errors.h"
#include "cli/study/study_access.h"
#include "cli/study/study_file.h"
#include "database/repositories/study_repository.h"
#include "session/study/study_run_check.h"

namespace chiron::cli {

namespace {

using psychophysics::StudyDesign;

core::Result<StudyToRun> ofContent(const QString& name) {
    const auto content = catalogue::StudyCatalogue::load();
    CHIRON_TRY(content);
    if (const StudyDesign* design = content->find(name.toStdString()))
        return StudyToRun{*design, std::nullopt};
    return core::fail(
        core::ErrorCode::notFound,
        QStringLiteral(
            "STUDY %1: no such study; expected one of the database or of the content, or a JSON file")
            .arg(quoted(name))
            .toStdString());
}

/// The design from a file. It is either new or identical with the design that the database holds under its
/// key.
core::Result<StudyToRun> ofFile(database::Database* database, const database::Actor& actor,
                                const QString& path) {
    auto design = readStudyFile(path);
    CHIRON_TRY(design);
    if (!database)
        return StudyToRun{std::move(*design), std::nullopt};
    auto connection = database->openReader();
    CHIRON_TRY(connection);
    auto stored = findStudy(database::StudyReader(**connection, actor), QString::fromStdString(design->id));
    if (core::failedAs(stored, core::ErrorCode::notFound))
        return StudyToRun{std::move(*design), std::nullopt};
    CHIRON_TRY(stored);
    if (stored->designJson != catalogue::studyJson(*design).toStdString())
        return core::fail(
            core::ErrorCode::badInput,
            QStringLiteral(
                "STUDY %1: another design is stored under its id %2; expected the same, or another id")
                .arg(quoted(path), quoted(QString::fromStdString(design->id)))
                .toStdString());
    return StudyToRun{std::move(*design), std::move(*stored)};
}

core::Result<database::StudyNumber> frozen(database::StudyRepository& repository, const StudyDesign& design) {
    auto made =
        repository.createStudy(design.id, design.title.at("en"), catalogue::studyJson(design).toStdString());
    CHIRON_TRY(made);
    CHIRON_TRY(repository.freezeStudy(*made));
    return made;
}

/// The participant with this code; enrols a new one if there is none.
core::Result<database::Participant> enrolled(database::WriteContext& context, const database::Actor& actor,
                                             database::StudyNumber study,
                                             const session::StudyRunRequest& request) {
    const std::string& code = request.participantCode;
    auto found = database::StudyReader(context.connection(), actor).participantByCode(study, code);
    if (found && !found->simulated)
        return core::fail(core::ErrorCode::wrongUse,
                          "--participant " + code +
                              ": a person; expected a simulated participant, or a code that is not taken");
    if (found || found.error().code != core::ErrorCode::notFound)
        return found;
    return database::StudyRepository(context.connection(), actor)
        .enrolParticipant(study, {}, 0, psychophysics::observerText(request.observer), code);
}

} // namespace

core::Result<StudyToRun> findStudyToRun(database::Database* database, const database::Actor& actor,
                                        const QString& name) {
    if (isStudyFile(name))
        return ofFile(database, actor, name);
    if (!database)
        return ofContent(name);
    auto connection = database->openReader();
    CHIRON_TRY(connection);
    auto found = findStudy(database::StudyReader(**connection, actor), name);
    if (core::failedAs(found, core::ErrorCode::notFound))
        return ofContent(name);
    CHIRON_TRY(found);
    auto design = catalogue::readStudy(QByteArray::fromStdString(found->designJson), found->summary.key);
    CHIRON_TRY(design);
    return StudyToRun{std::move(*design), std::move(*found)};
}

core::Result<void> mayBeRun(const StudyToRun& study, const session::StudyRunRequest& request) {
    const bool blind = study.design.blindExperimenter && !(study.stored && study.stored->summary.unblinded);
    // The sealed code beside the condition's name would reveal which code belongs to which condition.
    if (blind && !request.condition.empty()) {
        const std::string key = study.stored ? study.stored->summary.key : study.design.id;
        return core::fail(core::ErrorCode::wrongUse,
                          "--condition: study \"" + key +
                              "\" is blinded; expected none, or the study to be unblinded first");
    }
    return session::checkStudyRun(study.design, blind, request);
}

core::Result<ReadyToRun> makeReady(database::Database& database, const database::Actor& actor,
                                   const StudyToRun& study, const session::StudyRunRequest& request) {
    return database.write([&](database::WriteContext& context) -> core::Result<ReadyToRun> {
        database::StudyRepository repository(context.connection(), actor);
        auto number = study.stored ? core::Result<database::StudyNumber>(study.stored->summary.id)
                                   : frozen(repository, study.design);
        CHIRON_TRY(number);
        auto participant = enrolled(context, actor, *number, request);
        CHIRON_TRY(participant);
        auto record = database::StudyReader(context.connection(), actor).study(*number);
        CHIRON_TRY(record);
        return ReadyToRun{std::move(*record), std::move(*participant)};
    });
}

} // namespace chiron::cli
