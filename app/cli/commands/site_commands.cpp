// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/site_access.h"
#include "cli/text_table.h"
#include "database/repositories/site_repository.h"

#include <QJsonObject>

namespace chiron::cli {

namespace {

CommandOutput nameOutput(const std::string& stored) {
    const QString name = QString::fromStdString(stored);
    return {QJsonDocument(QJsonObject{{QStringLiteral("name"), name}}),
            alignedPairs({{QStringLiteral("name"), name.isEmpty() ? QStringLiteral("(none)") : name}}), 0};
}

core::Result<CommandOutput> showName(const Arguments& arguments) {
    const auto site = openAsAnybody(arguments, Opening::forReading);
    CHIRON_TRY(site);
    const auto connection = site->database->openReader();
    CHIRON_TRY(connection);
    return database::SiteRepository(**connection, site->actor).siteName().map(nameOutput);
}

core::Result<CommandOutput> name(const Arguments& arguments) {
    const bool removes = arguments.has(QStringLiteral("remove")), gives = !arguments.operand(0).isEmpty();
    if (removes && gives)
        return wrongUse(QStringLiteral("--remove and a NAME were given; expected one of them"));
    if (gives && arguments.operand(0).trimmed().isEmpty())
        return wrongUse(QStringLiteral("NAME is blank; expected a name, or --remove to take the name away"));
    if (!removes && !gives)
        return showName(arguments);
    const auto wanted = database::checkedSiteName(arguments.operand(0).toStdString());
    CHIRON_TRY(wanted);
    const auto site = openAsPerson(arguments, Opening::forWriting);
    CHIRON_TRY(site);
    const auto stored = site->database->write([&](database::WriteContext& writing) {
        return database::SiteRepository(writing.connection(), site->actor).setSiteName(*wanted);
    });
    CHIRON_TRY(stored);
    return nameOutput(*wanted);
}

} // namespace

std::vector<CommandSpec> siteCommands() {
    CommandSpec command;
    command.group = QStringLiteral("site");
    command.verb = QStringLiteral("name");
    command.summary = QStringLiteral("what the site is called; with NAME, give it one (administrators)");
    command.operands = {{QStringLiteral("NAME"), QStringLiteral("one line of at most 80 characters"), false}};
    command.options = {{QStringLiteral("remove"), {}, QStringLiteral("take the name away")}};
    command.example = QStringLiteral("chiron-cli site name \"Skills centre, City Hospital\" --as alice");
    command.run = name;
    return {command};
}

} // namespace chiron::cli
