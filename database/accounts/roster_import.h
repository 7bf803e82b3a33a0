// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "database/accounts/user_csv.h"

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::database {

/// What an import does with people of the list who already have an account. Their login name and password
/// never change.
enum class RosterExisting : std::uint8_t {
    skip,
    /// Full name and roles become those of the list, if it gives them. An earlier full name of the person is
    /// not restored.
    update
};

/// The outcome of one line of the list.
struct RosterStep {
    enum class Kind : std::uint8_t {
        add,
        skip,   ///< has an account already
        update, ///< has an account, which becomes what the list says
        same    ///< has an account that already is what the list says
    };
    int line = 0;
    Kind kind = Kind::add;
    std::string name;        ///< spelled as on the site if the person exists
    std::string displayName; ///< after the import
    RoleSet roles;
    bool makesPassword = false;    ///< a password is generated because none is given
    PersonId person = 0;           ///< existing person
    std::string displayNameBefore; ///< full name of the existing person before the import
    RoleSet rolesBefore;
    /// Login name as in the list, if it is an earlier name and `name` is the person's current one.
    std::string earlierName{};
    /// Full name as in the list, if it is an earlier one and an update keeps the current one.
    std::string earlierDisplayName{};
    enum class Doubt : std::uint8_t {
        none,
        nameOfAnother, ///< `other` had this login name before; it means the person who has it today
        severalHadIt,  ///< nobody has it today, and several people had it before: nobody is changed
        /// `otherLine` names the same person by another of their names: that line counts.
        sameAsLine
    };
    Doubt doubt = Doubt::none;
    std::string other{}; ///< current login name of the other person
    int otherLine = 0;
};

/// What an import would do.
struct RosterPlan {
    Roster roster; ///< as read, without passwords; if it has problems nothing can be imported
    std::vector<RosterStep> steps;
    int count(RosterStep::Kind kind) const;
};

/// A person who was added. A generated password is kept nowhere else.
struct ImportedPerson {
    PersonId id = 0;
    std::string name;
    std::string displayName;
    std::string madePassword; ///< empty if the list gave one
};

struct RosterOutcome {
    std::vector<ImportedPerson> added;
    int updated = 0;
    int skipped = 0; ///< including those that were already up to date
    std::vector<std::string> ignoredColumns;
    /// Lines to be reported: those with an earlier login name or full name, or with a doubt about the person.
    std::vector<RosterStep> told;
};

/// The existing people and their earlier names.
struct KnownPeople {
    std::vector<Person> people;
    std::vector<EarlierLogin> earlier; ///< latest first
};

/// Returns one step for each line of the list, depending on the existing people. A person whom the list calls
/// by an earlier login name exists, too. A name that a person has today means that person.
std::vector<RosterStep> planRoster(const Roster& roster, const KnownPeople& known, RosterExisting existing);

} // namespace chiron::database
