// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/row_scan.h"

#include "database/integrity/digested_row.h"

#include <algorithm>

namespace chiron::database {
namespace {
constexpr int kMostBreaks = 4096; // per table; beyond that, the rest is reported as one range
}

RowScan::RowScan(Connection& connection, const DigestedTable& table, VerifyReport& report, VerifySteps& steps)
    : m_connection(connection), m_table(table), m_report(report), m_steps(steps) {
    for (std::size_t i = 0; i < table.laterColumns; ++i) {
        const auto there =
            selectInteger(connection, "SELECT count(*) FROM pragma_table_info(?) WHERE name = ?",
                          {std::string(table.name), std::string(m_table.columns.back())});
        if (there && there->value_or(1) == 0) {
            m_table.columns.pop_back();
        }
    }
}

std::string printable(const Value& value) {
    switch (value.type()) {
    case Value::Type::null:
        return "NULL";
    case Value::Type::integer:
        return std::to_string(value.integer());
    case Value::Type::real:
        return std::to_string(value.real());
    case Value::Type::text:
        return value.bytes();
    case Value::Type::blob:
        return hex(reinterpret_cast<const std::uint8_t*>(value.bytes().data()), value.bytes().size());
    }
    return {};
}

void RowScan::report(const std::string& kind, const std::string& row, const std::string& detail) {
    m_report.findings.push_back({kind, std::string(m_table.name), row, detail});
}

std::string RowScan::sql() const {
    std::string text = "SELECT rowid, " + rawSelectList(m_table) + ", digest";
    if (!m_table.hashedColumn.empty()) {
        text += ", CAST(" + std::string(m_table.hashedColumn) + " AS BLOB), " +
                std::string(m_table.hashColumn) + ", " + std::string(m_table.erasedSql);
        const int version = schemaVersionOf(m_connection);
        if (!m_table.erasedWithStudiesSql.empty() && version >= kStudyVersion) {
            text += " OR " + std::string(m_table.erasedWithStudiesSql);
        }
        if (!m_table.erasedWithSittingsSql.empty() && version >= kSittingsVersion) {
            text += " OR " + std::string(m_table.erasedWithSittingsSql);
        }
    }
    return text + " FROM " + std::string(m_table.name) + " NOT INDEXED WHERE rowid > ? ORDER BY rowid";
}

void RowScan::run(const Visitor& visit) {
    std::int64_t after = 0;
    std::int64_t broken = 0; // first row of the current unreadable range; 0: none
    const auto closeRange = [&](std::int64_t last) {
        if (broken != 0) {
            report("unreadable", "rowid " + std::to_string(broken) + ".." + std::to_string(last), m_words);
            broken = 0;
        }
    };
    for (int breaks = 0; breaks <= kMostBreaks; ++breaks) {
        std::int64_t last = after;
        const Pass pass = readFrom(after, last, visit);
        if (last != after || pass == Pass::finished) {
            closeRange(after);
        }
        if (pass == Pass::finished) {
            return;
        }
        broken = broken != 0 ? broken : last + 1;
        after = last + 1;
    }
    report("unreadable", "rowid " + std::to_string(broken) + "..", m_words);
}

RowScan::Pass RowScan::readFrom(std::int64_t after, std::int64_t& last, const Visitor& visit) {
    auto query = Query::run(m_connection, sql(), {after});
    if (!query) {
        m_words = query.error().message;
        return Pass::broken;
    }
    while (true) {
        if (!m_steps.goOn()) {
            return Pass::finished;
        }
        const auto row = query->next();
        if (!row) {
            m_words = row.error().message;
            return Pass::broken;
        }
        if (!*row) {
            return Pass::finished;
        }
        // A damaged tree may be out of order, and must not lead to an endless loop.
        if (query->integer(0) <= last) {
            m_words = "rows out of order";
            return Pass::broken;
        }
        last = query->integer(0);
        checkRow(*query, visit);
        m_steps.add();
    }
}

void RowScan::checkRow(const Query& query, const Visitor& visit) {
    ++m_report.rowsChecked;
    const std::vector<Value> values = rawValues(query, m_table, 1);
    const int digestColumn = 1 + static_cast<int>(2 * m_table.columns.size());
    if (query.blob(digestColumn) != toBlob(rowDigest(m_table.name, values))) {
        report("digest", keyOf(values),
               "the row does not fit its digest (rowid " + std::to_string(query.integer(0)) + ")");
    }
    if (!m_table.hashedColumn.empty() && !query.isNull(digestColumn + 2)) {
        const Blob bytes = query.blob(digestColumn + 1);
        const bool fits = toBlob(bytesDigest(bytes)) == query.blob(digestColumn + 2);
        const bool erased = bytes.empty() && query.integer(digestColumn + 3) == 1;
        if (!fits && !erased) {
            report("payload", keyOf(values), std::string(m_table.hashedColumn) + " does not fit its digest");
        }
    }
    if (visit) {
        visit(values);
    }
}

std::string RowScan::keyOf(const std::vector<Value>& values) const {
    std::string text;
    for (const std::string_view key : m_table.key) {
        const auto found = std::find(m_table.columns.begin(), m_table.columns.end(), key);
        const auto index = static_cast<std::size_t>(found - m_table.columns.begin());
        text += (text.empty() ? "" : " ") + std::string(key) + "=" + printable(values[index]);
    }
    return text;
}

} // namespace chiron::database
