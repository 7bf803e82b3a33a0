// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/group_standing.h"

#include <algorithm>
#include <map>

namespace chiron::session {

namespace {

std::vector<ExerciseStanding> byExercise(const catalogue::Catalogue& catalogue,
                                         const std::vector<LevelStanding>& standings) {
    std::vector<ExerciseStanding> exercises;
    for (const catalogue::Exercise& exercise : catalogue.exercises()) {
        ExerciseStanding standing;
        standing.exercise = exercise.id;
        for (const LevelStanding& level : standings) {
            if (level.exercise != exercise.id)
                continue;
            standing.attempts += level.attempts;
            if (!standing.open && level.standing() != Standing::passed)
                standing.open = level;
            standing.levels.push_back(level);
        }
        exercises.push_back(std::move(standing));
    }
    return exercises;
}

PersonStanding standingOf(const catalogue::Catalogue& catalogue, const database::Person& person,
                          const std::vector<database::SessionSummary>& own) {
    PersonStanding standing;
    standing.person = person.id;
    standing.name = person.displayName.empty() ? person.name : person.displayName;
    const std::vector<LevelStanding> levels = levelStandings(catalogue, own);
    standing.exercises = byExercise(catalogue, levels);
    standing.next = nextStep(levels);
    for (const database::SessionSummary& session : own) {
        standing.toReview += session.toReview ? 1 : 0;
        if (!standing.latest || standing.latest->id < session.id)
            standing.latest = session;
    }
    return standing;
}

} // namespace

std::vector<PersonStanding> groupStandings(const catalogue::Catalogue& catalogue,
                                           std::span<const database::Person> people,
                                           std::span<const database::SessionSummary> sessions) {
    std::map<database::PersonId, std::vector<database::SessionSummary>> byPerson;
    for (const database::SessionSummary& session : sessions)
        if (!session.ofStudy)
            byPerson[session.person].push_back(session);
    std::vector<PersonStanding> group;
    for (const database::Person& person : people) {
        const auto own = byPerson.find(person.id);
        if (!person.enabled || (!person.roles.contains(database::Role::trainee) && own == byPerson.end()))
            continue;
        group.push_back(
            standingOf(catalogue, person,
                       own == byPerson.end() ? std::vector<database::SessionSummary>() : own->second));
    }
    return group;
}

} // namespace chiron::session
