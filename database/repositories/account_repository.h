// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/person.h"
#include "database/connection.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::database {

/// People, their roles and credentials. Functions that change something need the writer's connection, and
/// each function checks the actor first. Callers use accounts/account_service.h, which hashes outside the
/// writer.
class AccountRepository {
public:
    AccountRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Returns whether anybody was ever added; if not, a first administrator must be created.
    core::Result<bool> hasPeople();
    /// Returns the enabled accounts by name, for the login screen, without the simulated account and erased
    /// people.
    core::Result<std::vector<LoginName>> listLoginNames();
    /// Errors: wrongUse if there are people already.
    core::Result<PersonId> createFirstAdministrator(const NewPerson& person,
                                                    const std::string& recoveryCodeHash);
    /// Counts the attempt as failed until finishLogin reports success. While the account must wait, the
    /// attempt is not counted, and the result says how long to wait (LoginAttempt::wait_ns).
    core::Result<LoginAttempt> beginLogin(const std::string& name);
    /// Finishes a login whose password was correct.
    /// Errors: notAllowed if the account is disabled.
    core::Result<Actor> finishLogin(const LoginAttempt& attempt);
    core::Result<LoginAttempt> beginRecovery(const std::string& name);
    core::Result<void> finishRecovery(const LoginAttempt& attempt, const std::string& newPasswordHash,
                                      const std::string& newRecoveryCodeHash);

    core::Result<PersonId> createPerson(const NewPerson& person);
    /// Adds people and changes others, all or nothing.
    core::Result<std::vector<PersonId>> importPeople(const std::vector<NewPerson>& people,
                                                     const std::vector<PersonChange>& changes = {});
    core::Result<std::vector<Person>> listPeople(); ///< without the simulated account and erased people
    core::Result<Person> person(PersonId id);
    core::Result<Person> personByName(const std::string& name);
    /// Refused for the last enabled administrator.
    core::Result<void> setEnabled(PersonId id, bool enabled);
    /// Refused for the last enabled administrator.
    core::Result<void> setRoles(PersonId id, const RoleSet& roles);
    /// Changes login name and display name. The previous names are kept (earlierNames).
    /// Errors: badInput if the login name is taken or not allowed.
    core::Result<void> changeNames(PersonId id, const std::string& name, const std::string& displayName);
    core::Result<void> changeDisplayName(PersonId id, const std::string& displayName);
    core::Result<std::vector<EarlierName>> earlierNames(PersonId id); ///< latest first
    /// Returns earlier names of people, latest first. With them an import finds out whom an old list means,
    /// and which of its full names are outdated. One of the two names may be the current one.
    core::Result<std::vector<EarlierLogin>> listEarlierLogins();
    core::Result<void> changePassword(PersonId id, const std::string& newHash);
    core::Result<void> resetPassword(PersonId id, const std::string& newHash);
    core::Result<bool> hasRecoveryCode(PersonId id);
    /// Replaces the previous code, which becomes invalid.
    core::Result<void> setRecoveryCode(PersonId id, const std::string& newHash);

private:
    core::Result<bool> anybody();
    core::Result<PersonId> insertPerson(const NewPerson& person);
    /// otherThan 0: nobody is exempt.
    core::Result<void> nameIsFree(const std::string& name, PersonId otherThan);
    core::Result<void> storeNames(const char* action, PersonId id, const std::optional<std::string>& newName,
                                  const std::string& displayName);
    core::Result<void> storeRoles(PersonId id, const RoleSet& roles);
    core::Result<void> keepsAnAdministrator();
    core::Result<void> storePassword(PersonId id, const std::string& hash, bool mustChange);
    core::Result<Actor> actorFor(PersonId id);
    core::Result<LoginAttempt> beginAttempt(const std::string& name, bool recovery);

    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
