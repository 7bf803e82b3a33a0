// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace chiron::cli {

/// Runs the command that the arguments (without the program's name) specify, prints its result to stdout and
/// everything else to stderr, and returns the exit status. Creates the application object that the command
/// needs. Call it once, from main.
int runProgram(const QStringList& arguments);

} // namespace chiron::cli
