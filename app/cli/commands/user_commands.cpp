// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/initial_password.h"
#include "cli/input_file.h"
#include "cli/person_output.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "database/accounts/account_service.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

namespace {

core::Result<database::RoleSet> roles(const Arguments& arguments) {
    CHIRON_TRY(arguments.list(QStringLiteral("role")));
    const QString given = arguments.value(QStringLiteral("role"));
    const auto set = database::rolesFromList(given.toStdString());
    if (!set)
        return wrongUse(
            QStringLiteral(
                "--role: %1: expected some of trainee,trainer,researcher,admin with commas between them")
                .arg(quoted(given)));
    return *set;
}

// The output of a change to an account: the account's current state.
core::Result<CommandOutput> accountNow(Site& site, database::AccountService& accounts,
                                       const std::string& name, const QString& initialPassword = {}) {
    const auto person = accounts.personByName(site.actor, name);
    CHIRON_TRY(person);
    QJsonObject json = personJson(*person);
    QString text = peopleText({*person});
    if (!initialPassword.isEmpty()) {
        json[QStringLiteral("initial_password")] = initialPassword;
        text += QStringLiteral(
                    "\nInitial password: %1\nIt is shown this once and must be changed at the first login.\n")
                    .arg(initialPassword);
    }
    return CommandOutput{QJsonDocument(json), text, 0};
}

core::Result<CommandOutput> add(const Arguments& arguments) {
    const auto set = roles(arguments);
    CHIRON_TRY(set);
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    const NewPassword password = newPasswordOrGenerated(site->secrets);
    database::AccountService accounts(*site->database);
    database::PersonRequest request;
    request.name = arguments.operand(0).toStdString();
    request.displayName = arguments.value(QStringLiteral("display-name")).toStdString();
    request.roles = *set;
    request.password = password.value;
    request.mustChangePassword = password.generated || arguments.has(QStringLiteral("must-change"));
    CHIRON_TRY(accounts.createPerson(site->actor, request));
    return accountNow(*site, accounts, request.name,
                      password.generated ? QString::fromStdString(password.value) : QString());
}

core::Result<CommandOutput> list(const Arguments& arguments) {
    auto site = openAsPerson(arguments, Opening::forReading);
    CHIRON_TRY(site);
    const auto people = database::AccountService(*site->database).listPeople(site->actor);
    CHIRON_TRY(people);
    QJsonArray json;
    for (const database::Person& person : *people)
        json.append(personJson(person));
    return CommandOutput{QJsonDocument(json), peopleText(*people), 0};
}

core::Result<CommandOutput> setEnabled(const Arguments& arguments, bool enabled) {
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    database::AccountService accounts(*site->database);
    const std::string name = arguments.operand(0).toStdString();
    const auto person = accounts.personByName(site->actor, name);
    CHIRON_TRY(person);
    CHIRON_TRY(accounts.setEnabled(site->actor, person->id, enabled));
    return accountNow(*site, accounts, name);
}

core::Result<CommandOutput> disable(const Arguments& arguments) {
    return setEnabled(arguments, false);
}

core::Result<CommandOutput> enable(const Arguments& arguments) {
    return setEnabled(arguments, true);
}

core::Result<CommandOutput> role(const Arguments& arguments) {
    const auto set = roles(arguments);
    CHIRON_TRY(set);
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    database::AccountService accounts(*site->database);
    const std::string name = arguments.operand(0).toStdString();
    const auto person = accounts.personByName(site->actor, name);
    CHIRON_TRY(person);
    CHIRON_TRY(accounts.setRoles(site->actor, person->id, *set));
    return accountNow(*site, accounts, name);
}

core::Result<CommandOutput> passwd(const Arguments& arguments) {
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    database::AccountService accounts(*site->database);
    const std::string name =
        arguments.operand(0).isEmpty() ? site->actor.name() : arguments.operand(0).toStdString();
    if (name == site->actor.name()) { // their own account: the old password is required
        if (site->secrets[1].empty())
            return wrongUse(QStringLiteral(
                "new password: none given; expected it in CHIRON_NEW_PASSWORD or, with --password-stdin, "
                "as the second line of stdin"));
        CHIRON_TRY(accounts.changePassword(site->actor, site->secrets[0], site->secrets[1]));
        const QJsonObject json{{QStringLiteral("name"), QString::fromStdString(name)},
                               {QStringLiteral("changed"), true}};
        return CommandOutput{
            QJsonDocument(json),
            QStringLiteral("The password of %1 is changed.\n").arg(printable(QString::fromStdString(name))),
            0};
    }
    const auto person = accounts.personByName(site->actor, name);
    CHIRON_TRY(person);
    const NewPassword password = newPasswordOrGenerated(site->secrets);
    CHIRON_TRY(accounts.resetPassword(site->actor, person->id, password.value));
    return accountNow(*site, accounts, name,
                      password.generated ? QString::fromStdString(password.value) : QString());
}

core::Result<database::RosterExisting> existingPeople(const Arguments& arguments) {
    const auto word =
        arguments.choice(QStringLiteral("existing"), {QStringLiteral("skip"), QStringLiteral("update")},
                         QStringLiteral("skip"));
    CHIRON_TRY(word);
    return *word == QLatin1String("update") ? database::RosterExisting::update
                                            : database::RosterExisting::skip;
}

// Names people who were recognised by an earlier login name, and people whose identity is uncertain.
QString whoIsMeantText(const database::RosterStep& step) {
    using Doubt = database::RosterStep::Doubt;
    const QString name = quoted(QString::fromStdString(step.name));
    const QString line = QStringLiteral("Line %1: ").arg(step.line);
    switch (step.doubt) {
    case Doubt::none:
        if (step.earlierName.empty())
            return {};
        return line + QStringLiteral("%1 is known as %2 today.\n")
                          .arg(quoted(QString::fromStdString(step.earlierName)), name);
    case Doubt::nameOfAnother:
        return line + QStringLiteral("%1 used to be the login name of %2; whoever has it today was meant.\n")
                          .arg(name, quoted(QString::fromStdString(step.other)));
    case Doubt::severalHadIt:
        return line + QStringLiteral("several people had the login name %1 before and nobody has it today; "
                                     "nobody was changed.\n")
                          .arg(name);
    case Doubt::sameAsLine:
        return line + QStringLiteral(
                          "the same person as in line %1, under another login name; only that line counts.\n")
                          .arg(step.otherLine);
    }
    return {};
}

QString toldText(const database::RosterStep& step) {
    QString text = whoIsMeantText(step);
    if (!step.earlierDisplayName.empty())
        text += QStringLiteral(
                    "Line %1: the full name %2 is an earlier one of %3, whose full name was left as it is.\n")
                    .arg(step.line)
                    .arg(quoted(QString::fromStdString(step.earlierDisplayName)),
                         quoted(QString::fromStdString(step.name)));
    return text;
}

QJsonObject toldJson(const database::RosterStep& step) {
    using Doubt = database::RosterStep::Doubt;
    const bool byEarlier = !step.earlierName.empty();
    QJsonObject json{
        {QStringLiteral("line"), step.line},
        {QStringLiteral("name"), QString::fromStdString(byEarlier ? step.earlierName : step.name)}};
    if (byEarlier)
        json[QStringLiteral("name_today")] = QString::fromStdString(step.name);
    if (step.doubt == Doubt::nameOfAnother)
        json[QStringLiteral("earlier_name_of")] = QString::fromStdString(step.other);
    if (step.doubt == Doubt::severalHadIt)
        json[QStringLiteral("earlier_name_of_several")] = true;
    if (step.doubt == Doubt::sameAsLine)
        json[QStringLiteral("same_person_as_line")] = step.otherLine;
    if (!step.earlierDisplayName.empty())
        json[QStringLiteral("earlier_full_name")] = QString::fromStdString(step.earlierDisplayName);
    return json;
}

// Generated passwords are shown here, and only this once.
CommandOutput importOutput(const database::RosterOutcome& done) {
    QJsonArray ids;
    QJsonArray passwords;
    QString text = QStringLiteral("%1 people imported; each must change the password at the first login.\n")
                       .arg(done.added.size());
    if (done.updated > 0 || done.skipped > 0)
        text += QStringLiteral("Of those who had an account, %1 were updated and %2 left as they are.\n")
                    .arg(done.updated)
                    .arg(done.skipped);
    QJsonArray told;
    for (const database::RosterStep& step : done.told) {
        told.append(toldJson(step));
        text += toldText(step);
    }
    QJsonArray ignored;
    for (const std::string& title : done.ignoredColumns) {
        ignored.append(QString::fromStdString(title));
        text += QStringLiteral("Column not imported: %1\n").arg(printable(QString::fromStdString(title)));
    }
    QString made;
    for (const database::ImportedPerson& person : done.added) {
        ids.append(static_cast<qint64>(person.id));
        if (person.madePassword.empty())
            continue;
        const QString name = QString::fromStdString(person.name);
        const QString password = QString::fromStdString(person.madePassword);
        passwords.append(
            QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("initial_password"), password}});
        made += QStringLiteral("%1  %2\n").arg(password, printable(name));
    }
    if (!made.isEmpty())
        text += QStringLiteral("Initial passwords, shown this once:\n") + made;
    return {QJsonDocument(QJsonObject{{QStringLiteral("imported"), static_cast<qint64>(done.added.size())},
                                      {QStringLiteral("ids"), ids},
                                      {QStringLiteral("updated"), done.updated},
                                      {QStringLiteral("skipped"), done.skipped},
                                      {QStringLiteral("names"), told},
                                      {QStringLiteral("ignored_columns"), ignored},
                                      {QStringLiteral("passwords"), passwords}}),
            text, 0};
}

