// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/person.h"
#include "database/accounts/roster_import.h"
#include "database/database.h"
#include "database/privacy/erasure.h"
#include "database/repositories/study_types.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace chiron::database {

/// A person to be created, with the password in clear text (it is hashed on the calling thread and not kept).
struct PersonRequest {
    std::string name;
    std::string displayName;
    RoleSet roles;
    std::string password;
    bool mustChangePassword = false;
};

struct FirstAdministrator {
    PersonId id = 0;
    std::string recoveryCode; ///< shown once; only its hash is stored
};

/// The accounts as the programs use them. The service hashes passwords on the calling thread (a worker in the
/// desktop program) and gives short jobs to the writer. The data layer checks every call.
/// Thread: any; blocks.
class AccountService {
public:
    explicit AccountService(Database& database) : m_database(database) {}

    /// Returns whether anybody was ever added. If not, createFirstAdministrator is due. Any actor may call
    /// it.
    core::Result<bool> hasPeople();
    /// Returns the enabled accounts by name, for the login screen. Any actor may call it.
    core::Result<std::vector<LoginName>> listLoginNames();

    /// Creates the first administrator; possible only while the database has no people.
    /// Errors: wrongUse otherwise; badInput stating the rules.
    core::Result<FirstAdministrator> createFirstAdministrator(const std::string& name,
                                                              const std::string& password,
                                                              const std::string& displayName = {});

    /// Logs a person in. Each attempt is counted per account as wrong before it is checked, and wrong ones
    /// make the account wait: 2 s after the third, doubling up to 5 minutes, also across restarts and clock
    /// changes. On a database opened read-only the wait applies but cannot be lengthened.
    /// Errors: notAllowed (with the same words for an unknown name), with the wait in seconds.
    core::Result<Actor> login(const std::string& name, const std::string& password);
    /// The same for a screen: a refusal states its kind and how long the next attempt must wait.
    tl::expected<Actor, Refusal> tryLogin(const std::string& name, const std::string& password);
    /// The same for a person who is logged in already: for unlocking and confirming.
    tl::expected<Actor, Refusal> tryConfirm(const Actor& actor, const std::string& password);

    /// Sets a new password with the recovery code. The code is used up, and a new one is returned. Throttled
    /// like login.
    core::Result<std::string> recover(const std::string& name, const std::string& code,
                                      const std::string& newPassword);
    tl::expected<std::string, Refusal> tryRecover(const std::string& name, const std::string& code,
                                                  const std::string& newPassword);

    /// Returns whether the actor, an administrator, has a recovery code.
    core::Result<bool> hasRecoveryCode(const Actor& actor);
    /// Makes a new recovery code for the actor, an administrator, who confirms with the password; the
    /// previous code becomes invalid. The code is returned only this once, and only its hash is stored. A
    /// wrong password is counted and throttled like a login.
    tl::expected<std::string, Refusal> tryMakeRecoveryCode(const Actor& actor, const std::string& password);
    core::Result<std::string> makeRecoveryCode(const Actor& actor, const std::string& password);

    core::Result<PersonId> createPerson(const Actor& actor, const PersonRequest& request);
    /// Imports a list of people (readRoster): adds new people, and leaves or changes those who already have
    /// an account. It imports all or nothing, and the error names everything that is wrong (line, column,
    /// value, expectation). Passwords that the list does not give are generated; new people must change
    /// theirs at the first login. `step` receives how many of how many passwords have been hashed, which is
    /// what takes long. If it returns false, the import ends with cancelled and nothing has changed. `roles`
    /// says which roles stand for words of the list that are no role names.
    core::Result<RosterOutcome> importCsv(const Actor& actor, const std::string& csv,
                                          RosterExisting existing = RosterExisting::skip,
                                          const std::function<bool(int done, int of)>& step = {},
                                          const RoleWords& roles = {});
    /// Returns what importCsv would do, without doing it and without passwords.
    /// Errors: notAllowed, storage.
    core::Result<RosterPlan> previewCsv(const Actor& actor, const std::string& csv,
                                        RosterExisting existing = RosterExisting::skip,
                                        const RoleWords& roles = {});
    /// Errors: badInput if the login name is taken or not allowed.
    core::Result<void> changeNames(const Actor& actor, PersonId person, const std::string& name,
                                   const std::string& displayName);
    /// Changes the actor's own display name.
    core::Result<void> changeDisplayName(const Actor& actor, const std::string& displayName);
    /// Returns a person's earlier names, latest first.
    core::Result<std::vector<EarlierName>> earlierNames(const Actor& actor, PersonId person);
    core::Result<void> changePassword(const Actor& actor, const std::string& oldPassword,
                                      const std::string& newPassword);
    /// The same for a screen: a wrong old password is counted and throttled like a login.
    tl::expected<void, Refusal> tryChangePassword(const Actor& actor, const std::string& oldPassword,
                                                  const std::string& newPassword);
    /// Sets a password as an administrator: the person must change it at the next login.
    /// Errors: notAllowed, notFound; badInput if the rules for passwords do not permit it.
    core::Result<void> resetPassword(const Actor& actor, PersonId person, const std::string& newPassword);
    core::Result<void> setEnabled(const Actor& actor, PersonId person, bool enabled);
    core::Result<void> setRoles(const Actor& actor, PersonId person, const RoleSet& roles);
    core::Result<std::vector<Person>> listPeople(const Actor& actor);
    /// Returns the actor's own account as it is now.
    core::Result<Person> self(const Actor& actor);
    core::Result<Person> personByName(const Actor& actor, const std::string& name);
    /// Erases a person (data.md, Proof); the administrator confirms with their own password. It overwrites
    /// the data and then runs VACUUM. With withdrawRecordings it also overwrites the samples of the person's
    /// sessions. If it stopped half-way (disk full, another program reading), it can be called again and
    /// continues.
    /// Errors: wrongUse while a session is running.
    core::Result<void> erasePerson(const Actor& actor, const std::string& password, PersonId person,
                                   const std::string& reason, bool withdrawRecordings);
    /// Erases, in the same way, a withdrawn participant of a study, by number: key, free texts and
    /// questionnaires, and the recordings if the participant wished so. Runs and trials remain under the
    /// code.
    core::Result<void> eraseParticipant(const Actor& actor, const std::string& password,
                                        ParticipantNumber participant, const std::string& reason);

private:
    core::Result<void> mayErase(const Actor& actor, const std::string& password);
    core::Result<void> makeErasureLast(const core::Result<Erasure>& erased);
    core::Result<LoginAttempt> begin(const std::string& name, bool recovery);
    core::Result<Actor> finish(const LoginAttempt& attempt);
    core::Result<Actor> confirm(const Actor& actor, const std::string& password);
    std::string nameNow(const Actor& actor);
    Database& m_database;
};

} // namespace chiron::database
