// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>

namespace chiron::desktop {

class AppContext;

/// Puts theme, fonts and translations of the context's settings on the application. GUI thread.
void applyAppearance(QApplication& application, AppContext& context);

/// The whole program: arguments, site, window, event loop. Returns the exit status (cli.md's numbers).
int runProgram(QApplication& application);

} // namespace chiron::desktop
