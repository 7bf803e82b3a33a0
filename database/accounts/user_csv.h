// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
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
    std::string password;
};

enum class RosterFault : std::uint8_t {
    notClosed,     ///< a quotation mark; nothing after it could be read
    tooManyLines,  ///< value: the most
    nobody,        ///< no header line, or nobody under it
    unknownColumn, ///< or given twice; value: its title
    columnMissing,
    fieldCount, ///< other: how many were expected; value: how many there are
    roles,
    name,
    displayName,
    password,  ///< the value stays secret
    nameTwice, ///< other: line of the first
    nameTaken, ///< somebody has it already (AccountService::previewCsv)
};

/// One thing that is wrong in a list of people.
struct RosterProblem {
    int line = 0; ///< in the file, from 1
    RosterFault fault = RosterFault::name;
    std::string value; ///< as found; never a password
    int other = 0;
    std::string words; ///< place, value and what was expected, for programs that print it
};

/// A list of people as read.
struct Roster {
    std::vector<UserCsvRow> rows; ///< also those with problems, as far as they could be read
    std::vector<RosterProblem> problems;
};

/// Reads the list and everything that is wrong in it; never fails as a whole.
Roster readRoster(const std::string& text);

/// Reads RFC 4180 text with the header name,display_name,roles,password (any order; display_name may be
/// missing). Roles are separated by ';' or, quoted, by ','. Failure: badInput that names every wrong row (at
/// most 20): line, column, value and what was expected; also names given twice.
core::Result<std::vector<UserCsvRow>> parseUserCsv(const std::string& text);

} // namespace chiron::database
