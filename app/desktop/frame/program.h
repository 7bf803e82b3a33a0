// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>

namespace chiron::desktop {

class AppContext;
class DesktopSite;
struct Place;

/// Applies the theme, fonts and translations from the context's settings to the application.
/// Thread: GUI.
void applyAppearance(QApplication& application, AppContext& context);

/// The place where the program starts. A site folder without its database file means that the site was lost,
/// not that this is the first start.
Place firstPlace(const DesktopSite& site);

/// Whether the arguments ask only for help or the version, which need no display.
bool asksForText(int argc, const char* const* argv);

/// Prints the help or the version and returns the exit status. `arguments` begins with the program's name.
int tellText(const QStringList& arguments);

/// Runs the whole program: arguments, site, window, event loop. Returns the exit status (cli.md's numbers).
int runProgram(QApplication& application);

} // namespace chiron::desktop
