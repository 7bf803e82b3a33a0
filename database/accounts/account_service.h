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

/// A person to be created, with the password in the clear (it is hashed on the calling thread and not kept).
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

/// Accounts as the programs use them: hashes on the calling thread (a worker in the desktop), hands short
/// jobs to the writer. Every call is checked in the data layer. Blocking; thread-safe.
class AccountService {
public:
    explicit AccountService(Database& database) : m_database(database) {}

    /// Whether anybody was ever added; if not, createFirstAdministrator is due. Anybody may ask.
    core::Result<bool> hasPeople();
    /// Enabled accounts by name, for the login screen. Anybody may ask.
    core::Result<std::vector<LoginName>> listLoginNames();

    /// Only while the database has no people. Failure: wrongUse otherwise; badInput with the rules.
    core::Result<FirstAdministrator> createFirstAdministrator(const std::string& name,
                                                              const std::string& password,
                                                              const std::string& displayName = {});

    /// Who this is. Wrong passwords are counted per account before they are checked, and make it wait: after
    /// the third 2 s, doubling to 5 minutes, kept over restarts and clock changes. On a database opened
    /// read-only the wait is honoured but cannot be lengthened. Failure: notAllowed (same words for an
    /// unknown name), with the wait in seconds.
    core::Result<Actor> login(const std::string& name, const std::string& password);
    /// The same for a screen: a refusal says its kind and how long the next attempt must wait.
    tl::expected<Actor, Refusal> tryLogin(const std::string& name, const std::string& password);
    /// tryLogin of somebody who is logged in already: unlocking, confirming.
    tl::expected<Actor, Refusal> tryConfirm(const Actor& actor, const std::string& password);

    /// Sets a new password with the recovery code; the code is used up and a new one returned. Throttled like
    /// login.
    core::Result<std::string> recover(const std::string& name, const std::string& code,
                                      const std::string& newPassword);
    tl::expected<std::string, Refusal> tryRecover(const std::string& name, const std::string& code,
                                                  const std::string& newPassword);

    /// Whether the actor, an administrator, has a recovery code.
    core::Result<bool> hasRecoveryCode(const Actor& actor);
    /// A new recovery code for the actor, an administrator, whom the password confirms; the one before is not accepted any more. It is
    /// returned this once; only its hash is stored. A wrong password is counted and throttled like a login.
    tl::expected<std::string, Refusal> tryMakeRecoveryCode(const Actor& actor, const std::string& password);
    core::Result<std::string> makeRecoveryCode(const Actor& actor, const std::string& password);

    core::Result<PersonId> createPerson(const Actor& actor, const PersonRequest& request);
    /// A list of people (readRoster): adds those who are new and leaves or changes those who are here already.
    /// All or nothing; everything wrong is named (line, column, value, expectation). Passwords that the list does
    /// not give are made; whoever is new must change theirs at the first login.
    /// `step` hears how many passwords are hashed, of how many (that is what takes long); false from it ends
    /// the import with cancelled, and nothing was changed. `roles`: what words of the list stand for that are no role.
    core::Result<RosterOutcome> importCsv(const Actor& actor, const std::string& csv,
                                          RosterExisting existing = RosterExisting::skip,
                                          const std::function<bool(int done, int of)>& step = {}, const RoleWords& roles = {});
    /// What importCsv would do, without doing it, and without passwords. Failure: notAllowed, storage.
    core::Result<RosterPlan> previewCsv(const Actor& actor, const std::string& csv,
                                        RosterExisting existing = RosterExisting::skip, const RoleWords& roles = {});
    /// Failure: badInput when the login name is taken or not allowed.
    core::Result<void> changeNames(const Actor& actor, PersonId person, const std::string& name,
                                   const std::string& displayName);
    /// One's own.
    core::Result<void> changeDisplayName(const Actor& actor, const std::string& displayName);
    /// What somebody was called before, latest first.
    core::Result<std::vector<EarlierName>> earlierNames(const Actor& actor, PersonId person);
    core::Result<void> changePassword(const Actor& actor, const std::string& oldPassword,
                                      const std::string& newPassword);
    /// The same for a screen: a wrong old password is counted and throttled like a login.
    tl::expected<void, Refusal> tryChangePassword(const Actor& actor, const std::string& oldPassword,
                                                  const std::string& newPassword);
    /// By an administrator: the person must change it at the next login.
    core::Result<void> resetPassword(const Actor& actor, PersonId person, const std::string& newPassword);
    core::Result<void> setEnabled(const Actor& actor, PersonId person, bool enabled);
    core::Result<void> setRoles(const Actor& actor, PersonId person, const RoleSet& roles);
    core::Result<std::vector<Person>> listPeople(const Actor& actor);
    /// The actor's own account, as it is now.
    core::Result<Person> self(const Actor& actor);
    core::Result<Person> personByName(const Actor& actor, const std::string& name);
    /// Erases a person (data.md, Proof): the administrator's own password confirms it. Overwrites, then
    /// VACUUMs. withdrawRecordings also overwrites their samples. Where it stopped half-way (disk full,
    /// another program reading) it can be asked for again and goes on. Failure: wrongUse while a session is
    /// running.
    core::Result<void> erasePerson(const Actor& actor, const std::string& password, PersonId person,
                                   const std::string& reason, bool withdrawRecordings);
    /// The same for a withdrawn participant of a study, by number: key, free texts and questionnaires, and the
    /// recordings where the participant wished so. Runs and trials stay under the code.
    core::Result<void> eraseParticipant(const Actor& actor, const std::string& password, ParticipantNumber participant,
                                        const std::string& reason);

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
