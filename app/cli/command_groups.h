// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace chiron::cli {

// One function a file of commands/; each returns its rows of the table.
std::vector<CommandSpec> evaluateCommands();
std::vector<CommandSpec> metricsCommands();
std::vector<CommandSpec> deviceCommands();

} // namespace chiron::cli
