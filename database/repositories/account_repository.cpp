// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/account_repository.h"

#include "core/clock.h"
#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"

#include <sodium.h>

namespace chiron::database {
namespace {

// 8 symbols out of 32 that do not look alike: 40 bits; the table enforces uniqueness.
std::string newPersonCode() {
    static constexpr char kSymbols[] = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789";
    std::string code = "P-";
    for (int i = 0; i < 8; ++i) {
        code.push_back(kSymbols[randombytes_uniform(32)]);
    }
    return code;
}

core::Result<void> writeAllowed(Connection& connection, const Actor& actor, Action action) {
    CHIRON_TRY(requireWriter(connection));
    const auto scope = authorise(connection, actor, action);
    CHIRON_TRY(scope);
    return {};
}

core::Result<void> exists(Connection& connection, PersonId id) {
    const auto found =
        selectInteger(connection, "SELECT 1 FROM person WHERE id = ? AND kind = 'person'", {id});
    CHIRON_TRY(found);
    return *found ? core::Result<void>()
                  : core::fail(core::ErrorCode::notFound, "there is no person " + std::to_string(id));
}

} // namespace

core::Result<PersonId> AccountRepository::createFirstAdministrator(const NewPerson& person,
                                                                   const std::string& recoveryCodeHash) {
    CHIRON_TRY(writeAllowed(m_connection, m_actor, Action::createFirstAdministrator));
    const auto any = anybody();
    CHIRON_TRY(any);
    if (*any) {
        return core::fail(core::ErrorCode::wrongUse,
                          "this database has people already; an administrator adds more");
    }
    NewPerson administrator = person;
    administrator.roles = {Role::admin};
    const auto id = insertPerson(administrator);
    CHIRON_TRY(id);
    auto stored =
        updateRow(m_connection, "credential", {{"person_id", *id}}, {{"recovery_hash", recoveryCodeHash}});
    CHIRON_TRY(stored);
    return id;
}

core::Result<PersonId> AccountRepository::createPerson(const NewPerson& person) {
    CHIRON_TRY(writeAllowed(m_connection, m_actor, Action::createPerson));
    return insertPerson(person);
}

core::Result<std::vector<PersonId>>
AccountRepository::importPeople(const std::vector<NewPerson>& people,
                                const std::vector<PersonChange>& changes) {
    CHIRON_TRY(writeAllowed(m_connection, m_actor, Action::importPeople));
    std::vector<PersonId> ids;
    for (const NewPerson& person : people) {
        const auto id = insertPerson(person);
        CHIRON_TRY(id); // the job's transaction also undoes the previous ones
        ids.push_back(*id);
    }
    for (const PersonChange& change : changes) {
        const auto before = selectText(m_connection, "SELECT roles FROM person WHERE id = ?", {change.id});
        CHIRON_TRY(before);
        auto done = storeNames("importNames", change.id, std::nullopt, change.displayName);
        done =
            done && before->value_or("") != change.roles.list() ? storeRoles(change.id, change.roles) : done;
        CHIRON_TRY(done);
    }
    auto kept = changes.empty() ? core::Result<void>() : keepsAnAdministrator();
    CHIRON_TRY(kept);
    return ids;
}

core::Result<PersonId> AccountRepository::insertPerson(const NewPerson& person) {
    CHIRON_TRY(checkNames(person.name, person.displayName));
    if (person.roles.empty() || person.passwordHash.empty()) {
        return core::fail(core::ErrorCode::badInput,
                          person.name + ": at least one role and a password are needed");
    }
    CHIRON_TRY(nameIsFree(person.name, 0));
    const auto last = selectInteger(m_connection, "SELECT max(id) FROM person");
    CHIRON_TRY(last);
    const PersonId id = last->value_or(0) + 1;
    const auto row = insertRow(m_connection, "person",
                               {{"id", id},
                                {"kind", std::string("person")},
                                {"name", person.name},
                                {"name_key", nameKey(person.name)},
                                {"display_name", person.displayName},
                                {"roles", person.roles.list()},
                                {"enabled", std::int64_t{1}},
                                {"created_utc", core::utcNowIso8601()}});
    CHIRON_TRY(row);
    const auto code = insertRow(m_connection, "person_code", {{"person_id", id}, {"code", newPersonCode()}});
    const auto credential = insertRow(m_connection, "credential",
                                      {{"person_id", id},
                                       {"password_hash", person.passwordHash},
                                       {"recovery_hash", std::string()},
                                       {"failures", std::int64_t{0}},
                                       {"must_change", std::int64_t{person.mustChangePassword}},
                                       {"wait_boot", std::string()},
                                       {"wait_until_ns", std::int64_t{0}}});
    CHIRON_TRY(code);
    CHIRON_TRY(credential);
    auto audited =
        appendAudit(m_connection, m_actor,
                    {"createPerson", "person", id, *row, "{\"roles\":\"" + person.roles.list() + "\"}"});
    CHIRON_TRY(audited);
    return id;
}

core::Result<void> AccountRepository::setEnabled(PersonId id, bool enabled) {
    CHIRON_TRY(writeAllowed(m_connection, m_actor, Action::setEnabled));
    CHIRON_TRY(exists(m_connection, id));
    const auto row = updateRow(m_connection, "person", {{"id", id}}, {{"enabled", std::int64_t{enabled}}});
    CHIRON_TRY(row);
    CHIRON_TRY(keepsAnAdministrator());
    return appendAudit(m_connection, m_actor, {enabled ? "enable" : "disable", "person", id, *row, "{}"});
}

core::Result<void> AccountRepository::setRoles(PersonId id, const RoleSet& roles) {
    CHIRON_TRY(writeAllowed(m_connection, m_actor, Action::setRoles));
    CHIRON_TRY(exists(m_connection, id));
    CHIRON_TRY(storeRoles(id, roles));
    return keepsAnAdministrator();
}

core::Result<void> AccountRepository::storeRoles(PersonId id, const RoleSet& roles) {
    if (roles.empty()) {
        return core::fail(core::ErrorCode::badInput,
                          "at least one role is needed (disable the account instead)");
    }
    const auto row = updateRow(m_connection, "person", {{"id", id}}, {{"roles", roles.list()}});
    CHIRON_TRY(row);
    return appendAudit(m_connection, m_actor,
                       {"setRoles", "person", id, *row, "{\"roles\":\"" + roles.list() + "\"}"});
}

core::Result<void> AccountRepository::keepsAnAdministrator() {
    const auto left =
        selectInteger(m_connection, "SELECT count(*) FROM person WHERE kind = 'person' AND enabled = 1 AND "
                                    "instr(',' || roles || ',', ',admin,') > 0");
    CHIRON_TRY(left);
    return left->value_or(0) > 0
               ? core::Result<void>()
               : core::fail(core::ErrorCode::wrongUse,
                            "this is the last enabled administrator; make another one first");
}

core::Result<void> AccountRepository::changePassword(PersonId id, const std::string& newHash) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authoriseFor(m_connection, m_actor, Action::changePassword, id));
    CHIRON_TRY(storePassword(id, newHash, false));
    return appendAudit(m_connection, m_actor, {"changePassword", "credential", id, std::nullopt, "{}"});
}