core::Result<CommandOutput> importCsv(const Arguments& arguments) {
    constexpr qint64 kLargest = 16 << 20;
    const auto existing = existingPeople(arguments);
    CHIRON_TRY(existing);
    const auto bytes = readInputFile(arguments.operand(0), kLargest);
    CHIRON_TRY(bytes);
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    const auto done =
        database::AccountService(*site->database).importCsv(site->actor, bytes->toStdString(), *existing);
    // The database layer knows lines and columns; the file name is known here.
    if (!done)
        return core::fail(done.error().code,
                          arguments.operand(0).toStdString() + ": " + done.error().message);
    return importOutput(*done);
}

core::Result<CommandOutput> rename(const Arguments& arguments) {
    if (!arguments.has(QStringLiteral("name")) && !arguments.has(QStringLiteral("display-name")))
        return wrongUse(QStringLiteral("nothing to change: expected --name, --display-name or both"));
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    database::AccountService accounts(*site->database);
    const auto person = accounts.personByName(site->actor, arguments.operand(0).toStdString());
    CHIRON_TRY(person);
    const auto given = [&](const char* option, const std::string& before) {
        const QString name = QLatin1String(option);
        return arguments.has(name) ? arguments.value(name).toStdString() : before;
    };
    const std::string name = given("name", person->name);
    CHIRON_TRY(
        accounts.changeNames(site->actor, person->id, name, given("display-name", person->displayName)));
    return accountNow(*site, accounts, name);
}

