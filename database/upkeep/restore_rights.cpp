// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/upkeep/restore_rights.h"

#include "database/access/authorise.h"
#include "database/accounts/password_hasher.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"

#include <QFileInfo>

namespace chiron::database {
namespace {

core::Result<bool> hasAdministrator(const std::string& file) {
    auto connection = Connection::open(file, Connection::Mode::readOnly);
    const auto count =
        connection ? selectInteger(**connection,
                                   "SELECT count(*) FROM person WHERE kind = 'person' AND enabled = 1 AND "
                                   "instr(',' || roles || ',', ',admin,') > 0")
                   : tl::unexpected(connection.error());
    return count ? core::Result<bool>(count->value_or(0) > 0) : tl::unexpected(count.error());
}

} // namespace

core::Result<Actor> restorerIn(const std::string& file, const std::string& name, const std::string& password,
                               const DatabaseOptions& options) {
    auto connection = Connection::open(file, Connection::Mode::readOnly);
    if (!connection) {
        return tl::unexpected(connection.error());
    }
    const SystemBootClock systemClock;
    (*connection)->setSite(nullptr, options.clock ? options.clock.get() : &systemClock);
    AccountRepository accounts(**connection, Actor::anonymous());
    const auto attempt = accounts.beginLogin(name);
    if (!attempt) {
        return tl::unexpected(attempt.error());
    }
    if (attempt->wait_ns > 0) {
        return core::fail(core::ErrorCode::notAllowed, "too many wrong passwords: try again later");
    }
    const PasswordHasher hasher(options.passwordCost);
    if (attempt->passwordHash.empty() || !hasher.verify(attempt->passwordHash, password)) {
        return core::fail(core::ErrorCode::notAllowed, "name or password is wrong");
    }
    const auto actor = accounts.finishLogin(*attempt);
    if (!actor) {
        return actor;
    }
    const auto scope = authorise(**connection, *actor, Action::restore);
    return scope ? actor : core::Result<Actor>(tl::unexpected(scope.error()));
}

core::Result<void> presentAdministratorAgrees(const RestoreRequest& request, const DatabaseOptions& options) {
    if (!QFileInfo::exists(QString::fromStdString(request.targetFile))) {
        return {};
    }
    const auto any = hasAdministrator(request.targetFile);
    if (!any || !*any) {
        return {}; // damaged, foreign or nobody's: a restore is what helps
    }
    const bool same = request.presentName.empty();
    const auto actor = restorerIn(request.targetFile, same ? request.name : request.presentName,
                                  same ? request.password : request.presentPassword, options);
    if (!actor && actor.error().code == core::ErrorCode::notAllowed) {
        return core::fail(
            core::ErrorCode::notAllowed,
            "the database that stands here now has administrators, and one of them must agree: " +
                actor.error().message);
    }
    return {};
}

} // namespace chiron::database
