// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>

namespace chiron::desktop {

class AppContext;
class DesktopSite;
struct Place;

/// Puts theme, fonts and translations of the context's settings on the application. GUI thread.
void applyAppearance(QApplication& application, AppContext& context);

/// Where the program begins: a site folder without its file is a site that was lost, and no first start.
Place firstPlace(const DesktopSite& site);

/// Whether the arguments ask for help or the version alone, which need no display.
bool asksForText(int argc, const char* const* argv);

/// Prints the help or the version, and returns the exit status. `arguments` begin with the program's name.
int tellText(const QStringList& arguments);

/// The whole program: arguments, site, window, event loop. Returns the exit status (cli.md's numbers).
int runProgram(QApplication& application);

} // namespace chiron::desktop
