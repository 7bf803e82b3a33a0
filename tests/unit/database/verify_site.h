// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/integrity/verifier.h"
#include "database_fixture.h"

#include <algorithm>

namespace chiron::test {

/// Whether verify told of this kind, table and (part of a) row.
inline bool has(const database::VerifyReport& report, const std::string& kind, const std::string& table,
                const std::string& row = {}) {
    return std::any_of(report.findings.begin(), report.findings.end(), [&](const database::Finding& f) {
        return f.kind == kind && f.table == table && f.row.find(row) != std::string::npos;
    });
}

/// A closed site with something in every table: three sessions (14 chunks, 12 scores), one voided and
/// commented, one person erased.
inline core::Result<void> makeSite(DatabaseFixture& f) {
    using namespace database;
    auto done = f.create();
    const auto ada = done ? f.administrator() : core::Result<Actor>(tl::unexpected(done.error()));
    if (!ada) {
        return tl::unexpected(ada.error());
    }
    const auto first = storeSession(*f.database, Actor::simulated(), 6, 9000);
    const auto second = storeSession(*f.database, *ada, 5, 5000);
    const auto third = storeSession(*f.database, Actor::simulated(), 3);
    if (!first || !second || !third) {
        return core::fail(core::ErrorCode::storage, "a session could not be stored");
    }
    done = f.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), *ada);
        auto comment = sessions.addComment(*second, "steady hand");
        return comment ? sessions.voidSession(*second, "the chair fell over")
                       : tl::unexpected(comment.error());
    });
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    if (!done || !tim) {
        return done ? core::Result<void>(tl::unexpected(tim.error())) : done;
    }
    done = AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true);
    f.database.reset(); // into one file
    return done;
}

} // namespace chiron::test
