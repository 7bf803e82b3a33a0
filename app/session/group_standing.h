// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "session/level_standing.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace chiron::session {

/// Where one person stands at one exercise.
struct ExerciseStanding {
    std::string exercise;
    std::vector<LevelStanding> levels;  ///< in the order of the content
    std::optional<LevelStanding> open;  ///< the lowest level that is not passed; absent: every level is
    int attempts = 0;                   ///< at all levels
};

/// Where one person of a group stands.
struct PersonStanding {
    database::PersonId person = 0;
    std::string name;                               ///< the full one where there is one
    std::vector<ExerciseStanding> exercises;        ///< every exercise, in the order of the content
    std::optional<LevelStanding> next;              ///< what to do next (nextStep); absent: every level is passed
    std::optional<database::SessionSummary> latest; ///< the latest session, whatever became of it; absent: none
    int toReview = 0;                               ///< sessions that await the look of whoever asks

    bool allPassed() const noexcept { return !next; }
};

/// The trainees whose accounts are enabled, and whoever else has trained, in the order of `people`. What was recorded for a study is no training and
/// left out. Pure.
std::vector<PersonStanding> groupStandings(const catalogue::Catalogue& catalogue, std::span<const database::Person> people,
                                           std::span<const database::SessionSummary> sessions);

} // namespace chiron::session
