// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/session_types.h"
#include "desktop/frame/place.h"

#include <QString>

namespace chiron::desktop {

class AppContext;

/// Whether there are results of whose session this is: not of the built-in simulated account, nor of a sitting of a study, which is its
/// participant's.
bool hasResults(const database::SessionSummary& session);

/// The results of whose session this is, at its exercise and level. `name`: what screens call that person; empty: as the session says.
Place resultsPlace(const database::SessionSummary& session, const QString& name = {});

/// What a button that goes there says to whoever is logged in: "My results", "Results of Nikos"; empty where there is nothing for them.
QString resultsCommand(const AppContext& context, const database::SessionSummary& session);

} // namespace chiron::desktop