core::Result<void> AccountRepository::resetPassword(PersonId id, const std::string& newHash) {
    CHIRON_TRY(writeAllowed(m_connection, m_actor, Action::resetPassword));
    CHIRON_TRY(exists(m_connection, id));
    CHIRON_TRY(storePassword(id, newHash, true));
    return appendAudit(m_connection, m_actor, {"resetPassword", "credential", id, std::nullopt, "{}"});
}

core::Result<bool> AccountRepository::hasRecoveryCode(PersonId id) {
    CHIRON_TRY(authoriseFor(m_connection, m_actor, Action::hasRecoveryCode, id));
    const auto has =
        selectInteger(m_connection, "SELECT recovery_hash <> '' FROM credential WHERE person_id = ?", {id});
    CHIRON_TRY(has);
    return has->value_or(0) != 0;
}

core::Result<void> AccountRepository::setRecoveryCode(PersonId id, const std::string& newHash) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authoriseFor(m_connection, m_actor, Action::setRecoveryCode, id));
    const auto row = updateRow(m_connection, "credential", {{"person_id", id}}, {{"recovery_hash", newHash}});
    CHIRON_TRY(row);
    return appendAudit(m_connection, m_actor, {"setRecoveryCode", "credential", id, std::nullopt, "{}"});
}

core::Result<void> AccountRepository::storePassword(PersonId id, const std::string& hash, bool mustChange) {
    const auto row = updateRow(m_connection, "credential", {{"person_id", id}},
                               {{"password_hash", hash},
                                {"must_change", std::int64_t{mustChange}},
                                {"failures", std::int64_t{0}},
                                {"wait_until_ns", std::int64_t{0}}});
    CHIRON_TRY(row);
    return {};
}

} // namespace chiron::database
