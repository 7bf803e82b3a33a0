// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// What a participant is asked to do. Files contain the token in quotes.
enum class Task : std::uint8_t {
    rank3,         ///< "rank3": put three objects (0, D, 2D above the reference) in order (P2)
    twoAfc,        ///< "2afc": which of two is more
    threeAfc,      ///< "3afc": which of three is more; the other two are the reference
    oddity,        ///< "oddity": which of three is the odd one (triangle)
    sameDifferent, ///< "same_different": two objects, same or different
    /// "yes_no": whether one object is more than the reference, which was explored before.
    yesNo,
    adjustment, ///< "adjustment": make the comparison equal to the reference
    magnitude,  ///< "magnitude": give each object a number
    rank3Ties,  ///< "rank3_ties": as rank3, but neighbours may be called equal
};
inline constexpr int kTasks = 9;
std::string_view token(Task task) noexcept;
std::optional<Task> taskFromToken(std::string_view word) noexcept;

/// The objects that a participant explores, from left to right: how many times the difference D is added at
/// each position. 0 is the reference, 1 is D, 2 is twice D.
using Places = std::vector<int>;

/// Returns all arrangements of a task, in the fixed order in which presentation words count them (at most
/// 16):
/// rank3, rank3_ties: the six orders of {0,1,2}, lexicographic; 2afc: {0,1}, {1,0}; 3afc: {1,0,0}, {0,1,0},
/// {0,0,1};
/// oddity: {1,0,0}, {0,1,0}, {0,0,1}, {0,1,1}, {1,0,1}, {1,1,0}; same_different: {0,0}, {1,1}, {0,1}, {1,0};
/// yes_no: {0}, {1}; adjustment: {0,1} (the left one is the reference and does not change); magnitude: {1}.
const std::vector<Places>& arrangements(Task task);

/// Returns whether the task is to put three objects in order, with or without ties.
constexpr bool ranksThree(Task task) noexcept {
    return task == Task::rank3 || task == Task::rank3Ties;
}

/// All possible rankings of three objects: the rank of each object from 0 (least), with equal ranks for ties
/// and no rank skipped. First come the six orders of rank3, as in arrangements(rank3); then {0,0,1}, {0,1,0},
/// {1,0,0}, {0,1,1}, {1,0,1}, {1,1,0} and {0,0,0}.
inline constexpr int kStrictRankings = 6;
inline constexpr int kRankings = 13;
using Ranking = std::array<std::int8_t, 3>;
const std::array<Ranking, kRankings>& rankings() noexcept;
/// Returns the index of a ranking; -1 if it is none of them.
int rankingOf(const Ranking& ranks) noexcept;

/// Returns the number of possible answers, as `answer` commands and stored trials count them. rank3: the
/// first six of rankings(), rank3_ties: all of them, where a ranking gives the rank said at each position (of
/// rank3: "places hold these multiples"); 2afc, 3afc, oddity: the position, from 0; same_different: 0 same, 1
/// different; yes_no: 0 no, 1 yes; adjustment: 0 (set); magnitude: 0 (the number is the trial's `value`).
int answers(Task task) noexcept;

/// Returns the right answer for an arrangement; -1 if no answer is right or wrong (adjustment, magnitude).
int correctAnswer(Task task, int arrangement) noexcept;

/// Converts an answer into the outcome that a procedure uses, which does not depend on the positions. rank3,
/// rank3_ties: the index in rankings() of the ranks given to the true 0, 1, 2 (0: all correct); other tasks:
/// 1 right, 0 wrong. −1: the task has no such arrangement or answer.
int outcomeOf(Task task, int arrangement, int answer) noexcept;
/// Returns the number of outcomes: 6, 13 or 2.
int outcomes(Task task) noexcept;

/// Returns how many objects lie side by side.
int placesOf(Task task) noexcept;

} // namespace chiron::psychophysics
