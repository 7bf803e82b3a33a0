// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/user_csv.h"

#include "database/accounts/account_rules.h"
#include "database/accounts/csv_records.h"
#include "database/accounts/roster_words.h"
#include "database/accounts/table_text.h"

#include <QString>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

namespace chiron::database {
namespace {

constexpr std::size_t kMaximumRecords = 10000;
constexpr std::size_t kMaximumNamedErrors = 20;
constexpr std::array kDelimiters{',', ';', '\t'};

void add(Roster& roster, RosterProblem problem, const std::string& expectation) {
    problem.words = "line " + std::to_string(problem.line);
    problem.words += problem.column.empty() ? "" : ", " + problem.column;
    problem.words += problem.value.empty() ? "" : " \"" + problem.value + "\"";
    problem.words += ": " + expectation;
    roster.problems.push_back(std::move(problem));
}

void addTextProblem(Roster& roster, const TextProblem& problem) {
    using Kind = TextProblem::Kind;
    const auto add = [&](RosterFault fault, const std::string& words) {
        roster.problems.push_back({problem.line, fault, "", 0, words});
    };
    const std::string line = "line " + std::to_string(problem.line) + ": ";
    const std::string saveAs = "; expected a CSV file: open it in the spreadsheet program and save it as CSV";
    switch (problem.kind) {
    case Kind::excel:
        return add(RosterFault::excelFile, "this is an Excel workbook (.xlsx)" + saveAs);
    case Kind::openDocument:
        return add(RosterFault::openDocumentFile, "this is an OpenDocument spreadsheet (.ods)" + saveAs);
    case Kind::oldExcel:
        return add(RosterFault::oldExcelFile, "this is an old Excel workbook (.xls)" + saveAs);
    case Kind::pdf:
        return add(
            RosterFault::pdfFile,
            "this is a PDF; expected a CSV file: save the list as CSV in the program that it comes from");
    case Kind::archive:
        return add(RosterFault::archiveFile, "this is a ZIP archive; expected the CSV file itself");
    case Kind::binary:
        return add(RosterFault::notText, line + "control characters; expected a text file (CSV)");
    case Kind::damaged:
        return add(RosterFault::notReadable, line + "bytes that are no text in UTF-8, UTF-16, Windows-1252 "
                                                    "or Windows-1253; save the list as CSV once more");
    }
}

// Returns the delimiter with which most headings are known; delimiters inside quotes do not count.
char delimiterOf(const std::string& text, int firstLine) {
    char best = kDelimiters.front();
    std::pair<int, std::size_t> most{-1, 0};
    for (const char delimiter : kDelimiters) {
        const CsvRecords first = readCsvRecords(text, delimiter, 0, firstLine);
        if (first.records.empty()) {
            continue;
        }
        const std::vector<std::string>& headings = first.records.front().fields;
        const std::pair<int, std::size_t> now{knownHeadings(headings), headings.size()};
        if (now > most) {
            most = now;
            best = delimiter;
        }
    }
    return best;
}

/// Positions of the columns; npos: absent.
struct Columns {
    std::map<RosterColumn, std::size_t> places;
    std::vector<std::string> headings;
    std::size_t count = 0; ///< without columns at the end that have no heading

