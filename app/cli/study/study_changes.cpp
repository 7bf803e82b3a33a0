// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "cli/cli_errors.h"
#include "cli/study/study_access.h"
#include "cli/study/study_file.h"
#include "cli/text_table.h"
#include "database/accounts/account_service.h"
#include "database/repositories/study_repository.h"
#include "session/study/people_to_come.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

namespace chiron::cli {

namespace {

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

/// Applies one change on the writer's connection, then prints the study's current state.
template <class Change> core::Result<CommandOutput> changed(StudySite& study, Change&& apply) {
    const auto number = study.number();
    auto done = study.site.database->write([&](database::WriteContext& context) -> core::Result<void> {
        return apply(database::StudyRepository(context.connection(), study.site.actor), number);
    });
    CHIRON_TRY(done);
    auto record = study.reader().study(number);
    CHIRON_TRY(record);
    const QJsonObject json = studyJson(record->summary);
    return CommandOutput{
        QJsonDocument(json),
        QStringLiteral("%1: %2 %3\n")
            .arg(json["key"].toString(), json["state"].toString(), json["sha256"].toString()),
        0};
}

template <class Change> core::Result<CommandOutput> change(const Arguments& arguments, Change&& apply) {
    auto study = openStudy(arguments, Opening::forWriting);
    CHIRON_TRY(study);
    return changed(*study, std::forward<Change>(apply));
}

core::Result<database::Participant> participantOf(const Arguments& arguments, const StudySite& study) {
    return study.reader().participantByCode(study.number(),
                                            arguments.value(QStringLiteral("participant")).toStdString());
}

template <class Change>
core::Result<CommandOutput> changeParticipant(const Arguments& arguments, Change&& apply) {
    auto study = openStudy(arguments, Opening::forWriting);
    CHIRON_TRY(study);
    const auto participant = participantOf(arguments, *study);
    CHIRON_TRY(participant);
    auto done = study->site.database->write([&](database::WriteContext& context) -> core::Result<void> {
        return apply(database::StudyRepository(context.connection(), study->site.actor), *study,
                     *participant);
    });
    CHIRON_TRY(done);
    const auto after = participantOf(arguments, *study);
    CHIRON_TRY(after);
    const QJsonObject json = participantJson(*after);
    return CommandOutput{QJsonDocument(json),
                         QStringLiteral("%1: %2\n").arg(json["code"].toString(), json["state"].toString()),
                         0};
}

/// SHA-256 of the consent text in the requested language.
core::Result<std::string> consentSha256(const Arguments& arguments, const StudySite& study) {
    const auto design =
        catalogue::readStudy(QByteArray::fromStdString(study.record.designJson), study.record.summary.key);
    CHIRON_TRY(design);
    const QString language = arguments.has(QStringLiteral("language"))
                                 ? arguments.value(QStringLiteral("language"))
                                 : QStringLiteral("en");
    const auto found = design->consent.find(language.toStdString());
    if (found == design->consent.end()) {
        QStringList written;
        for (const auto& [each, words] : design->consent)
            written << QString::fromStdString(each);
        return wrongUse(
            QStringLiteral("--language: %1: the study has no consent text in it; expected one of %2")
                .arg(quoted(language), written.join(QStringLiteral(", "))));
    }
    return catalogue::studySha256(QByteArray::fromStdString(found->second));
}

} // namespace

core::Result<CommandOutput> newStudy(const Arguments& arguments) {
    const QString from = arguments.operand(0);
    psychophysics::StudyDesign design;
    if (isStudyFile(from)) {
        auto read = readStudyFile(from);
        CHIRON_TRY(read);
        design = std::move(*read);
    } else {
        const auto content = catalogue::StudyCatalogue::load();
        CHIRON_TRY(content);
        const auto* found = content->find(from.toStdString());
        if (!found) {
            QStringList known;
            for (const psychophysics::StudyDesign& each : content->studies())
                known << QString::fromStdString(each.id);
            return core::fail(core::ErrorCode::notFound,
                              QStringLiteral("FROM %1: no such study; expected one of %2, or a JSON file")
                                  .arg(quoted(from), known.join(QStringLiteral(", ")))
                                  .toStdString());
        }
        design = *found;
    }
    if (arguments.has(QStringLiteral("id")))
        design.id = arguments.value(QStringLiteral("id")).toStdString();
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    const auto title = design.title.find("en");
    const std::string json = catalogue::studyJson(design).toStdString();
    auto number = site->database->write([&](database::WriteContext& context) {
        return database::StudyRepository(context.connection(), site->actor)
            .createStudy(design.id, title == design.title.end() ? design.id : title->second, json);
    });
    CHIRON_TRY(number);
    const QJsonObject told{
        {"id", static_cast<qint64>(*number)}, {"key", text(design.id)}, {"state", "draft"}};
    return CommandOutput{QJsonDocument(told),
                         QStringLiteral("study %1: %2, a draft\n").arg(*number).arg(text(design.id)), 0};
}

core::Result<CommandOutput> freezeStudy(const Arguments& arguments) {
    return change(
        arguments,
        [](database::StudyRepository repository, database::StudyNumber study) -> core::Result<void> {
            CHIRON_TRY(repository.freezeStudy(study));
            return {};
        });
}

core::Result<CommandOutput> closeStudy(const Arguments& arguments) {
    return change(arguments, [](database::StudyRepository repository, database::StudyNumber study) {
        return repository.closeStudy(study);
    });
}

core::Result<CommandOutput> archiveStudy(const Arguments& arguments) {
    const bool archived = !arguments.has(QStringLiteral("undo"));
    return change(arguments, [&](database::StudyRepository repository, database::StudyNumber study) {
        return repository.setStudyArchived(study, archived);
    });
}

core::Result<CommandOutput> unblindStudy(const Arguments& arguments) {
    const std::string reason = arguments.value(QStringLiteral("reason")).toStdString();
    auto study = openStudy(arguments, Opening::forWriting);
    CHIRON_TRY(study);
    const auto design =
        catalogue::readStudy(QByteArray::fromStdString(study->record.designJson), study->record.summary.key);
    CHIRON_TRY(design);
    const auto participants = study->reader().participants(study->number());
    CHIRON_TRY(participants);
    auto done = changed(*study, [&](database::StudyRepository repository, database::StudyNumber number) {
        return repository.unblindStudy(number, reason);
    });
    CHIRON_TRY(done);
    const int toCome = session::peopleToCome(*design, study->record.summary, *participants);
    QJsonObject json = done->json.object();
    json.insert("people_to_come", toCome);
    done->json = QJsonDocument(json);
    if (toCome > 0)
        done->text +=
            QStringLiteral("warning: %1 still to come: whoever conducts their runs is no longer blind\n")
                .arg(toCome == 1 ? QStringLiteral("1 participant is")
                                 : QStringLiteral("%1 participants are").arg(toCome));
    return done;
}

core::Result<CommandOutput> enrolParticipant(const Arguments& arguments) {
    const std::string given = qgetenv("CHIRON_IDENTITY").toStdString();
    qunsetenv("CHIRON_IDENTITY"); // so that no child process or crash report inherits it
    auto study = openStudy(arguments, Opening::forWriting);
    CHIRON_TRY(study);
    const std::string& identity =
        arguments.has(QStringLiteral("password-stdin")) ? study->site.secrets[1] : given;
    const std::string account = arguments.value(QStringLiteral("account")).toStdString();
    if (identity.empty() && account.empty())
        return wrongUse(QStringLiteral("identity: none given; expected it in CHIRON_IDENTITY or, with "
                                       "--password-stdin, as the second line of stdin, or --account"));
    const auto number = study->number();
    auto enrolled = study->site.database->write([&](database::WriteContext& context) {
        database::StudyRepository studies(context.connection(), study->site.actor);
        return account.empty() ? studies.enrolParticipant(number, identity, 0, {})
                               : studies.enrolAccount(number, identity, account);
    });
    CHIRON_TRY(enrolled);
    const QJsonObject json = participantJson(*enrolled);
    return CommandOutput{QJsonDocument(json),
                         QStringLiteral("%1: order %2\n").arg(json["code"].toString()).arg(enrolled->order),
                         0};
}

core::Result<CommandOutput> consentOf(const Arguments& arguments) {
    return changeParticipant(arguments,
                             [&](database::StudyRepository repository, const StudySite& study,
                                 const database::Participant& participant) -> core::Result<void> {
                                 const auto sha256 = consentSha256(arguments, study);
                                 CHIRON_TRY(sha256);
                                 return repository.recordConsent(participant.id, *sha256);
                             });
}

core::Result<CommandOutput> withdrawParticipant(const Arguments& arguments) {
    const bool erase = arguments.has(QStringLiteral("erase-recordings"));
    return changeParticipant(arguments, [&](database::StudyRepository repository, const StudySite&,
                                            const database::Participant& participant) {
        return repository.withdrawParticipant(participant.id, erase);
    });
}

core::Result<CommandOutput> eraseParticipant(const Arguments& arguments) {
    auto study = openStudy(arguments, Opening::forWriting);
    CHIRON_TRY(study);
    const auto participant = participantOf(arguments, *study);
    CHIRON_TRY(participant);
    const QString reason = arguments.value(QStringLiteral("reason"));
    const auto done = database::AccountService(*study->site.database)
                          .eraseParticipant(study->site.actor, study->site.secrets[0], participant->id,
                                            reason.toStdString());
    CHIRON_TRY(done);
    const QJsonObject json{{"participant", text(participant->code)},
                           {"erased", true},
                           {"reason", reason},
                           {"recordings_withdrawn", participant->recordingsToErase}};
    return CommandOutput{QJsonDocument(json),
                         QStringLiteral("%1 is erased: identity and free answers are overwritten%2; runs and "
                                        "trials stay under the code.\n"
                                        "Backups and copies made before still hold them until they are "
                                        "deleted; a restore erases them again.\n")
                             .arg(text(participant->code), participant->recordingsToErase
                                                               ? QStringLiteral(", recordings too")
                                                               : QString()),
                         0};
}

core::Result<CommandOutput> studyKey(const Arguments& arguments) {
    auto study = openStudy(arguments, Opening::forWriting); // because the look-up is audited
    CHIRON_TRY(study);
    const auto number = study->number();
    auto keys = study->site.database->write([&](database::WriteContext& context) {
        return database::StudyReader(context.connection(), study->site.actor).participantKeys(number);
    });
    CHIRON_TRY(keys);
    QJsonArray array;
    const bool linked = std::any_of(keys->begin(), keys->end(),
                                    [](const database::ParticipantKey& key) { return !key.account.empty(); });
    TextTable table(linked ? QStringList{"code", "identity", "account"} : QStringList{"code", "identity"});
    for (const database::ParticipantKey& key : *keys) {
        QJsonObject one{{"code", text(key.code)}, {"identity", text(key.identity)}};
        if (!key.account.empty())
            one.insert("account", text(key.account));
        array.append(one);
        table.add(linked ? QStringList{text(key.code), text(key.identity), text(key.account)}
                         : QStringList{text(key.code), text(key.identity)});
    }
    return CommandOutput{
        QJsonDocument(QJsonObject{{"study", text(study->record.summary.key)}, {"participants", array}}),
        table.toText(), 0};
}

} // namespace chiron::cli
