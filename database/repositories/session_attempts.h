// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::database {

/// SQL that is 1 if the session to which the statement refers as `table` was recorded for a study, whatever
/// its exercise; else 0. In versions before 5 a study session is recognised only by its trials, so one that
/// was left before its first trial counts as training.
std::string isOfStudySql(const std::string& table);

/// SQL, for a statement in which the table of sessions is called `s`: the number of the session among the
/// attempts of its person at its exercise and level, from 1 in the order of session numbers. It is 0 for
/// sessions that are no attempts: a familiarisation, a scripted operator (except on a demonstration site,
/// where scripts represent people), and a session of a study. A voided session keeps its number, and so do
/// those after it.
std::string attemptNumberSql();

/// SQL, as above: 1 if somebody other than its person should look at the session, else 0. For each person,
/// exercise and level this is the latest attempt that has ended, was not voided and is not archived, as long
/// as nobody else has commented on it.
std::string awaitsReviewSql();

} // namespace chiron::database
