// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "database/database.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_repository.h"
#include "desktop/sessions/session_row.h"

#include <QtGlobal>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace chiron::tests {

/// Day, hour and minute of the n-th generated session: three a day from 1 January 2026, backwards now and
/// then as clocks go.
inline std::string madeStart(int n) {
    char text[40];
    const int day = n / 3;
    std::snprintf(text, sizeof text, "2026-%02d-%02dT%02d:%02d:00.000Z", 1 + day / 28 % 12, 1 + day % 28,
                  (n * 7) % 24, (n * 13) % 60);
    return text;
}

/// The state of the n-th: mostly completed, one in seven of the others.
inline database::SessionState madeState(int n) {
    using enum database::SessionState;
    constexpr database::SessionState kRare[] = {stopped, interrupted, faulted, incomplete};
    return n % 7 == 3 ? kRare[static_cast<std::size_t>(n / 7 % 4)] : completed;
}

/// Rows as a reader would give them, newest first, without a database.
inline std::vector<desktop::SessionRow> madeRows(int count, const desktop::ExerciseTitles& titles) {
    std::vector<desktop::SessionRow> rows;
    for (int n = count - 1; n >= 0; --n) {
        database::SessionSummary s;
        s.id = n + 1;
        s.person = 2 + n % 5;
        s.personName = "person" + std::to_string(n % 5);
        s.exercise = n % 11 == 0 ? "other_exercise" : "sphere_apex";
        s.level = 1 + n % 4;
        s.state = madeState(n);
        s.startedUtc = madeStart(n);
        s.felt = n % 2 == 0;
        s.familiarisation = n % 13 == 5;
        s.archived = n % 17 == 9;
        s.ticks = static_cast<std::uint64_t>(10'000 + (n * 7919) % 50'000);
        s.frames = s.ticks;
        if (s.state == database::SessionState::completed)
            s.passed = n % 3 == 0;
        s.gates = 3;
        s.gatesMet = n % 4;
        s.comments = n % 5;
        s.reviewed = n % 5 > 2;
        s.attempt = s.familiarisation ? 0 : 1 + n % 9;
        s.operatorName = n % 6 == 2 ? "expert" : "";
        rows.push_back(desktop::makeSessionRow(std::move(s), titles));
    }
    return rows;
}

/// `count` ended sessions in a real database, in turn by these actors, without recordings. `spread`: over
/// many days, set past the digests, so that such a site neither verifies nor lets its sessions be changed.
inline void storeManySessions(database::Database& database, const std::vector<database::Actor>& actors,
                              int count, bool spread = false) {
    constexpr int kBatch = 500; // one transaction
    for (int from = 0; from < count; from += kBatch) {
        const auto done = database.write([&](database::WriteContext& writing) -> core::Result<void> {
            for (int n = from; n < std::min(count, from + kBatch); ++n) {
                const database::Actor& actor = actors[static_cast<std::size_t>(n) % actors.size()];
                database::SessionRepository sessions(writing.connection(), actor);
                database::NewSession made;
                made.exercise = "sphere_apex";
                made.level = 1 + n % 4;
                made.contentJson = "{\"level\":" + std::to_string(made.level) + "}";
                made.felt = n % 2 == 0;
                made.familiarisation = n % 13 == 5;
                made.deviceJson = made.mappingJson = made.supervisorJson = made.versionsJson = "{}";
                made.channelTable = {1};
                const auto id = sessions.beginSession(made);
                CHIRON_TRY(id);
                const auto ticks = static_cast<std::uint64_t>(10'000 + (n * 7919) % 50'000);
                if (auto ended = sessions.finishSession(*id, {madeState(n), ticks, ticks, 0, "{}"}); !ended)
                    return ended;
                scoring::ScoreCard card;
                card.metrics = {{"time", 1, "s", 1.0 + n % 60, "", n % 3 == 0}};
                card.passed = n % 3 == 0;
                CHIRON_TRY(database::ScoreRepository(writing.connection(), actor).storeScores(*id, card));
                if (!spread)
                    continue;
                if (auto moved =
                        writing.connection().execute("UPDATE session SET started_utc='" + madeStart(n) +
                                                     "' WHERE id=" + std::to_string(*id));
                    !moved)
                    return moved;
            }
            return {};
        });
        if (!done)
            qFatal("%s", done.error().message.c_str());
    }
}

} // namespace chiron::tests
