// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/access/action.h"
#include "database_fixture.h"

#include <functional>
#include <map>

namespace chiron::test {

/// Whose thing a call touches.
enum class Touches {
    nothing,
    person,
    running,
    ended,
    draft,       ///< a study
    frozen,      ///< a study
    enrolled,    ///< a participant without consent
    ready,       ///< with consent
    participant, ///< with an open run
    withdrawn,   ///< a person's, not a simulated one
    keys,        ///< a frozen study, whose key table is a person's
    run,         ///< open
};

/// How a repository function is called by the test of the access table.
struct Call {
    Touches touches;
    bool inJob; ///< on the writer's connection, undone afterwards
    std::function<core::Result<void>(database::Connection&, const database::Actor&, std::int64_t target)> run;
};

/// What the calls need besides actor and target.
struct CallWorld {
    DatabaseFixture fixture;
    database::PersonId eve = 0; ///< a trainee without sessions
    std::string backup;         ///< folder of a backup to restore
    int folders = 0;            ///< backups and exports made so far
};

/// A real call of every function of the repositories, by action. The world outlives the map.
std::map<database::Action, Call> accessCalls(CallWorld& m);
/// Those of studies.
std::map<database::Action, Call> studyCalls();

} // namespace chiron::test
