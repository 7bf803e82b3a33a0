// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/account_service.h"

#include "database/access/authorise.h"
#include "database/accounts/account_rules.h"
#include "database/accounts/password_hasher.h"
#include "database/accounts/recovery_code.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"
#include "database/repositories/privacy_repository.h"

#include <algorithm>
#include <set>

namespace chiron::database {
namespace {

// Overwritten pages may still lie in the file's free space and in the log: the one is rebuilt, the other
// emptied.
core::Result<void> forgetOldPages(Connection& connection) {
    if (auto vacuumed = connection.execute("VACUUM"); !vacuumed) {
        return vacuumed;
    }
    const auto busy = selectInteger(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
    if (!busy) {
        return tl::unexpected(busy.error());
    }
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
    return reader ? AccountRepository(**reader, Actor::anonymous()).hasPeople()
                  : tl::unexpected(reader.error());
}

core::Result<std::vector<LoginName>> AccountService::listLoginNames() {
    auto reader = m_database.openReader();
    return reader ? AccountRepository(**reader, Actor::anonymous()).listLoginNames()
                  : tl::unexpected(reader.error());
}

core::Result<FirstAdministrator> AccountService::createFirstAdministrator(const std::string& name,
                                                                          const std::string& password,
                                                                          const std::string& displayName) {
    if (auto good = checkName(name); !good) {
        return tl::unexpected(good.error());
    }
    if (auto good = checkPassword(name, password); !good) {
        return tl::unexpected(good.error());
    }
    const PasswordHasher hasher(m_database.options().passwordCost);
    const std::string code = newRecoveryCode();
    const auto passwordHash = hasher.hash(password);
    const auto codeHash = hasher.hash(code);
    if (!passwordHash || !codeHash) {
        return tl::unexpected(!passwordHash ? passwordHash.error() : codeHash.error());
    }
    const auto id = m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), Actor::anonymous())
            .createFirstAdministrator({name, displayName, {Role::admin}, *passwordHash, false}, *codeHash);
    });
    return id ? core::Result<FirstAdministrator>({*id, code}) : tl::unexpected(id.error());
}

core::Result<PersonId> AccountService::createPerson(const Actor& actor, const PersonRequest& request) {
    if (auto good = checkPassword(request.name, request.password); !good) {
        return tl::unexpected(good.error());
    }
    const auto hash = PasswordHasher(m_database.options().passwordCost).hash(request.password);
    if (!hash) {
        return tl::unexpected(hash.error());
    }
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor)
            .createPerson(
                {request.name, request.displayName, request.roles, *hash, request.mustChangePassword});
    });
}

core::Result<Roster> AccountService::previewCsv(const Actor& actor, const std::string& csvText) {
    auto reader = m_database.openReader();
    if (!reader) {
        return tl::unexpected(reader.error());
    }
    if (const auto scope = authorise(**reader, actor, Action::importPeople); !scope) {
        return tl::unexpected(scope.error());
    }
    const auto people = AccountRepository(**reader, actor).listPeople();
    if (!people) {
        return tl::unexpected(people.error());
    }
    std::set<std::string> taken;
    for (const Person& person : *people) {
        taken.insert(nameKey(person.name));
    }
    Roster roster = readRoster(csvText);
    for (UserCsvRow& row : roster.rows) {
        row.password.clear(); // whoever looks at the preview has no need of it
        if (taken.contains(nameKey(row.name))) {
            roster.problems.push_back({row.line, RosterFault::nameTaken, row.name, 0,
                                       "name \"" + row.name + "\": somebody has it already"});
        }
    }
    std::stable_sort(roster.problems.begin(), roster.problems.end(),
                     [](const RosterProblem& a, const RosterProblem& b) { return a.line < b.line; });
    return roster;
}

