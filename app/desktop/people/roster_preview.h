// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/roster_import.h"
#include "desktop/theme/theme.h"

#include <QStringList>

class QWidget;

namespace chiron::desktop {

/// Says how the file was read: "Read as UTF-8, separated by semicolons."
QString rosterReadWords(const database::Roster& roster);
/// Describes what an import would do and which parts of the file it would ignore, one sentence each.
QStringList rosterPlanWords(const database::RosterPlan& plan);
/// Whether it is uncertain for any line which person is meant.
bool rosterLeavesDoubts(const database::RosterPlan& plan);
/// A table with each line of the list and what happens with it.
/// Thread: GUI.
QWidget* rosterTable(const Theme& theme, const database::RosterPlan& plan);

} // namespace chiron::desktop
