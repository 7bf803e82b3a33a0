// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command_spec.h"

namespace chiron::cli {

// One function per file of commands/; each returns its rows of the command table.
std::vector<CommandSpec> initCommands();
std::vector<CommandSpec> siteCommands();
std::vector<CommandSpec> userCommands();
std::vector<CommandSpec> personCommands();
std::vector<CommandSpec> exerciseCommands();
std::vector<CommandSpec> verifyCommands();
std::vector<CommandSpec> evaluateCommands();
std::vector<CommandSpec> metricsCommands();
std::vector<CommandSpec> meshCommands();
std::vector<CommandSpec> deviceCommands();
std::vector<CommandSpec> storageCommands();
std::vector<CommandSpec> trainCommands();
std::vector<CommandSpec> sessionCommands();
std::vector<CommandSpec> reviewCommands();
std::vector<CommandSpec> reportCommands();
std::vector<CommandSpec> psychophysicsCommands();
std::vector<CommandSpec> studyCommands();
std::vector<CommandSpec> demoCommands();

} // namespace chiron::cli