core::Result<CommandOutput> recover(const Arguments& arguments) {
    const auto secrets = readSecrets(
        arguments, {QStringLiteral("CHIRON_RECOVERY_CODE"), QStringLiteral("CHIRON_NEW_PASSWORD")});
    CHIRON_TRY(secrets);
    if ((*secrets)[1].empty())
        return wrongUse(QStringLiteral(
            "new password: none given; expected it in CHIRON_NEW_PASSWORD or, with --password-stdin, as the "
            "second line of stdin"));
    const auto database =
        database::Database::openForWriting(databasePath(arguments).toStdString(), databaseOptions());
    CHIRON_TRY(database);
    const auto code = database::AccountService(**database)
                          .recover(arguments.operand(0).toStdString(), (*secrets)[0], (*secrets)[1]);
    CHIRON_TRY(code);
    const QString shown = QString::fromStdString(*code);
    return CommandOutput{
        QJsonDocument(QJsonObject{{QStringLiteral("name"), arguments.operand(0)},
                                  {QStringLiteral("recovery_code"), shown}}),
        QStringLiteral("The password is changed. New recovery code, shown this once: %1\n").arg(shown), 0};
}

core::Result<CommandOutput> recoveryCode(const Arguments& arguments) {
    auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    const auto code =
        database::AccountService(*site->database).makeRecoveryCode(site->actor, site->secrets[0]);
    CHIRON_TRY(code);
    const QString name = QString::fromStdString(site->actor.name());
    const QString shown = QString::fromStdString(*code);
    return CommandOutput{
        QJsonDocument(QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("recovery_code"), shown}}),
        QStringLiteral("Recovery code of %1, shown this once: %2\nAn earlier one is no longer accepted.\n")
            .arg(printable(name), shown),
        0};
}

