// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "database/repositories/session_types.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace chiron::session {

enum class Standing { fresh, tried, passed };

/// The standing of one person at one level. Felt and shown force are kept apart (data.md, Words).
struct LevelStanding {
    std::string exercise;
    int level = 1;
    bool passedFelt = false;
    bool passedShown = false;
    int attempts = 0;                          ///< attempts that count: without familiarisations, voided
                                               ///< sessions and demonstrations by a script
    std::optional<database::SessionId> latest; ///< the latest of the attempts
    Standing standing() const noexcept {
        if (passedFelt || passedShown)
            return Standing::passed;
        return attempts > 0 ? Standing::tried : Standing::fresh;
    }
};

/// True if a session counts as an attempt of its person: it has ended, was not voided, is not a
/// familiarisation, and was not done by a script on a real site (on a demonstration site, scripts stand in
/// for people).
bool countsAsAttempt(const database::SessionSummary& session) noexcept;

/// The standings at all levels, in the order of the content; `own` holds the sessions of one person in any
/// order. Pure function.
std::vector<LevelStanding> levelStandings(const catalogue::Catalogue& catalogue,
                                          std::span<const database::SessionSummary> own);

/// The next step: the lowest level that is not passed in the exercise of the latest attempt, else in all
/// exercises in order; empty if every level is passed. Pure function.
std::optional<LevelStanding> nextStep(std::span<const LevelStanding> standings);

/// The urgency of a session for review by a trainer; lower comes first. Faults and interruptions come first,
/// then failed sessions, then the rest; familiarisations last. Pure function.
int attentionRank(const database::SessionSummary& session) noexcept;

} // namespace chiron::session
