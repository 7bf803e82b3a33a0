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
    std::string password; ///< empty: one is to be made
};

enum class RosterFault : std::uint8_t {
    excelFile, ///< a spreadsheet's own file: to be saved as CSV first
    openDocumentFile,
    oldExcelFile,
    pdfFile,
    archiveFile,
    notText,      ///< control characters in this line
    notReadable,  ///< bytes in this line that none of the encodings has
    notClosed,    ///< a quotation mark; nothing after it could be read
    tooManyLines, ///< value: the most
    nobody,       ///< no header line, or nobody under it
    noHeadings,   ///< no heading of the first line is known; value: the first one
    columnTwice,  ///< two columns hold the same; value: the second one's title
    columnMissing, ///< value: what none holds, "login name" or "role"
    fieldCount, ///< a value beyond the headings; other: how many these are; value: how many fields there are
    roles,
    name,
    displayName,
    password,  ///< the value stays secret
    nameTwice, ///< other: line of the first
};

/// One thing that is wrong in a list of people.
struct RosterProblem {
    int line = 0; ///< in the file, from 1
    RosterFault fault = RosterFault::name;
    std::string value; ///< as found; never a password
    int other = 0;
    std::string words;    ///< place, value and what was expected, for programs that print it
    std::string column{}; ///< its heading in the file; empty where the whole line is meant
};

/// A list of people as read.
struct Roster {
    std::vector<UserCsvRow> rows; ///< also those with problems, as far as they could be read
    std::vector<RosterProblem> problems;
    std::string encoding; ///< that the file was read with: "UTF-8", "UTF-16", "Windows-1252", "Windows-1253"
    char delimiter = ',';
    std::vector<std::string> ignoredColumns; ///< headings of columns that are not imported
    std::vector<std::string> unknownRoles; ///< words that name no role by themselves, each once as first written; "": a cell without any
};

/// Reads the bytes of a list as a spreadsheet saves it (UTF-8, UTF-16, Windows-1252 or -1253; semicolon, comma or tab; "sep=;") and
/// finds everything that is wrong in it; never fails as a whole. Headings may be English, German or Greek, in any order: login name,
/// full name (or given and family name), roles, password; the login name and the
/// roles are needed. `own`: what words stand for that name no role by themselves.
Roster readRoster(const std::string& bytes, const RoleWords& own = {});

/// badInput that names everything wrong (at most 20 things): line, column, value and what was expected.
core::Error rosterError(const std::vector<RosterProblem>& problems);

/// The people of a faultless list. Failure: rosterError.
core::Result<std::vector<UserCsvRow>> parseUserCsv(const std::string& bytes);

} // namespace chiron::database
