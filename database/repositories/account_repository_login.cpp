// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/accounts/throttle.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/repositories/account_repository.h"

#include <algorithm>

namespace chiron::database {
namespace {

struct StoredCredential {
    LoginAttempt attempt;
    ThrottleState throttle;
};

core::Result<StoredCredential> credentialOf(Connection& connection, const std::string& name, bool recovery) {
    auto query = Query::run(connection,
                            "SELECT c.person_id, c.password_hash, c.recovery_hash, c.failures, c.wait_boot, "
                            "c.wait_until_ns FROM credential c JOIN person p ON p.id = c.person_id "
                            "WHERE p.name_key = ? AND p.kind = 'person'",
                            {nameKey(name)});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    StoredCredential found;
    if (*row) {
        found.attempt = {query->integer(0), query->text(recovery ? 2 : 1)};
        found.throttle = {query->integer(3), query->text(4), query->integer(5)};
    }
    return found;
}

} // namespace

core::Result<LoginAttempt> AccountRepository::beginLogin(const std::string& name) {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::beginLogin));
    return beginAttempt(name, false);
}

core::Result<LoginAttempt> AccountRepository::beginRecovery(const std::string& name) {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::beginRecovery));
    return beginAttempt(name, true);
}

core::Result<LoginAttempt> AccountRepository::beginAttempt(const std::string& name, bool recovery) {
    auto found = credentialOf(m_connection, name, recovery);
    CHIRON_TRY(found);
    if (found->attempt.person == 0 || m_connection.clock() == nullptr) {
        return LoginAttempt{};
    }
    const BootTime now = m_connection.clock()->now();
    ThrottleState& throttle = found->throttle;
    const std::string bootBefore = throttle.boot;
    const std::int64_t remaining = throttleRemaining_ns(throttle, now);
    const LoginAttempt waiting{found->attempt.person, "", remaining};
    if (remaining > 0 && throttle.boot == bootBefore) {
        return waiting;
    }
    if (!m_connection.isWritable()) { // beside a writer: the wait applies, but the attempt cannot be counted
        return remaining > 0 ? waiting : found->attempt;
    }
    if (remaining == 0) {
        throttleCount(throttle, now);
    }
    const auto stored = updateRow(m_connection, "credential", {{"person_id", found->attempt.person}},
                                  {{"failures", throttle.failures},
                                   {"wait_boot", throttle.boot},
                                   {"wait_until_ns", throttle.waitUntil_ns}});
    CHIRON_TRY(stored);
    found->attempt.waitIfWrong_ns = throttleRemaining_ns(throttle, now);
    // After a restart the wait begins anew, and this must be stored. It is therefore an outcome and not a
    // failure, which would be rolled back.
    return remaining > 0 ? waiting : found->attempt;
}

core::Result<Actor> AccountRepository::finishLogin(const LoginAttempt& attempt) {
    CHIRON_TRY(authorise(m_connection, m_actor, Action::finishLogin));
    auto actor = actorFor(attempt.person);
    if (!actor || !m_connection.isWritable()) {
        return actor;
    }
    const auto failures =
        selectInteger(m_connection, "SELECT failures FROM credential WHERE person_id = ?", {attempt.person});
    CHIRON_TRY(failures);
    const auto row = updateRow(m_connection, "credential", {{"person_id", attempt.person}},
                               {{"failures", std::int64_t{0}}, {"wait_until_ns", std::int64_t{0}}});
    CHIRON_TRY(row);
    // The correct attempt was counted too, before it was checked.
    const std::string wrong = std::to_string(std::max<std::int64_t>(failures->value_or(1) - 1, 0));
    auto audited =
        appendAudit(m_connection, *actor,
                    {"login", "person", attempt.person, std::nullopt, "{\"wrong_before\":" + wrong + "}"});
    CHIRON_TRY(audited);
    return actor;
}

core::Result<Actor> AccountRepository::actorFor(PersonId id) {
    auto query = Query::run(m_connection,
                            "SELECT p.name, p.roles, p.enabled, c.must_change, p.display_name FROM person p "
                            "JOIN credential c ON c.person_id = p.id WHERE p.id = ? AND p.kind = 'person'",
                            {id});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (!*row || query->integer(2) != 1) {
        return core::fail(core::ErrorCode::notAllowed, "this account is disabled; ask an administrator");
    }
    return Actor(ActorKind::person, id, query->text(0), rolesFromList(query->text(1)).value_or(RoleSet{}),
                 query->integer(3) != 0, query->text(4));
}

core::Result<void> AccountRepository::finishRecovery(const LoginAttempt& attempt,
                                                     const std::string& newPasswordHash,
                                                     const std::string& newRecoveryCodeHash) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authorise(m_connection, m_actor, Action::finishRecovery));
    const auto actor = actorFor(attempt.person);
    CHIRON_TRY(actor);
    CHIRON_TRY(storePassword(attempt.person, newPasswordHash, false));
    const auto row = updateRow(m_connection, "credential", {{"person_id", attempt.person}},
                               {{"recovery_hash", newRecoveryCodeHash}});
    CHIRON_TRY(row);
    return appendAudit(m_connection, *actor, {"recover", "credential", attempt.person, std::nullopt, "{}"});
}

} // namespace chiron::database
