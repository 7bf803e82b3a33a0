// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/roster_import.h"
#include "desktop/theme/theme.h"

#include <QStringList>

class QWidget;

namespace chiron::desktop {

/// How the file was read: "Read as UTF-8, separated by semicolons."
QString rosterReadWords(const database::Roster& roster);
/// What an import would do, and what of the file it would not use; a sentence each.
QStringList rosterPlanWords(const database::RosterPlan& plan);
/// Whether it is uncertain in some line who is meant.
bool rosterLeavesDoubts(const database::RosterPlan& plan);
/// Each line of the list, and what becomes of it. GUI thread.
QWidget* rosterTable(const Theme& theme, const database::RosterPlan& plan);

} // namespace chiron::desktop
