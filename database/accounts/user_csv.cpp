// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/user_csv.h"

#include "database/accounts/account_rules.h"

#include <algorithm>
#include <map>
#include <optional>

namespace chiron::database {
namespace {

struct Record {
    int line = 1;
    std::vector<std::string> fields;
};

constexpr std::size_t kMaximumRecords = 10000;
constexpr std::size_t kMaximumNamedErrors = 20;

// One pass over the text; quotes double inside quotes, line ends may be LF or CRLF.
class CsvReader {
public:
    explicit CsvReader(const std::string& text) : m_text(text) {}
    std::vector<Record> read(Roster& roster) {
        for (std::size_t i = 0; i < m_text.size(); ++i) {
            m_line += m_text[i] == '\n' ? 1 : 0;
            m_quoted ? inside(i) : outside(m_text[i]);
            if (m_records.size() > kMaximumRecords) {
                roster.problems.push_back({m_line, RosterFault::tooManyLines, std::to_string(kMaximumRecords),
                                           0, "more than " + std::to_string(kMaximumRecords) + " lines"});
                return {};
            }
        }
        if (m_quoted) {
            roster.problems.push_back(
                {m_record.line, RosterFault::notClosed, "", 0,
                 "line " + std::to_string(m_record.line) + ": a quotation mark is not closed"});
            return {};
        }
        if (!m_field.empty() || !m_record.fields.empty()) {
            endRecord();
        }
        return std::move(m_records);
    }

private:
    void inside(std::size_t& i) {
        const bool quote = m_text[i] == '"';
        if (quote && i + 1 < m_text.size() && m_text[i + 1] == '"') {
            m_field.push_back(m_text[++i]);
        } else if (quote) {
            m_quoted = false;
        } else {
            m_field.push_back(m_text[i]);
        }
    }
    void outside(char c) {
        if (c == '"' && m_field.empty()) {
            m_quoted = true;
        } else if (c == ',') {
            endField();
        } else if (c == '\n') {
            endRecord();
        } else if (c != '\r') {
            m_field.push_back(c);
        }
    }
    void endField() {
        m_record.fields.push_back(std::move(m_field));
        m_field.clear();
    }
    void endRecord() {
        endField();
        if (m_record.fields.size() > 1 || !m_record.fields.front().empty()) {
            m_records.push_back(std::move(m_record));
        }
        m_record = Record{m_line, {}};
    }

    const std::string& m_text;
    std::vector<Record> m_records;
    Record m_record;
    std::string m_field;
    bool m_quoted = false;
    int m_line = 1;
};

struct Columns {
    std::optional<std::size_t> name, displayName, roles, password;
};

std::optional<Columns> headerOf(const Record& header, Roster& roster) {
    Columns columns;
    for (std::size_t i = 0; i < header.fields.size(); ++i) {
        const std::string& title = header.fields[i];
        std::optional<std::size_t>* column = title == "name"           ? &columns.name
                                             : title == "display_name" ? &columns.displayName
                                             : title == "roles"        ? &columns.roles
                                             : title == "password"     ? &columns.password
                                                                       : nullptr;
        if (column == nullptr || column->has_value()) {
            roster.problems.push_back(
                {1, RosterFault::unknownColumn, title, 0,
                 "line 1: column \"" + title +
                     "\" is unknown or given twice; expected name,display_name,roles,password"});
            return std::nullopt;
        }
        *column = i;
    }
    if (!columns.name || !columns.roles || !columns.password) {
        roster.problems.push_back({1, RosterFault::columnMissing, "", 0,
                                   "line 1: expected the columns name,display_name,roles,password"});
        return std::nullopt;
    }
    return columns;
}

void add(Roster& roster, int line, RosterFault fault, const std::string& column, const std::string& value,
         const std::string& expectation, int other = 0) {
    roster.problems.push_back({line, fault, value, other,
                               "line " + std::to_string(line) + ", " + column +
                                   (value.empty() ? "" : " \"" + value + "\"") + ": " + expectation});
}

UserCsvRow rowOf(const Record& record, const Columns& columns, Roster& roster) {
    UserCsvRow row;
    row.line = record.line;
    row.name = record.fields[*columns.name];
    row.displayName = columns.displayName ? record.fields[*columns.displayName] : "";
    row.password = record.fields[*columns.password];
    std::string roles = record.fields[*columns.roles];
    std::replace(roles.begin(), roles.end(), ';', ',');
    if (const auto set = rolesFromList(roles)) {
        row.roles = *set;
    } else {
        add(roster, row.line, RosterFault::roles, "roles", record.fields[*columns.roles],
            "expected trainee, trainer, researcher or admin, separated by ;");
    }
    if (const auto good = checkName(row.name); !good) {
        add(roster, row.line, RosterFault::name, "name", row.name, good.error().message);
    }
    if (const auto good = checkText("display name", row.displayName, 200); !good) {
        add(roster, row.line, RosterFault::displayName, "display_name", "", good.error().message);
    }
    if (const auto good = checkPassword(row.name, row.password); !good) {
        add(roster, row.line, RosterFault::password, "password", "", good.error().message);
    }
    return row;
}

} // namespace

Roster readRoster(const std::string& text) {
    Roster roster;
    const std::string body = text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text;
    const auto records = CsvReader(body).read(roster);
    if (!roster.problems.empty()) {
        return roster;
    }
    if (records.size() < 2) {
        roster.problems.push_back(
            {1, RosterFault::nobody, "", 0, "expected a header line and at least one person"});
        return roster;
    }
    const auto columns = headerOf(records.front(), roster);
    if (!columns) {
        return roster;
    }
    const int expected = static_cast<int>(records.front().fields.size());
    std::map<std::string, int> lineOfName;
    for (std::size_t i = 1; i < records.size(); ++i) {
        const Record& record = records[i];
        if (static_cast<int>(record.fields.size()) != expected) {
            add(roster, record.line, RosterFault::fieldCount, "fields", std::to_string(record.fields.size()),
                "expected " + std::to_string(expected), expected);
            continue;
        }
        roster.rows.push_back(rowOf(record, *columns, roster));
        const UserCsvRow& row = roster.rows.back();
        const auto [other, isNew] = lineOfName.emplace(nameKey(row.name), record.line);
        if (!isNew) {
            add(roster, record.line, RosterFault::nameTwice, "name", row.name,
                "given already in line " + std::to_string(other->second), other->second);
        }
    }
    return roster;
}

core::Result<std::vector<UserCsvRow>> parseUserCsv(const std::string& text) {
    Roster roster = readRoster(text);
    if (roster.problems.empty()) {
        return std::move(roster.rows);
    }
    std::string words;
    const std::size_t named = std::min(roster.problems.size(), kMaximumNamedErrors);
    for (std::size_t i = 0; i < named; ++i) {
        words += (words.empty() ? "" : "\n") + roster.problems[i].words;
    }
    if (named < roster.problems.size()) {
        words += "\nand " + std::to_string(roster.problems.size() - named) + " more";
    }
    return core::fail(core::ErrorCode::badInput, words);
}

} // namespace chiron::database
