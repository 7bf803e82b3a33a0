// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/account_rules.h"
#include "database/accounts/account_service.h"
#include "database/accounts/password_hasher.h"
#include "database/accounts/recovery_code.h"
#include "database/repositories/account_repository.h"

#include <optional>

// Login, confirmation and recovery.
namespace chiron::database {
namespace {

Refusal wrongSecret(const char* what, std::int64_t wait_ns = 0) {
    return {Refusal::Kind::wrong,
            wait_ns,
            {core::ErrorCode::notAllowed, std::string("name or ") + what + " is wrong"}};
}

Refusal mustWait(std::int64_t wait_ns) {
    const std::int64_t seconds = (wait_ns + 999'999'999) / 1'000'000'000;
    return {Refusal::Kind::mustWait,
            wait_ns,
            {core::ErrorCode::notAllowed,
             "too many wrong passwords: wait " + std::to_string(seconds) + " s before the next attempt"}};
}

tl::unexpected<Refusal> refusalOf(const core::Error& error) {
    return tl::unexpected(Refusal{Refusal::Kind::failed, 0, error});
}

// Verifies on this thread. An unknown account takes the same time as a known one.
std::optional<Refusal> check(const PasswordHasher& hasher, const LoginAttempt& attempt,
                             const std::string& secret, const char* what = "password") {
    if (attempt.wait_ns > 0) {
        return mustWait(attempt.wait_ns);
    }
    if (attempt.passwordHash.empty()) {
        (void)hasher.hash(secret);
        return wrongSecret(what);
    }
    return hasher.verify(attempt.passwordHash, secret)
               ? std::nullopt
               : std::optional(wrongSecret(what, attempt.waitIfWrong_ns));
}

} // namespace

core::Result<LoginAttempt> AccountService::begin(const std::string& name, bool recovery) {
    const auto job = [&](Connection& connection) {
        AccountRepository accounts(connection, Actor::anonymous());
        return recovery ? accounts.beginRecovery(name) : accounts.beginLogin(name);
    };
    if (m_database.isWritable()) {
        return m_database.write([&](WriteContext& writing) { return job(writing.connection()); });
    }
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return job(**reader);
}

core::Result<Actor> AccountService::finish(const LoginAttempt& attempt) {
    if (m_database.isWritable()) {
        return m_database.write([&](WriteContext& writing) {
            return AccountRepository(writing.connection(), Actor::anonymous()).finishLogin(attempt);
        });
    }
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return AccountRepository(**reader, Actor::anonymous()).finishLogin(attempt);
}

tl::expected<Actor, Refusal> AccountService::tryLogin(const std::string& name, const std::string& password) {
    const auto attempt = begin(name, false);
    if (!attempt) {
        return refusalOf(attempt.error());
    }
    const PasswordHasher hasher(m_database.options().passwordCost);
    if (auto refused = check(hasher, *attempt, password)) {
        return tl::unexpected(*refused);
    }
    const auto actor = finish(*attempt);
    if (!actor) {
        const bool disabled = actor.error().code == core::ErrorCode::notAllowed;
        return tl::unexpected(
            Refusal{disabled ? Refusal::Kind::disabled : Refusal::Kind::failed, 0, actor.error()});
    }
    return *actor;
}

core::Result<Actor> AccountService::login(const std::string& name, const std::string& password) {
    const auto actor = tryLogin(name, password);
    return actor ? core::Result<Actor>(*actor) : tl::unexpected(actor.error().error);
}

tl::expected<std::string, Refusal>
AccountService::tryRecover(const std::string& name, const std::string& code, const std::string& newPassword) {
    if (auto good = checkPassword(name, newPassword); !good) {
        return refusalOf(good.error());
    }
    const auto attempt = begin(name, true);
    if (!attempt) {
        return refusalOf(attempt.error());
    }
    const PasswordHasher hasher(m_database.options().passwordCost);
    if (auto refused = check(hasher, *attempt, code, "recovery code")) {
        return tl::unexpected(*refused);
    }
    const std::string newCode = newRecoveryCode();
    const auto passwordHash = hasher.hash(newPassword);
    const auto codeHash = hasher.hash(newCode);
    if (!passwordHash || !codeHash) {
        return refusalOf(!passwordHash ? passwordHash.error() : codeHash.error());
    }
    const auto done = m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), Actor::anonymous())
            .finishRecovery(*attempt, *passwordHash, *codeHash);
    });
    return done ? tl::expected<std::string, Refusal>(newCode) : refusalOf(done.error());
}

core::Result<std::string> AccountService::recover(const std::string& name, const std::string& code,
                                                  const std::string& newPassword) {
    const auto newCode = tryRecover(name, code, newPassword);
    return newCode ? core::Result<std::string>(*newCode) : tl::unexpected(newCode.error().error);
}

// Returns the actor's current login name. An administrator may have changed it since the login.
std::string AccountService::nameNow(const Actor& actor) {
    const auto person = self(actor);
    return person ? person->name : actor.name();
}

tl::expected<Actor, Refusal> AccountService::tryConfirm(const Actor& actor, const std::string& password) {
    auto confirmed = tryLogin(nameNow(actor), password);
    if (confirmed && confirmed->personId() != actor.personId()) {
        return tl::unexpected(wrongSecret("password")); // another person has the name by now
    }
    return confirmed;
}

core::Result<bool> AccountService::hasRecoveryCode(const Actor& actor) {
    auto reader = m_database.openReader();
    CHIRON_TRY(reader);
    return AccountRepository(**reader, actor).hasRecoveryCode(actor.personId());
}

tl::expected<std::string, Refusal> AccountService::tryMakeRecoveryCode(const Actor& actor,
                                                                       const std::string& password) {
    CHIRON_TRY(tryConfirm(actor, password));
    const std::string code = newRecoveryCode();
    const auto hash = PasswordHasher(m_database.options().passwordCost).hash(code);
    if (!hash) {
        return refusalOf(hash.error());
    }
    const auto stored = m_database.write([&](WriteContext& writing) {
        return AccountRepository(writing.connection(), actor).setRecoveryCode(actor.personId(), *hash);
    });
    return stored ? tl::expected<std::string, Refusal>(code) : refusalOf(stored.error());
}

core::Result<std::string> AccountService::makeRecoveryCode(const Actor& actor, const std::string& password) {
    const auto code = tryMakeRecoveryCode(actor, password);
    return code ? core::Result<std::string>(*code) : tl::unexpected(code.error().error);
}

core::Result<Actor> AccountService::confirm(const Actor& actor, const std::string& password) {
    const auto confirmed = tryConfirm(actor, password);
    return confirmed ? core::Result<Actor>(*confirmed) : tl::unexpected(confirmed.error().error);
}

} // namespace chiron::database