core::Result<std::vector<PersonId>>
AccountService::importCsv(const Actor& actor, const std::string& csvText,
                          const std::function<bool(int done, int of)>& step) {
    const auto rows = parseUserCsv(csvText);
    if (!rows) {
        return tl::unexpected(rows.error());
    }
    const PasswordHasher hasher(m_database.options().passwordCost);
    std::vector<NewPerson> people;
    for (const UserCsvRow& row : *rows) {
        if (step && !step(static_cast<int>(people.size()), static_cast<int>(rows->size()))) {
            return core::fail(core::ErrorCode::cancelled, "the import was stopped; nobody was added");
        }
        const auto hash = hasher.hash(row.password);
        if (!hash) {
            return tl::unexpected(hash.error());
        }
        people.push_back({row.name, row.displayName, row.roles, *hash, true});
    }
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).importPeople(people);
    });
}

core::Result<void> AccountService::changePassword(const Actor& actor, const std::string& oldPassword,
                                                  const std::string& newPassword) {
    if (auto good = checkPassword(actor.name(), newPassword); !good) {
        return good;
    }
    if (oldPassword == newPassword) {
        return core::fail(core::ErrorCode::badInput, "the new password is the old one");
    }
    if (auto confirmed = confirm(actor, oldPassword); !confirmed) {
        return tl::unexpected(confirmed.error());
    }
    const auto hash = PasswordHasher(m_database.options().passwordCost).hash(newPassword);
    if (!hash) {
        return tl::unexpected(hash.error());
    }
    return m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).changePassword(actor.personId(), *hash);
    });
}

core::Result<void> AccountService::resetPassword(const Actor& actor, PersonId person,
                                                 const std::string& newPassword) {
    if (auto good = checkPassword("", newPassword); !good) {
        return good;
    }
    const auto hash = PasswordHasher(m_database.options().passwordCost).hash(newPassword);
    if (!hash) {
        return tl::unexpected(hash.error());
    }
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
    return reader ? AccountRepository(**reader, actor).listPeople() : tl::unexpected(reader.error());
}

core::Result<Person> AccountService::personByName(const Actor& actor, const std::string& name) {
    auto reader = m_database.openReader();
    return reader ? AccountRepository(**reader, actor).personByName(name) : tl::unexpected(reader.error());
}

core::Result<void> AccountService::mayErase(const Actor& actor, const std::string& password) {
    if (auto confirmed = confirm(actor, password); !confirmed) {
        return tl::unexpected(confirmed.error());
    }
    return m_database.isWritable() && !m_database.writer().hasSources()
               ? core::Result<void>()
               : core::fail(core::ErrorCode::wrongUse,
                            "an erasure needs the writer and waits until no session is running");
}

// On the site's list, for backups that are restored, and out of the file's free pages.
core::Result<void> AccountService::makeErasureLast(const core::Result<Erasure>& erased) {
    if (!erased) {
        return tl::unexpected(erased.error());
    }
    if (auto listed = writeErasureList(m_database.siteFolder(), *erased); !listed) {
        return listed;
    }
    return m_database.writer().runMaintenance(
        [](WriteContext& writing) { return forgetOldPages(writing.connection()); });
}

core::Result<void> AccountService::erasePerson(const Actor& actor, const std::string& password,
                                               PersonId person, const std::string& reason,
                                               bool withdrawRecordings) {
    if (auto may = mayErase(actor, password); !may) {
        return may;
    }
    return makeErasureLast(m_database.write([&](WriteContext& writing) {
        return PrivacyRepository(writing.connection(), actor).erasePerson(person, reason, withdrawRecordings);
    }));
}

core::Result<void> AccountService::eraseParticipant(const Actor& actor, const std::string& password,
                                                    ParticipantNumber participant, const std::string& reason) {
    if (auto may = mayErase(actor, password); !may) {
        return may;
    }
    return makeErasureLast(m_database.write([&](WriteContext& writing) {
        return PrivacyRepository(writing.connection(), actor).eraseParticipant(participant, reason);
    }));
}

} // namespace chiron::database
