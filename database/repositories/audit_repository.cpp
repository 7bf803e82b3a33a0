// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/audit_repository.h"

#include "database/access/authorise.h"
#include "database/query.h"

namespace chiron::database {

core::Result<std::vector<AuditEntry>> AuditRepository::listAudit(int limit) {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::listAudit));
    auto query = Query::run(
        m_connection,
        "SELECT sequence, utc, actor_kind, actor_id, action, target, target_id, detail_json FROM audit "
        "ORDER BY sequence DESC LIMIT ?",
        {std::int64_t{limit > 0 ? limit : -1}});
    CHIRON_TRY(query);
    std::vector<AuditEntry> entries;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        entries.push_back({query->integer(0), query->text(1), query->text(2), query->integer(3),
                           query->text(4), query->text(5), query->integer(6), query->text(7)});
    }
    CHIRON_TRY(row);
    return entries;
}

} // namespace chiron::database
