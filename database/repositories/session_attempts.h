// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::database {

/// SQL: 1 where the session that the statement calls `table` was recorded for a study, whatever its exercise; else 0. Of versions before 5 a
/// sitting is known by its trials alone: one that was left before its first is taken for training.
std::string isOfStudySql(const std::string& table);

/// SQL, for a statement in which the table of sessions is called `s`: which attempt of its person at its exercise and level the session
/// is, from 1 in the order of session numbers; 0 for what is none: a familiarisation, a script's hand (but on a demonstration site, where
/// scripts stand in for people), a sitting of a study. A voided session keeps its number, and so do those after it.
std::string attemptNumberSql();

/// SQL, as above: 1 where somebody other than its person should look at the session, else 0. Of each person, exercise and level that is the
/// latest attempt that has ended, was not voided and is not archived, as long as nobody else has commented on it.
std::string awaitsReviewSql();

} // namespace chiron::database
