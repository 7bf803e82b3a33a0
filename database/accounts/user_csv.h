// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/roster_words.h"
#include "database/role.h"

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::database {

/// One line of a list of people to be imported.
struct UserCsvRow {
    int line = 0; ///< in the file, from 1
    std::string name;
    std::string displayName;
    RoleSet roles;
    std::string password; ///< empty: a password is to be generated
};

enum class RosterFault : std::uint8_t {
    excelFile, ///< a spreadsheet's own format: it has to be saved as CSV first
    openDocumentFile,
    oldExcelFile,
    pdfFile,
    archiveFile,
    notText,       ///< this line has control characters
    notReadable,   ///< this line has bytes that are invalid in every encoding
    notClosed,     ///< a quotation mark; nothing after it could be read
    tooManyLines,  ///< value: the largest number allowed
    nobody,        ///< no header line, or no people below it
    noHeadings,    ///< no heading of the first line is known; value: the first one
    columnTwice,   ///< two columns have the same content; value: the second one's heading
    columnMissing, ///< value: the content that is missing, "login name" or "role"
    /// A value beyond the headings; other: the number of headings; value: the number of fields.
    fieldCount,
    roles,
    name,
    displayName,
    password,  ///< the value is not reported
    nameTwice, ///< other: line of the first occurrence
};

/// One fault in a list of people.
struct RosterProblem {
    int line = 0; ///< in the file, from 1
    RosterFault fault = RosterFault::name;
    std::string value; ///< as found; never a password
    int other = 0;
    std::string words;    ///< place, value and what was expected, for programs that print it
    std::string column{}; ///< heading of the column in the file; empty if the whole line is meant
};

/// A list of people as it was read.
struct Roster {
    std::vector<UserCsvRow> rows; ///< also rows with problems, as far as they could be read
    std::vector<RosterProblem> problems;
    std::string encoding; ///< encoding of the file: "UTF-8", "UTF-16", "Windows-1252", "Windows-1253"
    char delimiter = ',';
    std::vector<std::string> ignoredColumns; ///< headings of columns that are not imported
    /// Words that are no role names, each once as first written; "": a cell without a word.
    std::vector<std::string> unknownRoles;
};

/// Reads the bytes of a list as a spreadsheet saves it (UTF-8, UTF-16, Windows-1252 or -1253; semicolon,
/// comma or tab; "sep=;") and finds all faults in it; it never fails as a whole. Headings may be in
/// any language of the program, in any order: login name, full name (or given and family name), roles,
/// password. The login name and the roles are required. `own` gives the roles of words that are no role names
/// themselves.
Roster readRoster(const std::string& bytes, const RoleWords& own = {});

/// Returns badInput naming all faults (at most 20): line, column, value and what was expected.
core::Error rosterError(const std::vector<RosterProblem>& problems);

/// Returns the people of a list without faults.
/// Errors: rosterError.
core::Result<std::vector<UserCsvRow>> parseUserCsv(const std::string& bytes);

} // namespace chiron::database
