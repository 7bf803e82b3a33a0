// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/query.h"
#include "database/repositories/study_types.h"

#include <string>
#include <vector>

// Rows of studies as values. The caller checks beforehand who may read them.
namespace chiron::database {

/// Returns all rows of a query, each converted to a value.
template <class T, class Make>
core::Result<std::vector<T>> rowsOf(Connection& connection, const std::string& sql,
                                    const std::vector<Value>& values, Make make) {
    auto query = Query::run(connection, sql, values);
    CHIRON_TRY(query);
    std::vector<T> rows;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        rows.push_back(make(*query));
    }
    CHIRON_TRY(row);
    return rows;
}

/// Returns participants (alias p of study_participant), by number.
core::Result<std::vector<Participant>> participantRows(Connection& connection, const std::string& where,
                                                       const std::vector<Value>& values);
/// Returns codes with their conditions, in the design's order.
core::Result<std::vector<SealedCondition>> sealedConditionRows(Connection& connection, StudyNumber study);
core::Result<std::vector<StudyRun>> runRows(Connection& connection, ParticipantNumber participant);
core::Result<std::vector<StudyTrial>> studyTrialRows(Connection& connection, StudyRunNumber run);
/// Returns answers (alias a) of participants (alias p), by participant, in the order in which they were
/// given.
core::Result<std::vector<QuestionnaireAnswer>> answerRows(Connection& connection, const std::string& where,
                                                          std::int64_t number);

} // namespace chiron::database
