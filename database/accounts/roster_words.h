// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/role.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiron::database {

/// What a column of a list of people holds, by its heading.
enum class RosterColumn : std::uint8_t {
    loginName,
    displayName,
    givenName,
    familyName,
    someName, ///< "name": what it means depends on the other headings; never the outcome of rosterColumns
    roles,
    password,
    group,   ///< recognised; the program has no groups of people yet
    unknown, ///< has a heading that is none of these
    empty    ///< has no heading
};

/// The columns of a heading line in English, German or Greek, in any order, case and accentuation.
std::vector<RosterColumn> rosterColumns(const std::vector<std::string>& headings);

/// How many of these headings are known: the line is read with the delimiter that makes most of it known.
int knownHeadings(const std::vector<std::string>& headings);

/// What words of a list stand for that name no role by themselves, in any case and accentuation; "": cells without a word.
using RoleWords = std::map<std::string, Role>;

/// Roles as people write them in one of the three languages, separated by ; , | or line ends. Nothing where a word is no role and `own`
/// does not tell what it stands for.
std::optional<RoleSet> rolesOfCell(const std::string& cell, const RoleWords& own = {});

/// The words of a cell that name no role by themselves, as written; "" where it has no word.
std::vector<std::string> unknownRoleWords(const std::string& cell);

} // namespace chiron::database
