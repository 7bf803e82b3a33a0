// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command_spec.h"

#include <QStringList>

namespace chiron::cli {

/// Every command, in the order of the help.
const std::vector<CommandSpec>& commandTable();

/// The command that the first one to three words name, and how many words it uses.
/// Errors: wrongUse, naming the word found and the words that are possible there.
struct FoundCommand {
    const CommandSpec* command = nullptr;
    int words = 0;
};
core::Result<FoundCommand> findCommand(const QStringList& words);

} // namespace chiron::cli
