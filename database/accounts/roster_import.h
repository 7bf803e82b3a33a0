// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "database/accounts/user_csv.h"

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::database {

/// What an import does with people of the list who have an account already. Their login name and password stay in either case.
enum class RosterExisting : std::uint8_t {
    skip,
    update ///< full name and roles become those of the list, where it gives them; a full name that somebody had before is not given back
};

/// What becomes of one line of the list.
struct RosterStep {
    enum class Kind : std::uint8_t {
        add,
        skip,   ///< has an account already
        update, ///< and becomes what the list says
        same    ///< and is that already
    };
    int line = 0;
    Kind kind = Kind::add;
    std::string name; ///< as the site has it where the person exists
    std::string displayName; ///< afterwards
    RoleSet roles;
    bool makesPassword = false;    ///< none is given
    PersonId person = 0;           ///< who exists
    std::string displayNameBefore; ///< of them
    RoleSet rolesBefore;
    std::string earlierName{}; ///< as the list has it, where `name` is what this person is called today
    std::string earlierDisplayName{}; ///< as the list has it, where an update leaves the one of today
    enum class Doubt : std::uint8_t {
        none,
        nameOfAnother, ///< `other` had this login name before; whoever has it today is meant
        severalHadIt,  ///< nobody has it today, and several had it before: nobody is changed
        sameAsLine     ///< `otherLine` is the same person under another of their names: that line counts
    };
    Doubt doubt = Doubt::none;
    std::string other{}; ///< their login name of today
    int otherLine = 0;
};

/// What an import would do.
struct RosterPlan {
    Roster roster; ///< as read, without passwords; with problems nothing can be done
    std::vector<RosterStep> steps;
    int count(RosterStep::Kind kind) const;
};

/// Who was added; a password that was made is here and nowhere else.
struct ImportedPerson {
    PersonId id = 0;
    std::string name;
    std::string displayName;
    std::string madePassword; ///< empty where the list gave one
};

struct RosterOutcome {
    std::vector<ImportedPerson> added;
    int updated = 0;
    int skipped = 0; ///< with those that were so already
    std::vector<std::string> ignoredColumns;
    std::vector<RosterStep> told; ///< the lines that have an earlier login name or full name, or leave a doubt about who is meant
};

/// Who is there, and what they were called before.
struct KnownPeople {
    std::vector<Person> people;
    std::vector<EarlierLogin> earlier; ///< latest first
};

/// One step for each line of the list, by who is there. Somebody whom the list calls by an earlier login name is there, too; a name that
/// somebody has today means that person.
std::vector<RosterStep> planRoster(const Roster& roster, const KnownPeople& known, RosterExisting existing);

} // namespace chiron::database
