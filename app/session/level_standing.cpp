// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/level_standing.h"

#include <algorithm>

namespace chiron::session {

using database::SessionState;

bool countsAsAttempt(const database::SessionSummary& session) noexcept {
    const bool ended = session.state != SessionState::running && session.state != SessionState::voided;
    return ended && !session.familiarisation && (session.operatorName.empty() || session.demonstration);
}

std::vector<LevelStanding> levelStandings(const catalogue::Catalogue& catalogue,
                                          std::span<const database::SessionSummary> own) {
    std::vector<LevelStanding> standings;
    for (const catalogue::Exercise& exercise : catalogue.exercises()) {
        for (const catalogue::ExerciseLevel& level : exercise.levels) {
            LevelStanding standing;
            standing.exercise = exercise.id;
            standing.level = level.number;
            for (const database::SessionSummary& session : own) {
                if (session.exercise != exercise.id || session.level != level.number ||
                    !countsAsAttempt(session))
                    continue;
                ++standing.attempts;
                standing.latest = std::max(standing.latest.value_or(0), session.id);
                const bool passed =
                    session.state == SessionState::completed && session.passed.value_or(false);
                standing.passedFelt = standing.passedFelt || (passed && session.felt);
                standing.passedShown = standing.passedShown || (passed && !session.felt);
            }
            standings.push_back(std::move(standing));
        }
    }
    return standings;
}

std::optional<LevelStanding> nextStep(std::span<const LevelStanding> standings) {
    const auto open = [](const LevelStanding& standing) { return standing.standing() != Standing::passed; };
    const auto newest =
        std::max_element(standings.begin(), standings.end(), [](const auto& a, const auto& b) {
            return a.latest.value_or(0) < b.latest.value_or(0);
        });
    if (newest != standings.end() && newest->latest) { // the exercise of the latest attempt comes first
        const auto here =
            std::find_if(standings.begin(), standings.end(), [&](const LevelStanding& standing) {
                return standing.exercise == newest->exercise && open(standing);
            });
        if (here != standings.end())
            return *here;
    }
    const auto first = std::find_if(standings.begin(), standings.end(), open);
    return first == standings.end() ? std::nullopt : std::optional(*first);
}

int attentionRank(const database::SessionSummary& session) noexcept {
    if (session.familiarisation)
        return 4;
    switch (session.state) {
    case SessionState::faulted:
    case SessionState::interrupted:
    case SessionState::incomplete:
        return 0;
    case SessionState::stopped:
        return 1;
    case SessionState::completed:
        return session.passed.value_or(false) ? 3 : 1;
    case SessionState::running:
    case SessionState::voided:
        return 4;
    }
    return 4;
}

} // namespace chiron::session
