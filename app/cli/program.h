// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace chiron::cli {

/// Runs the command that the arguments (without the program's name) name, prints its result to stdout and
/// everything else to stderr, and returns the exit status. Makes the application object the command needs.
/// Call once, from main.
int runProgram(const QStringList& arguments);

} // namespace chiron::cli
