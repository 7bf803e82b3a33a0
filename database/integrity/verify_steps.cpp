// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/verify_steps.h"

#include "database/integrity/digested_row.h"
#include "database/query.h"

#include <algorithm>

namespace chiron::database {

void VerifySteps::plan(Connection& connection, bool withScores) {
    if (!m_watch) {
        return;
    }
    const int version = schemaVersionOf(connection);
    for (const DigestedTable& table : digestedTables()) {
        if (table.since > version)
            continue;
        const auto rows = selectInteger(connection, "SELECT count(*) FROM " + std::string(table.name));
        if (!rows)
            m_report.findings.push_back({"file", std::string(table.name), "", rows.error().message});
        m_of += rows ? static_cast<std::uint64_t>(std::max<std::int64_t>(rows->value_or(0), 0)) : 0;
    }
    const auto scored = selectInteger(connection, "SELECT count(DISTINCT session_id) FROM score_set");
    if (!scored)
        m_report.findings.push_back({"file", "score_set", "", scored.error().message});
    if (withScores && scored) {
        m_of += kStepsOfSession * static_cast<std::uint64_t>(std::max<std::int64_t>(scored->value_or(0), 0));
    }
    m_report.cancelled = !m_watch(0, m_of);
}

void VerifySteps::add(std::uint64_t steps) {
    m_done += steps;
    if (!m_watch || m_done < m_askedAt + kAskEvery) {
        return;
    }
    m_askedAt = m_done;
    m_report.cancelled = m_report.cancelled || !m_watch(std::min(m_done, m_of), m_of);
}

} // namespace chiron::database
