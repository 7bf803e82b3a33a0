// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/role.h"

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

/// Reads RFC 4180 text with the header name,display_name,roles,password (any order; display_name may be
/// missing). Roles are separated by ';' or, quoted, by ','. Failure: badInput that names every wrong row (at
/// most 20): line, column, value and what was expected; also names given twice.
core::Result<std::vector<UserCsvRow>> parseUserCsv(const std::string& text);

} // namespace chiron::database
