// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_types.h"
#include "scoring/score_card.h"

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// One of a person's sessions with its latest stored scores.
struct Attempt {
    database::SessionSummary summary;
    std::vector<scoring::MetricValue> metrics; ///< empty if the session was never scored

    const scoring::MetricValue* metric(const std::string& id) const;
    /// Whether the session is a point on a learning curve: it is completed and counts as an attempt of its
    /// person (SessionSummary::attempt).
    bool onCurve() const;
};

/// Reads a person's sessions in the order of their numbers. `progress` receives 0..1; returning false from it
/// stops.
/// Thread: worker; blocks.
/// Errors: those of the repositories; cancelled.
core::Result<std::vector<Attempt>> loadAttempts(database::Connection& connection,
                                                const database::Actor& actor, database::PersonId person,
                                                const std::function<bool(double)>& progress);

/// Writes everything stored about the actor's own person into a new folder inside `parent` (person.json, and
/// the samples of each session as CSV) and returns the folder.
/// Thread: worker; blocks.
/// Errors: those of the repositories; storage; cancelled (files that were already written stay).
core::Result<std::string> exportOwnData(database::Connection& connection, const database::Actor& actor,
                                        const std::string& parent,
                                        const std::function<bool(double)>& progress);

} // namespace chiron::desktop
