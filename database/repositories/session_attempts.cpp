// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_attempts.h"

#include "database/actor.h"

namespace chiron::database {
namespace {

// The columns are those of the index session_by_attempt; the conditions on other tables come last.
std::string isAttempt(const std::string& table) {
    return "(" + table + ".familiarisation = 0 AND (" + table + ".operator_name = '' OR " + table +
           ".demonstration = 1) AND " + table + ".person_id <> " + std::to_string(Actor::kSimulatedPerson) +
           " AND NOT " + isOfStudySql(table) + ")";
}

std::string ofTheSameLevel(const std::string& table) {
    return table + ".person_id = s.person_id AND " + table + ".exercise = s.exercise AND " + table +
           ".level = s.level";
}

std::string standsForReview(const std::string& table) {
    return isAttempt(table) + " AND " + table + ".state NOT IN ('running', 'voided') AND " + table +
           ".archived = 0";
}

} // namespace

// Does not use the view recorded_sitting, which would be computed anew for each session.
std::string isOfStudySql(const std::string& table) {
    return "(EXISTS (SELECT 1 FROM study_sitting k WHERE k.id = " + table +
           ".id) OR EXISTS (SELECT 1 FROM study_trial t WHERE t.session_id = " + table + ".id))";
}

std::string attemptNumberSql() {
    return "CASE WHEN " + isAttempt("s") + " THEN (SELECT count(*) FROM session a WHERE " +
           ofTheSameLevel("a") + " AND a.id <= s.id AND " + isAttempt("a") + ") ELSE 0 END";
}

std::string awaitsReviewSql() {
    return "(" + standsForReview("s") +
           " AND NOT EXISTS (SELECT 1 FROM session_comment r WHERE r.session_id = s.id AND r.author_id <> "
           "s.person_id)"
           " AND NOT EXISTS (SELECT 1 FROM session n WHERE " +
           ofTheSameLevel("n") + " AND n.id > s.id AND " + standsForReview("n") + "))";
}

} // namespace chiron::database
