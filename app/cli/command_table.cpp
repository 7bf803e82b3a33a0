// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_table.h"

#include "cli/cli_errors.h"
#include "cli/command_groups.h"

#include <algorithm>
#include <iterator>

namespace chiron::cli {

namespace {

std::vector<CommandSpec> makeTable() {
    std::vector<CommandSpec> table;
    for (const auto& group : {
             initCommands,
             siteCommands,
             userCommands,
             personCommands,
             exerciseCommands,
             trainCommands,
             sessionCommands,
             reviewCommands,
             verifyCommands,
             reportCommands,
             evaluateCommands,
             metricsCommands,
             meshCommands,
             deviceCommands,
             psychophysicsCommands,
             studyCommands,
             storageCommands,
             demoCommands,
         }) {
        std::vector<CommandSpec> rows = group();
        std::move(rows.begin(), rows.end(), std::back_inserter(table));
    }
    return table;
}

QString known(const std::vector<CommandSpec>& table, const QString& group) {
    QStringList names;
    for (const CommandSpec& command : table) {
        const QString name = group.isEmpty()          ? command.group
                             : command.group == group ? command.verb
                                                      : QString();
        if (!name.isEmpty() && !names.contains(name))
            names << name;
    }
    return names.join(QStringLiteral(", "));
}

bool takesTwo(const std::vector<CommandSpec>& table, const QString& group, const QString& word) {
    return std::any_of(table.begin(), table.end(), [&](const CommandSpec& each) {
        return each.group == group && each.verb.startsWith(word + u' ');
    });
}

} // namespace

const std::vector<CommandSpec>& commandTable() {
    static const std::vector<CommandSpec> table = makeTable();
    return table;
}

core::Result<FoundCommand> findCommand(const QStringList& words) {
    const auto& table = commandTable();
    if (words.isEmpty())
        return wrongUse(QStringLiteral("no command given; expected one of %1; see chiron-cli --help")
                            .arg(known(table, {})));
    bool groupExists = false;
    for (const CommandSpec& command : table) {
        if (command.group != words[0])
            continue;
        groupExists = true;
        if (command.verb.isEmpty())
            return FoundCommand{&command, 1};
        const auto verb = command.verb.split(u' '); // "questionnaire import": two words
        if (words.mid(1, verb.size()) == verb)
            return FoundCommand{&command, static_cast<int>(1 + verb.size())};
    }
    if (!groupExists)
        return wrongUse(QStringLiteral("command %1: unknown; expected one of %2; see chiron-cli --help")
                            .arg(quoted(words[0]), known(table, {})));
    return wrongUse(
        QStringLiteral("%1: %2; expected one of %3; see chiron-cli %1 --help")
            .arg(words[0],
                 words.size() > 1
                     ? QStringLiteral("%1 is not one of its commands")
                           .arg(quoted(words.mid(1, takesTwo(table, words[0], words[1]) ? 2 : 1).join(u' ')))
                     : QStringLiteral("needs a second word"),
                 known(table, words[0])));
}

} // namespace chiron::cli
