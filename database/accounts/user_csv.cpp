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
constexpr int kMaximumNamedErrors = 20;

// One pass over the text; quotes double inside quotes, line ends may be LF or CRLF.
class CsvReader {
public:
    explicit CsvReader(const std::string& text) : m_text(text) {}
    core::Result<std::vector<Record>> read() {
        for (std::size_t i = 0; i < m_text.size(); ++i) {
            m_line += m_text[i] == '\n' ? 1 : 0;
            m_quoted ? inside(i) : outside(m_text[i]);
            if (m_records.size() > kMaximumRecords) {
                return core::fail(core::ErrorCode::badInput, "more than 10000 lines");
            }
        }
        if (m_quoted) {
            return core::fail(core::ErrorCode::badInput,
                              "line " + std::to_string(m_record.line) + ": a quotation mark is not closed");
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

core::Result<Columns> headerOf(const Record& header) {
    Columns columns;
    for (std::size_t i = 0; i < header.fields.size(); ++i) {
        const std::string& title = header.fields[i];
        std::optional<std::size_t>* column = title == "name"           ? &columns.name
                                             : title == "display_name" ? &columns.displayName
                                             : title == "roles"        ? &columns.roles
                                             : title == "password"     ? &columns.password
                                                                       : nullptr;
        if (column == nullptr || column->has_value()) {
            return core::fail(core::ErrorCode::badInput,
                              "line 1: column \"" + title +
                                  "\" is unknown or given twice; expected name,display_name,roles,password");
        }
        *column = i;
    }
    if (!columns.name || !columns.roles || !columns.password) {
        return core::fail(core::ErrorCode::badInput,
                          "line 1: expected the columns name,display_name,roles,password");
    }
    return columns;
}

class Collector {
public:
    void add(int line, const std::string& column, const std::string& value, const std::string& expectation) {
        if (++m_count <= kMaximumNamedErrors) {
            m_text += (m_text.empty() ? "" : "\n") + ("line " + std::to_string(line)) + ", " + column +
                      (value.empty() ? "" : " \"" + value + "\"") + ": " + expectation;
        }
    }
    bool any() const { return m_count > 0; }
    std::string text() const {
        return m_count > kMaximumNamedErrors
                   ? m_text + "\nand " + std::to_string(m_count - kMaximumNamedErrors) + " more"
                   : m_text;
    }

private:
    int m_count = 0;
    std::string m_text;
};

UserCsvRow rowOf(const Record& record, const Columns& columns, Collector& errors) {
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
        errors.add(row.line, "roles", record.fields[*columns.roles],
                   "expected trainee, trainer, researcher or admin, separated by ;");
    }
    if (const auto good = checkName(row.name); !good) {
        errors.add(row.line, "name", row.name, good.error().message);
    }
    if (const auto good = checkText("display name", row.displayName, 200); !good) {
        errors.add(row.line, "display_name", "", good.error().message);
    }
    if (const auto good = checkPassword(row.name, row.password); !good) {
        errors.add(row.line, "password", "", good.error().message); // the value stays secret
    }
    return row;
}

} // namespace

core::Result<std::vector<UserCsvRow>> parseUserCsv(const std::string& text) {
    const std::string body = text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text;
    auto records = CsvReader(body).read();
    if (!records) {
        return tl::unexpected(records.error());
    }
    if (records->size() < 2) {
        return core::fail(core::ErrorCode::badInput, "expected a header line and at least one person");
    }
    const auto columns = headerOf(records->front());
    if (!columns) {
        return tl::unexpected(columns.error());
    }
    Collector errors;
    std::vector<UserCsvRow> rows;
    std::map<std::string, int> lineOfName;
    for (std::size_t i = 1; i < records->size(); ++i) {
        const Record& record = (*records)[i];
        if (record.fields.size() != records->front().fields.size()) {
            errors.add(record.line, "fields", std::to_string(record.fields.size()),
                       "expected " + std::to_string(records->front().fields.size()));
            continue;
        }
        rows.push_back(rowOf(record, *columns, errors));
        const auto [other, isNew] = lineOfName.emplace(nameKey(rows.back().name), record.line);
        if (!isNew) {
            errors.add(record.line, "name", rows.back().name,
                       "given already in line " + std::to_string(other->second));
        }
    }
    if (errors.any()) {
        return core::fail(core::ErrorCode::badInput, errors.text());
    }
    return rows;
}

} // namespace chiron::database
