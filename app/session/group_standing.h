// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "session/level_standing.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace chiron::session {

/// The standing of one person in one exercise.
struct ExerciseStanding {
    std::string exercise;
    std::vector<LevelStanding> levels; ///< in the order of the content
    std::optional<LevelStanding> open; ///< the lowest level that is not passed; empty: all are passed
    int attempts = 0;                  ///< over all levels
};

/// The standing of one person of a group.
struct PersonStanding {
    database::PersonId person = 0;
    std::string name;                               ///< full name, if there is one
    std::vector<ExerciseStanding> exercises;        ///< every exercise, in the order of the content
    std::optional<LevelStanding> next;              ///< the next step (nextStep); empty: every level is
                                                    ///< passed
    std::optional<database::SessionSummary> latest; ///< the latest session, whatever its outcome; empty: none
    int toReview = 0;                               ///< sessions that await a review by the person who asks

    bool allPassed() const noexcept { return !next; }
};

/// The standings of all trainees with enabled accounts, and of all others who have trained, in the order of
/// `people`. Sessions recorded for a study are not training and are ignored. Pure function.
std::vector<PersonStanding> groupStandings(const catalogue::Catalogue& catalogue,
                                           std::span<const database::Person> people,
                                           std::span<const database::SessionSummary> sessions);

} // namespace chiron::session