    bool has(RosterColumn column) const { return places.contains(column); }
    std::string heading(RosterColumn column) const {
        return has(column) ? headings[places.at(column)] : std::string();
    }
};

std::string trimmed(const std::string& text) {
    return QString::fromStdString(text).trimmed().toStdString();
}

// Line breaks and double spaces within a cell are only layout.
std::string simplified(const std::string& text) {
    return QString::fromStdString(text).simplified().toStdString();
}

std::optional<Columns> columnsOf(const CsvRecord& header, Roster& roster) {
    Columns columns;
    const std::vector<RosterColumn> kinds = rosterColumns(header.fields);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const std::string title = simplified(header.fields[i]);
        columns.headings.push_back(title);
        columns.count = kinds[i] == RosterColumn::empty ? columns.count : i + 1;
        if (kinds[i] == RosterColumn::empty) {
            continue;
        }
        if (kinds[i] == RosterColumn::unknown || kinds[i] == RosterColumn::group) {
            roster.ignoredColumns.push_back(title);
        } else if (!columns.places.emplace(kinds[i], i).second) {
            add(roster, {header.line, RosterFault::columnTwice, title, 0, "", "column"},
                "another column holds the same; expected it once");
        }
    }
    if (knownHeadings(header.fields) == 0) {
        add(roster, {header.line, RosterFault::noHeadings, columns.headings.front(), 0, "", ""},
            "no heading is known; expected a first line with headings such as login name, full name, role, "
            "password");
        return std::nullopt;
    }
    if (!columns.has(RosterColumn::loginName)) {
        add(roster, {header.line, RosterFault::columnMissing, "login name", 0, "", ""},
            "no column holds it; expected a heading such as login name, Anmeldename or όνομα χρήστη");
    }
    if (!columns.has(RosterColumn::roles)) {
        add(roster, {header.line, RosterFault::columnMissing, "role", 0, "", ""},
            "no column holds it; expected a heading such as role, Rolle or ρόλος");
    }
    return roster.problems.empty() ? std::optional(columns) : std::nullopt;
}

class RowReader {
public:
    RowReader(const Columns& columns, Roster& roster, const RoleWords& own)
        : m_columns(columns), m_roster(roster), m_own(own) {}

    void read(const CsvRecord& record) {
        m_record = &record;
        if (holdsMore()) {
            return;
        }
        UserCsvRow row;
        row.line = record.line;
        row.name = trimmed(cell(RosterColumn::loginName));
        row.displayName = displayName();
        row.password =
            trimmed(cell(RosterColumn::password)).empty() ? std::string() : cell(RosterColumn::password);
        row.roles = roles();
        check(row);
        m_roster.rows.push_back(std::move(row));
    }

private:
    // A spreadsheet omits empty cells at the end of a line, so a line may be short but never long.
    bool holdsMore() {
        std::size_t filled = 0;
        for (std::size_t i = 0; i < m_record->fields.size(); ++i) {
            filled = trimmed(m_record->fields[i]).empty() ? filled : i + 1;
        }
        const bool untitled = filled <= m_columns.count && [&] {
            for (std::size_t i = 0; i < filled; ++i) {
                if (m_columns.headings[i].empty() && !trimmed(m_record->fields[i]).empty()) {
                    return true;
                }
            }
            return false;
        }();
        if (filled > m_columns.count || untitled) {
            add(m_roster,
                {m_record->line, RosterFault::fieldCount, std::to_string(filled),
                 static_cast<int>(m_columns.count), "", "fields"},
                untitled ? "a value stands in a column without a heading"
                         : "expected " + std::to_string(m_columns.count) +
                               "; quote a value that holds the delimiter");
        }
        return filled > m_columns.count || untitled;
    }
    std::string cell(RosterColumn column) const {
        const auto place = m_columns.places.find(column);
        return place == m_columns.places.end() || place->second >= m_record->fields.size()
                   ? std::string()
                   : m_record->fields[place->second];
    }
    std::string displayName() const {
        const std::string whole = simplified(cell(RosterColumn::displayName));
        return whole.empty()
                   ? simplified(cell(RosterColumn::givenName) + " " + cell(RosterColumn::familyName))
                   : whole;
    }
    RoleSet roles() {
        const std::string words = cell(RosterColumn::roles);
        noteUnknown(words);
        const auto set = rolesOfCell(words, m_own);
        if (!set) {
            add(m_roster,
                {m_record->line, RosterFault::roles, simplified(words), 0, "",
                 m_columns.heading(RosterColumn::roles)},
                "expected trainee, trainer, researcher or admin, separated by ;");
        }
        return set.value_or(RoleSet{});
    }
    void noteUnknown(const std::string& words) {
        for (const std::string& word : unknownRoleWords(words)) {
            if (m_unknown.insert(QString::fromStdString(word).toCaseFolded()).second) {
                m_roster.unknownRoles.push_back(word);
            }
        }
    }
    void check(const UserCsvRow& row) {
        if (const auto good = checkName(row.name); !good) {
            add(m_roster,
                {row.line, RosterFault::name, row.name, 0, "", m_columns.heading(RosterColumn::loginName)},
                good.error().message);
        }
        if (const auto good = checkText("display name", row.displayName, kMaximumDisplayNameCharacters);
            !good) {
            const RosterColumn column = m_columns.has(RosterColumn::displayName)  ? RosterColumn::displayName
                                        : m_columns.has(RosterColumn::familyName) ? RosterColumn::familyName
                                                                                  : RosterColumn::givenName;
            add(m_roster, {row.line, RosterFault::displayName, "", 0, "", m_columns.heading(column)},
                good.error().message);
        }
        if (const auto good = checkPassword(row.name, row.password); !row.password.empty() && !good) {
            add(m_roster,
                {row.line, RosterFault::password, "", 0, "", m_columns.heading(RosterColumn::password)},
                good.error().message);
        }
        const auto [other, isNew] = m_lineOfName.emplace(nameKey(row.name), row.line);
        if (!isNew && !row.name.empty()) {
            add(m_roster,
                {row.line, RosterFault::nameTwice, row.name, other->second, "",
                 m_columns.heading(RosterColumn::loginName)},
                "given already in line " + std::to_string(other->second));
        }
    }

