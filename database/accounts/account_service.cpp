// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/account_service.h"

#include "database/accounts/account_rules.h"
#include "database/accounts/password_hasher.h"
#include "database/accounts/recovery_code.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"
#include "database/repositories/privacy_repository.h"

namespace chiron::database {
namespace {

// Overwritten pages may still lie in the file's free space and in the log. VACUUM rebuilds the file, and the
// checkpoint empties the log.
core::Result<void> forgetOldPages(Connection& connection) {
    CHIRON_TRY(connection.execute("VACUUM"));
    const auto busy = selectInteger(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
    CHIRON_TRY(busy);
    if (busy->value_or(1) != 0) {
        return core::fail(core::ErrorCode::storage,
                          "the person is erased, but another program is reading the database, so old pages "
                          "stay in its log until the last program has closed it");
    }
    return {};
}

} // namespace

core::Result<bool> AccountService::hasPeople() {
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return AccountRepository(**reader, Actor::anonymous()).hasPeople();
}

core::Result<std::vector<LoginName>> AccountService::listLoginNames() {
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return AccountRepository(**reader, Actor::anonymous()).listLoginNames();
}

core::Result<FirstAdministrator> AccountService::createFirstAdministrator(const std::string& name,
                                                                          const std::string& password,
                                                                          const std::string& displayName) {
    CHIRON_TRY(checkName(name));
    CHIRON_TRY(checkPassword(name, password));
    const PasswordHasher hasher(m_database.options().passwordCost);
    const std::string code = newRecoveryCode();
    const auto passwordHash = hasher.hash(password);
    const auto codeHash = hasher.hash(code);
    CHIRON_TRY(passwordHash);
    CHIRON_TRY(codeHash);
    const auto id = m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), Actor::anonymous())
            .createFirstAdministrator({name, displayName, {Role::admin}, *passwordHash, false}, *codeHash);
    });
    CHIRON_TRY(id);
    return FirstAdministrator{*id, code};
}

core::Result<PersonId> AccountService::createPerson(const Actor& actor, const PersonRequest& request) {
    CHIRON_TRY(checkPassword(request.name, request.password));
    const auto hash = PasswordHasher(m_database.options().passwordCost).hash(request.password);
    CHIRON_TRY(hash);
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor)
            .createPerson(
                {request.name, request.displayName, request.roles, *hash, request.mustChangePassword});
    });
}

core::Result<void> AccountService::changeNames(const Actor& actor, PersonId person, const std::string& name,
                                               const std::string& displayName) {
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).changeNames(person, name, displayName);
    });
}

core::Result<void> AccountService::changeDisplayName(const Actor& actor, const std::string& displayName) {
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor)
            .changeDisplayName(actor.personId(), displayName);
    });
}

core::Result<std::vector<EarlierName>> AccountService::earlierNames(const Actor& actor, PersonId person) {
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return AccountRepository(**reader, actor).earlierNames(person);
}

core::Result<Person> AccountService::self(const Actor& actor) {
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return AccountRepository(**reader, actor).person(actor.personId());
}

tl::expected<void, Refusal> AccountService::tryChangePassword(const Actor& actor,
                                                              const std::string& oldPassword,
                                                              const std::string& newPassword) {
    const auto failed = [](const core::Error& error) {
        return tl::unexpected(Refusal{Refusal::Kind::failed, 0, error});
    };
    if (auto good = checkPassword(nameNow(actor), newPassword); !good) {
        return failed(good.error());
    }
    if (oldPassword == newPassword) {
        return failed({core::ErrorCode::badInput, "the new password is the old one"});
    }
    CHIRON_TRY(tryConfirm(actor, oldPassword));
    const auto hash = PasswordHasher(m_database.options().passwordCost).hash(newPassword);
    if (!hash) {
        return failed(hash.error());
    }
    const auto stored = m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).changePassword(actor.personId(), *hash);
    });
    return stored ? tl::expected<void, Refusal>() : failed(stored.error());
}

core::Result<void> AccountService::changePassword(const Actor& actor, const std::string& oldPassword,
                                                  const std::string& newPassword) {
    const auto changed = tryChangePassword(actor, oldPassword, newPassword);
    return changed ? core::Result<void>() : tl::unexpected(changed.error().error);
}

core::Result<void> AccountService::resetPassword(const Actor& actor, PersonId person,
                                                 const std::string& newPassword) {
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    const auto whose = AccountRepository(**reader, actor).person(person);
    // Whoever may not read the person may not reset the password either: the repository refuses that below.
    if (!core::failedAs(whose, core::ErrorCode::notAllowed) &&
        !core::failedAs(whose, core::ErrorCode::notFound)) {
        CHIRON_TRY(whose);
    }
    CHIRON_TRY(checkPassword(whose ? whose->name : std::string(), newPassword));
    const auto hash = PasswordHasher(m_database.options().passwordCost).hash(newPassword);
    CHIRON_TRY(hash);
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).resetPassword(person, *hash);
    });
}

core::Result<void> AccountService::setEnabled(const Actor& actor, PersonId person, bool enabled) {
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).setEnabled(person, enabled);
    });
}

core::Result<void> AccountService::setRoles(const Actor& actor, PersonId person, const RoleSet& roles) {
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).setRoles(person, roles);
    });
}

core::Result<std::vector<Person>> AccountService::listPeople(const Actor& actor) {
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return AccountRepository(**reader, actor).listPeople();
}

core::Result<Person> AccountService::personByName(const Actor& actor, const std::string& name) {
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return AccountRepository(**reader, actor).personByName(name);
}

core::Result<void> AccountService::mayErase(const Actor& actor, const std::string& password) {
    CHIRON_TRY(confirm(actor, password));
    return m_database.isWritable() && !m_database.writer().hasSources()
               ? core::Result<void>()
               : core::fail(core::ErrorCode::wrongUse,
                            "an erasure needs the writer and waits until no session is running");
}

// Makes an erasure permanent: adds it to the site's list, which is applied to restored backups, and removes
// the data from the file's free pages.
core::Result<void> AccountService::makeErasureLast(const core::Result<Erasure>& erased) {
    CHIRON_TRY(erased);
    CHIRON_TRY(writeErasureList(m_database.siteFolder(), *erased));
    return m_database.writer().runMaintenance(
        [](WriteContext& writing) { return forgetOldPages(writing.connection()); });
}

core::Result<void> AccountService::erasePerson(const Actor& actor, const std::string& password,
                                               PersonId person, const std::string& reason,
                                               bool withdrawRecordings) {
    CHIRON_TRY(mayErase(actor, password));
    return makeErasureLast(m_database.write([&](WriteContext& writing) {
        return PrivacyRepository(writing.connection(), actor).erasePerson(person, reason, withdrawRecordings);
    }));
}

core::Result<void> AccountService::eraseParticipant(const Actor& actor, const std::string& password,
                                                    ParticipantNumber participant,
                                                    const std::string& reason) {
    CHIRON_TRY(mayErase(actor, password));
    return makeErasureLast(m_database.write([&](WriteContext& writing) {
        return PrivacyRepository(writing.connection(), actor).eraseParticipant(participant, reason);
    }));
}

} // namespace chiron::database