CommandSpec spec(const char* verb, const char* summary, const char* example,
                 core::Result<CommandOutput> (*run)(const Arguments&)) {
    CommandSpec command;
    command.group = QStringLiteral("user");
    command.verb = QLatin1String(verb);
    command.summary = QLatin1String(summary);
    command.example = QLatin1String(example);
    command.run = run;
    return command;
}

} // namespace

std::vector<CommandSpec> userCommands() {
    const OperandSpec name{QStringLiteral("NAME"), QStringLiteral("login name")};
    const OptionSpec role_{QStringLiteral("role"), QStringLiteral("ROLE,..."),
                           QStringLiteral("some of trainee,trainer,researcher,admin"), true};
    CommandSpec adding = spec("add",
                              "make an account; its password: CHIRON_NEW_PASSWORD, stdin's second line, or "
                              "one made up and shown once",
                              "chiron-cli user add bob --role trainee --as alice", add);
    adding.operands = {name};
    adding.options = {
        role_,
        {QStringLiteral("display-name"), QStringLiteral("TEXT"), QStringLiteral("the name that others see")},
        {QStringLiteral("must-change"),
         {},
         QStringLiteral("the password must be changed at the first login")}};
    CommandSpec disabling = spec("disable", "close an account; nothing is deleted",
                                 "chiron-cli user disable bob --as alice", disable);
    CommandSpec enabling =
        spec("enable", "open a closed account again", "chiron-cli user enable bob --as alice", enable);
    CommandSpec changing = spec("role", "set the roles of a person",
                                "chiron-cli user role bob --role trainee,trainer --as alice", role);
    disabling.operands = enabling.operands = changing.operands = {name};
    changing.options = {role_};
    CommandSpec setting = spec("passwd", "change one's own password, or as an administrator set somebody's",
                               "chiron-cli user passwd --as bob", passwd);
    setting.operands = {{QStringLiteral("NAME"), QStringLiteral("login name; default: one's own"), false}};
    CommandSpec importing = spec("import-csv",
                                 "make accounts from a CSV file as a spreadsheet saves it (login name, full "
                                 "name, role, password), all or none",
                                 "chiron-cli user import-csv roster.csv --as alice", importCsv);
    importing.operands = {{QStringLiteral("FILE.csv"), QStringLiteral("the roster")}};
    importing.options = {
        {QStringLiteral("existing"), QStringLiteral("skip|update"),
         QStringLiteral("what happens with people who have an account already (default: skip)")}};
    CommandSpec renaming = spec("rename", "change a person's login name or full name; what they were is kept",
                                "chiron-cli user rename bob --name robert --as alice", rename);
    renaming.operands = {name};
    renaming.options = {
        {QStringLiteral("name"), QStringLiteral("NEW"), QStringLiteral("the new login name")},
        {QStringLiteral("display-name"), QStringLiteral("TEXT"), QStringLiteral("the name that others see")}};
    CommandSpec recovering = spec(
        "recover", "set a new password with the recovery code (CHIRON_RECOVERY_CODE, CHIRON_NEW_PASSWORD)",
        "chiron-cli user recover alice --password-stdin < secrets.txt", recover);
    recovering.operands = {name};
    return {adding,
            spec("list", "the accounts", "chiron-cli user list --as alice --json", list),
            disabling,
            enabling,
            changing,
            setting,
            importing,
            renaming,
            recovering,
            spec("recovery-code",
                 "make a recovery code for oneself, as an administrator; it replaces the one before",
                 "chiron-cli user recovery-code --as alice", recoveryCode)};
}

} // namespace chiron::cli
