// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command_spec.h"

namespace chiron::cli {

/// The list of all commands.
QString overallHelp();
/// The commands of one group, for example "user".
QString groupHelp(const QString& group);
/// Usage, operands, options and an example of one command.
QString commandHelp(const CommandSpec& command);

} // namespace chiron::cli
