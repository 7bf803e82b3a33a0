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

/// Where one person stands at one level. Felt and shown force are kept apart (data.md, Words).
struct LevelStanding {
    std::string exercise;
    int level = 1;
    bool passedFelt = false;
    bool passedShown = false;
    int attempts = 0;                          ///< that count: no familiarisation, none voided, no demonstration by a script
    std::optional<database::SessionId> latest; ///< of the attempts
    Standing standing() const noexcept {
        if (passedFelt || passedShown)
            return Standing::passed;
        return attempts > 0 ? Standing::tried : Standing::fresh;
    }
};

/// Whether a session is an attempt of its person: it has ended, was not voided, is no familiarisation, and no script's hand on
/// a real site (on a demonstration site scripts stand in for people).
bool countsAsAttempt(const database::SessionSummary& session) noexcept;

/// Every level in the order of the content; `own` are the sessions of one person, in any order. Pure.
std::vector<LevelStanding> levelStandings(const catalogue::Catalogue& catalogue, std::span<const database::SessionSummary> own);

/// What to do next: the lowest level that is not passed, of the exercise of the latest attempt, else of all in order; absent when every
/// level is passed. Pure.
std::optional<LevelStanding> nextStep(std::span<const LevelStanding> standings);

/// How much a session asks to be looked at by a trainer: lower comes first. Faults and interruptions, then what was not
/// passed, then the rest; familiarisations last. Pure.
int attentionRank(const database::SessionSummary& session) noexcept;

} // namespace chiron::session
