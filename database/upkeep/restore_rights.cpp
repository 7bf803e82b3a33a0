// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/upkeep/restore_rights.h"

#include "database/access/authorise.h"
#include "database/accounts/password_hasher.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"
#include "database/upkeep/manifest.h"

#include <QFileInfo>

namespace chiron::database {
namespace {

core::Result<bool> hasAdministrator(const std::string& file) {
    auto connection = Connection::open(file, Connection::Mode::readOnly);
    CHIRON_TRY(connection);
    const auto count =
        selectInteger(**connection, "SELECT count(*) FROM person WHERE kind = 'person' AND enabled = 1 AND "
                                    "instr(',' || roles || ',', ',admin,') > 0");
    CHIRON_TRY(count);
    return count->value_or(0) > 0;
}

tl::unexpected<Refusal> refusalOf(Refusal::Kind kind, const core::Error& error, std::int64_t wait_ns = 0) {
    return tl::unexpected(Refusal{kind, wait_ns, error});
}

tl::expected<Actor, Refusal> tryRestorerIn(const std::string& file, const std::string& name,
                                           const std::string& password, const DatabaseOptions& options) {
    auto connection = Connection::open(file, Connection::Mode::readOnly);
    if (!connection) {
        return refusalOf(Refusal::Kind::failed, connection.error());
    }
    const SystemBootClock systemClock;
    (*connection)->setSite(nullptr, options.clock ? options.clock.get() : &systemClock);
    AccountRepository accounts(**connection, Actor::anonymous());
    const auto attempt = accounts.beginLogin(name);
    if (!attempt) {
        return refusalOf(Refusal::Kind::failed, attempt.error());
    }
    if (attempt->wait_ns > 0) {
        return refusalOf(Refusal::Kind::mustWait,
                         {core::ErrorCode::notAllowed, "too many wrong passwords: try again later"},
                         attempt->wait_ns);
    }
    const PasswordHasher hasher(options.passwordCost);
    if (attempt->passwordHash.empty() || !hasher.verify(attempt->passwordHash, password)) {
        return refusalOf(Refusal::Kind::wrong, {core::ErrorCode::notAllowed, "name or password is wrong"});
    }
    const auto actor = accounts.finishLogin(*attempt);
    if (!actor) {
        return refusalOf(actor.error().code == core::ErrorCode::notAllowed ? Refusal::Kind::disabled
                                                                           : Refusal::Kind::failed,
                         actor.error());
    }
    const auto scope = authorise(**connection, *actor, Action::restore);
    return scope ? tl::expected<Actor, Refusal>(*actor) : refusalOf(Refusal::Kind::failed, scope.error());
}

/// Returns the refusal of the administrator of the database that is at the target; none if there is nobody to
/// ask.
std::optional<Refusal> presentRefusal(const RestoreRequest& request, const DatabaseOptions& options) {
    if (!QFileInfo::exists(QString::fromStdString(request.targetFile))) {
        return std::nullopt;
    }
    const auto any = hasAdministrator(request.targetFile);
    if (!any || !*any) {
        return std::nullopt; // damaged, foreign or without an owner: a restore is the remedy
    }
    const bool same = request.presentName.empty();
    const auto actor = tryRestorerIn(request.targetFile, same ? request.name : request.presentName,
                                     same ? request.password : request.presentPassword, options);
    return !actor && actor.error().error.code == core::ErrorCode::notAllowed ? std::optional(actor.error())
                                                                             : std::nullopt;
}

} // namespace

core::Result<Actor> restorerIn(const std::string& file, const std::string& name, const std::string& password,
                               const DatabaseOptions& options) {
    const auto actor = tryRestorerIn(file, name, password, options);
    return actor ? core::Result<Actor>(*actor) : tl::unexpected(actor.error().error);
}

core::Result<void> presentAdministratorAgrees(const RestoreRequest& request, const DatabaseOptions& options) {
    if (const auto refusal = presentRefusal(request, options)) {
        return core::fail(
            core::ErrorCode::notAllowed,
            "the database that stands here now has administrators, and one of them must agree: " +
                refusal->error.message);
    }
    return {};
}

std::optional<RestoreRefusal> restoreRefusal(const RestoreRequest& request, const DatabaseOptions& options) {
    if (const auto refusal = presentRefusal(request, options)) {
        return RestoreRefusal{RestoreRefusal::By::present, *refusal};
    }
    const auto actor =
        tryRestorerIn(request.backupFolder + "/" + kSnapshotFile, request.name, request.password, options);
    return !actor && actor.error().error.code == core::ErrorCode::notAllowed
               ? std::optional(RestoreRefusal{RestoreRefusal::By::backup, actor.error()})
               : std::nullopt;
}

} // namespace chiron::database
