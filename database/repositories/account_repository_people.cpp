// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/authorise.h"
#include "database/accounts/account_rules.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"

namespace chiron::database {
namespace {

constexpr const char* kPersonColumns =
    "SELECT p.id, p.name, p.display_name, coalesce(k.code, ''), p.roles, p.enabled, coalesce(c.must_change, "
    "0), "
    "p.created_utc FROM person p LEFT JOIN person_code k ON k.person_id = p.id "
    "LEFT JOIN credential c ON c.person_id = p.id WHERE p.kind = 'person'";

Person personOf(const Query& row) {
    return {row.integer(0),
            row.text(1),
            row.text(2),
            row.text(3),
            rolesFromList(row.text(4)).value_or(RoleSet{}),
            row.integer(5) != 0,
            row.integer(6) != 0,
            row.text(7)};
}

} // namespace

core::Result<bool> AccountRepository::hasPeople() {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::hasPeople));
    return anybody();
}

core::Result<bool> AccountRepository::anybody() {
    const auto any = selectInteger(m_connection, "SELECT count(*) FROM person WHERE kind <> 'simulated'");
    CHIRON_TRY(any);
    return any->value_or(1) != 0;
}

core::Result<std::vector<LoginName>> AccountRepository::listLoginNames() {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::listLoginNames));
    auto query = Query::run(m_connection, "SELECT id, name, display_name FROM person "
                                          "WHERE kind = 'person' AND enabled = 1 ORDER BY name_key");
    CHIRON_TRY(query);
    std::vector<LoginName> names;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        names.push_back({query->integer(0), query->text(1), query->text(2)});
    }
    CHIRON_TRY(row);
    return names;
}

core::Result<std::vector<Person>> AccountRepository::listPeople() {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::listPeople));
    auto query = Query::run(m_connection, std::string(kPersonColumns) + " ORDER BY p.name_key");
    CHIRON_TRY(query);
    std::vector<Person> people;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        people.push_back(personOf(*query));
    }
    CHIRON_TRY(row);
    return people;
}

core::Result<Person> AccountRepository::person(PersonId id) {
    CHIRON_TRY(authoriseFor(m_connection, m_actor, Action::person, id));
    auto query = Query::run(m_connection, std::string(kPersonColumns) + " AND p.id = ?", {id});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    return *row ? core::Result<Person>(personOf(*query))
                : core::fail(core::ErrorCode::notFound, "there is no person " + std::to_string(id));
}

core::Result<Person> AccountRepository::personByName(const std::string& name) {
    const auto scope = authorise(m_connection, m_actor, Action::personByName);
    CHIRON_TRY(scope);
    auto query =
        Query::run(m_connection, std::string(kPersonColumns) + " AND p.name_key = ?", {nameKey(name)});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (*row && (*scope == Scope::all || query->integer(0) == m_actor.personId())) {
        return personOf(*query);
    }
    // An actor who may see only themselves learns nothing about who else exists.
    return *scope == Scope::all
               ? core::fail(core::ErrorCode::notFound, "there is no person named \"" + name + "\"")
               : core::fail(core::ErrorCode::notAllowed,
                            "not allowed: people other than oneself; ask an administrator");
}

} // namespace chiron::database
