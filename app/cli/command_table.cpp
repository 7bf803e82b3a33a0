// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_table.h"

#include "cli/command_groups.h"
#include "cli/messages.h"

#include <algorithm>
#include <iterator>

namespace chiron::cli {

namespace {

std::vector<CommandSpec> makeTable() {
    std::vector<CommandSpec> table;
    for (const auto& group : {
             initCommands,
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
        const QString name = group.isEmpty() ? command.group : command.group == group ? command.verb : QString();
        if (!name.isEmpty() && !names.contains(name))
            names << name;
    }
    return names.join(QStringLiteral(", "));
}

} // namespace

const std::vector<CommandSpec>& commandTable() {
    static const std::vector<CommandSpec> table = makeTable();
    return table;
}

core::Result<FoundCommand> findCommand(const QStringList& words) {
    const auto& table = commandTable();
    if (words.isEmpty())
        return wrongUse(QStringLiteral("no command given; expected one of %1; see chiron-cli --help").arg(known(table, {})));
    bool groupExists = false;
    for (const CommandSpec& command : table) {
        if (command.group != words[0])
            continue;
        groupExists = true;
        if (command.verb.isEmpty())
            return FoundCommand{&command, 1};
        if (words.size() > 1 && command.verb == words[1])
            return FoundCommand{&command, 2};
    }
    if (!groupExists)
        return wrongUse(QStringLiteral("command %1: unknown; expected one of %2; see chiron-cli --help")
                            .arg(quoted(words[0]), known(table, {})));
    return wrongUse(QStringLiteral("%1: %2; expected one of %3; see chiron-cli %1 --help")
                        .arg(words[0],
                             words.size() > 1 ? QStringLiteral("%1 is not one of its commands").arg(quoted(words[1]))
                                              : QStringLiteral("needs a second word"),
                             known(table, words[0])));
}

} // namespace chiron::cli
