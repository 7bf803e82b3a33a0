// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/session_types.h"
#include "desktop/frame/place.h"

#include <QString>

namespace chiron::desktop {

class AppContext;

/// Whether the person of this session has results. The built-in simulated account has none, and a session of
/// a study belongs to its participant.
bool hasResults(const database::SessionSummary& session);

/// The place of the results of this session's person, at its exercise and level. `name` is the person's name
/// as the screens show it; if empty, the name in the session is used.
Place resultsPlace(const database::SessionSummary& session, const QString& name = {});

/// The label, for the logged-in person, of a button that opens those results: "My results", "Results of
/// Nikos"; empty if they may not see any.
QString resultsCommand(const AppContext& context, const database::SessionSummary& session);

} // namespace chiron::desktop
