// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// What a participant is asked. The token is what files hold.
enum class Task : std::uint8_t {
    rank3,         ///< "rank3": three objects (0, D, 2D above the reference), ordered by the participant (P2)
    twoAfc,        ///< "2afc": which of two is more
    threeAfc,      ///< "3afc": which of three is more; two are the reference
    oddity,        ///< "oddity": which of three is the odd one (triangle)
    sameDifferent, ///< "same_different": two objects, same or different
    yesNo,         ///< "yes_no": one object, more than the reference (explored before) or not
    adjustment,    ///< "adjustment": make the comparison equal to the reference
    magnitude,     ///< "magnitude": give each object a number
    rank3Ties,     ///< "rank3_ties": as rank3, where neighbours may be called equal
};
inline constexpr int kTasks = 9;
std::string_view token(Task task) noexcept;
std::optional<Task> taskFromToken(std::string_view word) noexcept;

/// What a participant explores: how often the difference D is added at each place, from left to right: 0 the reference, 1 D, 2 twice D.
using Places = std::vector<int>;

/// All arrangements of a task, in the fixed order that presentation words count in (at most 16):
/// rank3, rank3_ties: the six orders of {0,1,2}, lexicographic; 2afc: {0,1}, {1,0}; 3afc: {1,0,0}, {0,1,0}, {0,0,1};
/// oddity: {1,0,0}, {0,1,0}, {0,0,1}, {0,1,1}, {1,0,1}, {1,1,0}; same_different: {0,0}, {1,1}, {0,1}, {1,0};
/// yes_no: {0}, {1}; adjustment: {0,1} (the left one is the reference and stays); magnitude: {1}.
const std::vector<Places>& arrangements(Task task);

/// Whether three objects are put in order, with ties or without.
constexpr bool ranksThree(Task task) noexcept { return task == Task::rank3 || task == Task::rank3Ties; }

/// What can be said of three objects put in order: the rank of each from 0 (least), equal ones alike, no rank left out. The six orders of
/// rank3 first, as arrangements(rank3); then {0,0,1}, {0,1,0}, {1,0,0}, {0,1,1}, {1,0,1}, {1,1,0} and {0,0,0}.
inline constexpr int kStrictRankings = 6;
inline constexpr int kRankings = 13;
using Ranking = std::array<std::int8_t, 3>;
const std::array<Ranking, kRankings>& rankings() noexcept;
/// Which of them; -1: none of them.
int rankingOf(const Ranking& ranks) noexcept;

/// What a participant can answer, as `answer` commands and stored trials count it: rank3 the first six, rank3_ties all of rankings(): the rank
/// said at each place (of rank3: "places hold these multiples"); 2afc, 3afc, oddity the place from 0; same_different 0 same, 1 different; yes_no 0 no, 1 yes;
/// adjustment 0 (set); magnitude 0 (the number is the trial's `value`).
int answers(Task task) noexcept;

/// The answer that is right for an arrangement; -1 where no answer is right or wrong (adjustment, magnitude).
int correctAnswer(Task task, int arrangement) noexcept;

/// An answer as the outcome a procedure knows, independent of where things lay: rank3, rank3_ties → which of rankings() was said of the true
/// 0, 1, 2 (0: all correct); others 1 right, 0 wrong. −1: an arrangement or answer that the task does not have.
int outcomeOf(Task task, int arrangement, int answer) noexcept;
/// How many outcomes there are: 6, 13 or 2.
int outcomes(Task task) noexcept;

/// How many objects lie side by side.
int placesOf(Task task) noexcept;

} // namespace chiron::psychophysics
