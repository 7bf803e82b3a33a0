// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/person_output.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "database/accounts/account_service.h"
#include "database/repositories/privacy_repository.h"

#include <QJsonArray>
#include <QSaveFile>

namespace chiron::cli {

namespace {

// A person may find their own account without the right to look up others.
core::Result<database::PersonId> personOf(Site& site, const std::string& name) {
    if (name == site.actor.name())
        return site.actor.personId();
    const auto person = database::AccountService(*site.database).personByName(site.actor, name);
    CHIRON_TRY(person);
    return person->id;
}

// A person whose erasure was interrupted no longer has a name, so "erased-12" identifies them by number to
// erase them again.
core::Result<database::PersonId> personToErase(Site& site, const QString& name) {
    const QString prefix = QStringLiteral("erased-");
    bool number = false;
    const qlonglong id = name.startsWith(prefix) ? name.mid(prefix.size()).toLongLong(&number) : 0;
    return number ? core::Result<database::PersonId>(id) : personOf(site, name.toStdString());
}

core::Result<void> writeFile(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        return core::fail(core::ErrorCode::storage, QStringLiteral("--output %1: was not written: %2")
                                                        .arg(quoted(path), file.errorString())
                                                        .toStdString());
    return {};
}

core::Result<CommandOutput> exportPerson(const Arguments& arguments) {
    auto site = openAsPerson(arguments, Opening::forReading);
    CHIRON_TRY(site);
    const auto id = personOf(*site, arguments.operand(0).toStdString());
    CHIRON_TRY(id);
    const auto connection = site->database->openReader();
    CHIRON_TRY(connection);
    const auto everything = database::PrivacyRepository(**connection, site->actor).exportPerson(*id);
    CHIRON_TRY(everything);
    const QJsonDocument json(personExportJson(*everything));
    const QString output = arguments.value(QStringLiteral("output"));
    if (!output.isEmpty()) {
        CHIRON_TRY(writeFile(output, json.toJson()));
    }
    const QString text =
        peopleText({everything->person}) + QLatin1Char('\n') +
        alignedPairs(
            {{QStringLiteral("sessions"), QString::number(everything->sessions.size())},
             {QStringLiteral("comments written"), QString::number(everything->commentsWritten.size())},
             {QStringLiteral("audit entries"), QString::number(everything->audit.size())},
             {QStringLiteral("everything held"),
              output.isEmpty() ? QStringLiteral("with --json or --output FILE") : output}});
    return CommandOutput{json, text, 0};
}

core::Result<CommandOutput> erasePerson(const Arguments& arguments) {
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    const auto id = personToErase(*site, arguments.operand(0));
    CHIRON_TRY(id);
    const bool withdraw = arguments.has(QStringLiteral("withdraw-recordings"));
    const QString reason = arguments.value(QStringLiteral("reason"));
    const auto done = database::AccountService(*site->database)
                          .erasePerson(site->actor, site->secrets[0], *id, reason.toStdString(), withdraw);
    CHIRON_TRY(done);
    const QJsonObject json{{QStringLiteral("id"), static_cast<qint64>(*id)},
                           {QStringLiteral("erased"), true},
                           {QStringLiteral("reason"), reason},
                           {QStringLiteral("recordings_withdrawn"), withdraw}};
    return CommandOutput{
        QJsonDocument(json),
        QStringLiteral(
            "Person %1 is erased: identity and free texts are overwritten%2; scores stay without a name.\n"
            "Backups and copies made before still hold it until they are deleted; a restore erases it "
            "again.\n")
            .arg(*id)
            .arg(withdraw ? QStringLiteral(", recordings too") : QString()),
        0};
}

} // namespace

std::vector<CommandSpec> personCommands() {
    const OperandSpec name{QStringLiteral("NAME"), QStringLiteral("login name")};
    CommandSpec exporting;
    exporting.group = QStringLiteral("person");
    exporting.verb = QStringLiteral("export");
    exporting.summary = QStringLiteral("everything held about one person");
    exporting.operands = {name};
    exporting.options = {
        {QStringLiteral("output"), QStringLiteral("FILE"), QStringLiteral("write it there as JSON")}};
    exporting.example = QStringLiteral("chiron-cli person export bob --as alice --json > bob.json");
    exporting.run = exportPerson;
    CommandSpec erasing;
    erasing.group = QStringLiteral("person");
    erasing.verb = QStringLiteral("erase");
    erasing.summary = QStringLiteral(
        "overwrite who a person was; cannot be undone; the administrator's password confirms it");
    erasing.operands = {
        {QStringLiteral("NAME"), QStringLiteral("login name; erased-NUMBER to go on where it stopped")}};
    erasing.options = {
        {QStringLiteral("reason"), QStringLiteral("TEXT"), QStringLiteral("why, kept in the tombstone"),
         true},
        {QStringLiteral("withdraw-recordings"), {}, QStringLiteral("overwrite the recordings too")}};
    erasing.example =
        QStringLiteral("chiron-cli person erase bob --reason \"asked to be forgotten\" --as alice");
    erasing.run = erasePerson;
    return {exporting, erasing};
}

} // namespace chiron::cli
