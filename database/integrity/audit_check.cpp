// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/audit_check.h"

#include "database/query.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace chiron::database {
namespace {

using Target = std::pair<std::string, std::int64_t>;

class ChainCheck {
public:
    ChainCheck(const SiteKey& key, Blob genesis, const std::optional<AuditHead>& head, VerifyReport& report)
        : m_key(key), m_previous(std::move(genesis)), m_head(head), m_report(report) {}

    void link(const AuditLink& link) {
        const std::string row = "sequence=" + std::to_string(link.sequence);
        ++m_report.rowsChecked;
        if (link.sequence != m_sequence + 1) {
            report(row, "gap or reordering: expected sequence " + std::to_string(m_sequence + 1));
        }
        if (link.previous != m_previous) {
            report(row, "does not follow the entry before it (removed, reordered or spliced)");
        }
        if (link.mac != toBlob(auditMac(m_key, link))) {
            report(row, "was changed, or written without this site's key");
        }
        if (m_head && link.sequence == m_head->count) {
            m_headSeen = hex(link.mac) == m_head->hash;
        }
        const QJsonObject detail =
            QJsonDocument::fromJson(QByteArray::fromStdString(link.detailJson)).object();
        if (detail.contains("row")) {
            m_rows[{link.target, link.targetId}] = detail["row"].toString().toStdString();
        }
        m_sequence = link.sequence;
        m_previous = link.mac;
    }
    void finish() {
        if (m_head && m_head->count > 0 && !m_headSeen) {
            report("sequence=" + std::to_string(m_head->count),
                   "cut off: the chain does not contain the head that the site keeps (" +
                       m_head->hash.substr(0, 16) + "...)");
        }
    }
    void report(const std::string& row, const std::string& detail) {
        m_report.findings.push_back({"audit", "audit", row, detail});
    }
    const std::map<Target, std::string>& rows() const { return m_rows; }

private:
    const SiteKey& m_key;
    Blob m_previous;
    std::optional<AuditHead> m_head;
    VerifyReport& m_report;
    std::int64_t m_sequence = 0;
    bool m_headSeen = false;
    std::map<Target, std::string> m_rows;
};

AuditLink linkOf(const Query& row) {
    AuditLink link;
    link.sequence = row.integer(0);
    link.utc = row.text(1);
    link.actorKind = row.text(2);
    link.actor = row.integer(3);
    link.action = row.text(4);
    link.target = row.text(5);
    link.targetId = row.integer(6);
    link.detailJson = row.text(7);
    link.previous = row.blob(8);
    link.mac = row.blob(9);
    return link;
}

/// Tables of which the chain covers every row, with the version of the schema that added them.
struct VouchedTable {
    std::string_view name;
    int since = 1;
};
constexpr std::array<VouchedTable, 14> kVouchedTables{{{"person"},
                                                       {"session"},
                                                       {"score_set"},
                                                       {"session_comment"},
                                                       {"study", 3},
                                                       {"study_participant", 3},
                                                       {"participant_key", 3},
                                                       {"participant_consent", 3},
                                                       {"study_run", 3},
                                                       {"questionnaire_answer", 3},
                                                       {"participant_erasure", 3},
                                                       {"person_name", kNamesVersion},
                                                       {"study_sitting", kSittingsVersion},
                                                       {"session_decision", kDecisionsVersion}}};

// Detects a row that was changed together with its digest by somebody without the key.
void checkVouchedRows(Connection& connection, const std::map<Target, std::string>& rows,
                      VerifyReport& report) {
    for (const auto& [target, expected] : rows) {
        const auto& [table, id] = target;
        if (std::none_of(kVouchedTables.begin(), kVouchedTables.end(),
                         [&](const VouchedTable& t) { return t.name == table; })) {
            continue;
        }
        const auto digest =
            selectText(connection, "SELECT lower(hex(digest)) FROM " + table + " WHERE id = ?", {id});
        const std::string row = "id=" + std::to_string(id);
        if (!digest) {
            report.findings.push_back({"unreadable", table, row, digest.error().message});
        } else if (!*digest) {
            report.findings.push_back(
                {"missing", table, row, "the audit chain knows this row, the table has it no more"});
        } else if (**digest != expected) {
            report.findings.push_back(
                {"audit", table, row, "was changed without an entry in the audit chain"});
        }
    }
}

// Detects a row that somebody without the key inserted together with its digest: each of these tables records
// its rows in the chain when they are made.
void checkUnknownRows(Connection& connection, const std::map<Target, std::string>& rows,
                      VerifyReport& report) {
    const int version = schemaVersionOf(connection);
    for (const VouchedTable& vouched : kVouchedTables) {
        const std::string table(vouched.name);
        if (vouched.since > version) {
            continue;
        }
        auto query = Query::run(connection, "SELECT id FROM " + table + " ORDER BY id");
        auto row = query ? query->next() : tl::unexpected(query.error());
        for (; row && *row; row = query->next()) {
            if (!rows.contains({table, query->integer(0)})) {
                report.findings.push_back({"audit", table, "id=" + std::to_string(query->integer(0)),
                                           "was added without an entry in the audit chain"});
            }
        }
        if (!row) {
            report.findings.push_back({"unreadable", table, "", row.error().message});
        }
    }
}

} // namespace

void checkAudit(Connection& connection, const SiteKey& key, const std::optional<AuditHead>& head,
                VerifyReport& report) {
    const auto identity = databaseIdentity(connection);
    const Blob genesis = toBlob(auditGenesis(key, identity.value_or("")));
    ChainCheck chain(key, genesis, head, report);
    auto query = Query::run(
        connection, "SELECT sequence, utc, actor_kind, actor_id, action, target, target_id, detail_json, "
                    "previous, mac FROM audit ORDER BY sequence");
    if (!query) {
        chain.report("", query.error().message);
        return;
    }
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        chain.link(linkOf(*query));
    }
    chain.finish();
    checkVouchedRows(connection, chain.rows(), report);
    if (row) {
        checkUnknownRows(connection, chain.rows(), report);
    } else {
        report.findings.push_back({"unreadable", "audit", "", row.error().message});
    }
}

} // namespace chiron::database
