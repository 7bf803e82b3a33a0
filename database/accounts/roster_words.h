// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/role.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiron::database {

/// The content of a column of a list of people, judged by its heading.
enum class RosterColumn : std::uint8_t {
    loginName,
    displayName,
    givenName,
    familyName,
    /// "name": its meaning depends on the other headings; rosterColumns never returns it.
    someName,
    roles,
    password,
    group,   ///< recognised, but the program has no groups of people yet
    unknown, ///< has a heading that is not known
    empty    ///< has no heading
};

/// Returns the columns of a heading line in any language of the program (translations/words), in any order,
/// case and accentuation.
std::vector<RosterColumn> rosterColumns(const std::vector<std::string>& headings);

/// Returns how many of these headings are known. A line is read with the delimiter that gives the largest
/// number.
int knownHeadings(const std::vector<std::string>& headings);

/// The roles for words of a list that are no role names themselves, in any case and accentuation; "" stands
/// for cells without a word.
using RoleWords = std::map<std::string, Role>;

/// Returns the roles that people wrote in one of these languages, separated by ; , | or line ends.
/// Returns none if a word is no role and `own` does not define it.
std::optional<RoleSet> rolesOfCell(const std::string& cell, const RoleWords& own = {});

/// Returns the words of a cell that are no role names, as written; "" if it has no word.
std::vector<std::string> unknownRoleWords(const std::string& cell);

} // namespace chiron::database
