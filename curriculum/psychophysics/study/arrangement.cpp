// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/study/arrangement.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace chiron::psychophysics {

namespace {

struct Row {
    std::string_view token;
    std::vector<Places> arrangements;
    int answers;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> table{
        {"rank3", {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}, 6},
        {"2afc", {{0, 1}, {1, 0}}, 2},
        {"3afc", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 3},
        {"oddity", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}, 3},
        {"same_different", {{0, 0}, {1, 1}, {0, 1}, {1, 0}}, 2},
        {"yes_no", {{0}, {1}}, 2},
        {"adjustment", {{0, 1}}, 1},
        {"magnitude", {{1}}, 1},
        {"rank3_ties", {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}, kRankings},
    };
    return table;
}

const Row& rowOf(Task task) {
    return rows()[static_cast<std::size_t>(task)];
}

/// Returns the position whose object differs from both others.
int oddPlace(const Places& places) {
    for (int place = 0; place < 3; ++place)
        if (places[static_cast<std::size_t>(place)] != places[static_cast<std::size_t>((place + 1) % 3)] &&
            places[static_cast<std::size_t>(place)] != places[static_cast<std::size_t>((place + 2) % 3)])
            return place;
    return -1;
}

/// Returns a ranking in terms of the objects: the ranks given to the true 0, 1 and 2.
int rankOutcome(const Places& truth, const Ranking& said) {
    Ranking given{};
    for (std::size_t place = 0; place < given.size(); ++place)
        given[static_cast<std::size_t>(truth[place])] = said[place];
    return rankingOf(given);
}

} // namespace

std::string_view token(Task task) noexcept {
    return rowOf(task).token;
}

std::optional<Task> taskFromToken(std::string_view word) noexcept {
    for (int i = 0; i < kTasks; ++i)
        if (rows()[static_cast<std::size_t>(i)].token == word)
            return static_cast<Task>(i);
    return std::nullopt;
}

const std::array<Ranking, kRankings>& rankings() noexcept {
    static constexpr std::array<Ranking, kRankings> all{{{0, 1, 2},
                                                         {0, 2, 1},
                                                         {1, 0, 2},
                                                         {1, 2, 0},
                                                         {2, 0, 1},
                                                         {2, 1, 0},
                                                         {0, 0, 1},
                                                         {0, 1, 0},
                                                         {1, 0, 0},
                                                         {0, 1, 1},
                                                         {1, 0, 1},
                                                         {1, 1, 0},
                                                         {0, 0, 0}}};
    return all;
}

int rankingOf(const Ranking& ranks) noexcept {
    const auto& all = rankings();
    const auto found = std::find(all.begin(), all.end(), ranks);
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

const std::vector<Places>& arrangements(Task task) {
    return rowOf(task).arrangements;
}

int answers(Task task) noexcept {
    return rowOf(task).answers;
}

int placesOf(Task task) noexcept {
    return static_cast<int>(rowOf(task).arrangements.front().size());
}

int correctAnswer(Task task, int arrangement) noexcept {
    const Places& places = rowOf(task).arrangements[static_cast<std::size_t>(arrangement)];
    switch (task) {
    case Task::rank3:
    case Task::rank3Ties:
        return arrangement;
    case Task::twoAfc:
    case Task::threeAfc:
        return static_cast<int>(std::max_element(places.begin(), places.end()) - places.begin());
    case Task::oddity:
        return oddPlace(places);
    case Task::sameDifferent:
        return places[0] == places[1] ? 0 : 1;
    case Task::yesNo:
        return places[0];
    case Task::adjustment:
    case Task::magnitude:
        break;
    }
    return -1;
}

int outcomeOf(Task task, int arrangement, int answer) noexcept {
    const Row& row = rowOf(task);
    if (arrangement < 0 || static_cast<std::size_t>(arrangement) >= row.arrangements.size() || answer < 0 ||
        answer >= row.answers)
        return -1;
    if (ranksThree(task))
        return rankOutcome(row.arrangements[static_cast<std::size_t>(arrangement)],
                           rankings()[static_cast<std::size_t>(answer)]);
    return answer == correctAnswer(task, arrangement) ? 1 : 0;
}

int outcomes(Task task) noexcept {
    return task == Task::rank3 ? kStrictRankings : task == Task::rank3Ties ? kRankings : 2;
}

} // namespace chiron::psychophysics
