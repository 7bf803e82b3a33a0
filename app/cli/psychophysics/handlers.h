// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "cli/command_spec.h"

namespace chiron::cli {

// Handlers of the psychophysics commands, one per row of commands/psychophysics_commands.cpp.
core::Result<CommandOutput> fitCurve(const Arguments& arguments);
/// Tests whether groups differ in a parameter, by the likelihood ratio and the AIC of two models.
core::Result<CommandOutput> compareModels(const Arguments& arguments);
/// Prints JSON Lines while it runs. It is the only command that writes to stdout itself.
core::Result<CommandOutput> runAdaptive(const Arguments& arguments);
core::Result<CommandOutput> detectionTables(const Arguments& arguments);
core::Result<CommandOutput> rankings(const Arguments& arguments);

} // namespace chiron::cli
