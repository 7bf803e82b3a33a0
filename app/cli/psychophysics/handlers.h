// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "cli/command.h"

namespace chiron::cli {

// What the psychophysics commands do; each a handler of a row in commands/psychophysics_commands.cpp.
core::Result<CommandOutput> fitCurve(const Arguments& arguments);
/// Do groups differ in a parameter: likelihood ratio and AIC of two models.
core::Result<CommandOutput> compareModels(const Arguments& arguments);
/// Prints JSON Lines while it runs: the one command that writes to stdout itself.
core::Result<CommandOutput> runAdaptive(const Arguments& arguments);
core::Result<CommandOutput> detectionTables(const Arguments& arguments);
core::Result<CommandOutput> rankings(const Arguments& arguments);

} // namespace chiron::cli