    const Columns& m_columns;
    Roster& m_roster;
    const RoleWords& m_own;
    std::set<QString> m_unknown; ///< words that were reported already
    const CsvRecord* m_record = nullptr;
    std::map<std::string, int> m_lineOfName;
};

std::vector<CsvRecord> recordsOf(std::string text, Roster& roster) {
    const auto said = takeSeparatorLine(text);
    const int firstLine = said ? 2 : 1;
    roster.delimiter = said.value_or(delimiterOf(text, firstLine));
    CsvRecords read = readCsvRecords(text, roster.delimiter, kMaximumRecords, firstLine);
    if (read.tooMany) {
        const std::string most = std::to_string(kMaximumRecords);
        roster.problems.push_back(
            {read.records.back().line, RosterFault::tooManyLines, most, 0, "more than " + most + " lines"});
    } else if (read.notClosed) {
        roster.problems.push_back(
            {*read.notClosed, RosterFault::notClosed, "", 0,
             "line " + std::to_string(*read.notClosed) + ": a quotation mark is not closed"});
    } else if (read.records.size() < 2) {
        roster.problems.push_back(
            {firstLine, RosterFault::nobody, "", 0, "expected a header line and at least one person"});
    }
    return std::move(read.records);
}

} // namespace

Roster readRoster(const std::string& bytes, const RoleWords& own) {
    Roster roster;
    auto text = readTableText(bytes);
    if (!text) {
        addTextProblem(roster, text.error());
        return roster;
    }
    roster.encoding = text->encoding;
    const auto records = recordsOf(std::move(text->text), roster);
    const auto columns = roster.problems.empty() ? columnsOf(records.front(), roster) : std::nullopt;
    if (!columns) {
        return roster;
    }
    RowReader rows(*columns, roster, own);
    for (std::size_t i = 1; i < records.size(); ++i) {
        rows.read(records[i]);
    }
    return roster;
}

core::Error rosterError(const std::vector<RosterProblem>& problems) {
    std::string words;
    const std::size_t named = std::min(problems.size(), kMaximumNamedErrors);
    for (std::size_t i = 0; i < named; ++i) {
        words += (words.empty() ? "" : "\n") + problems[i].words;
    }
    if (named < problems.size()) {
        words += "\nand " + std::to_string(problems.size() - named) + " more";
    }
    return {core::ErrorCode::badInput, words};
}

core::Result<std::vector<UserCsvRow>> parseUserCsv(const std::string& bytes) {
    Roster roster = readRoster(bytes);
    if (roster.problems.empty()) {
        return std::move(roster.rows);
    }
    return tl::unexpected(rosterError(roster.problems));
}

} // namespace chiron::database
