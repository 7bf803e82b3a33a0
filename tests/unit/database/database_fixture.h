// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/account_service.h"
#include "database/database.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "database/repositories/session_repository.h"
#include "database/upkeep/upkeep.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <cstdint>
#include <memory>
#include <string>

namespace chiron::test {

/// Fails the test with the error's own words.
#define REQUIRE(result)                                                                                      \
    do {                                                                                                     \
        const auto& required_ = (result);                                                                    \
        QVERIFY2(required_.has_value(), required_ ? "" : required_.error().message.c_str());                 \
    } while (false)

/// Only whether it worked.
template <class T> core::Result<void> drop(const core::Result<T>& result) {
    return result ? core::Result<void>() : core::Result<void>(tl::unexpected(result.error()));
}

/// A clock that the test moves.
class ManualBootClock final : public database::IBootClock {
public:
    database::BootTime now() const override { return time; }
    database::BootTime time{"boot-a", 1'000'000'000};
    void advance_s(std::int64_t seconds) { time.now_ns += seconds * 1'000'000'000; }
};

inline constexpr const char* kPassword = "correct horse 9";

/// A folder with a database in it, at the cheapest password cost.
class DatabaseFixture {
public:
    DatabaseFixture() {
        clock = std::make_shared<ManualBootClock>();
        options.passwordCost = database::PasswordCost::minimalForTests();
        options.clock = clock;
    }
    std::string path(const std::string& name = "site.db") const {
        return folder.path().toStdString() + "/" + name;
    }

    core::Result<void> create() {
        auto made = database::Database::create(path(), options);
        CHIRON_TRY(made);
        database = *std::move(made);
        return {};
    }
    core::Result<void> reopen() {
        database.reset();
        auto opened = database::Database::openForWriting(path(), options);
        CHIRON_TRY(opened);
        database = *std::move(opened);
        return {};
    }
    core::Result<database::Actor> administrator(const std::string& name = "ada") {
        database::AccountService accounts(*database);
        CHIRON_TRY(accounts.createFirstAdministrator(name, kPassword));
        return accounts.login(name, kPassword);
    }
    core::Result<database::Actor> person(const database::Actor& by, const std::string& name,
                                         database::RoleSet roles) {
        database::AccountService accounts(*database);
        if (auto made = accounts.createPerson(by, {name, name + " display", roles, kPassword, false});
            !made) {
            return tl::unexpected(made.error());
        }
        return accounts.login(name, kPassword);
    }

    QTemporaryDir folder;
    database::DatabaseOptions options;
    std::shared_ptr<ManualBootClock> clock;
    std::unique_ptr<database::Database> database;
};

inline database::NewSession someSession() {
    database::NewSession session;
    session.exercise = "sphere_apex";
    session.level = 2;
    session.contentJson = R"({"K_N_per_m":1000,"level":2})";
    session.seed = 0xfedcba9876543210ULL;
    session.operatorName = "novice";
    session.felt = true;
    session.deviceJson = R"({"driver":"simulated"})";
    session.mappingJson = R"({"scale":1})";
    session.supervisorJson = R"({"cap_N":4})";
    session.versionsJson = R"({"models":"1"})";
    session.buildId = "build";
    session.cpuClass = "cpu";
    session.forceLimit_N = 4.0;
    session.plannedTrials = 10;
    session.ringFile = "/run/ring";
    session.channelTable = {1, 2, 3};
    return session;
}

inline recording::Chunk someChunk(std::uint32_t sequence, std::size_t bytes = 700) {
    recording::Chunk chunk;
    chunk.sequence = sequence;
    chunk.firstTick = sequence * 250ULL;
    chunk.frames = 250;
    for (std::size_t i = 0; i < bytes; ++i) {
        chunk.payload.push_back(static_cast<std::uint8_t>((i * 31 + sequence * 7) ^ (i >> 3)));
    }
    chunk.payloadDigest.fill(static_cast<std::uint8_t>(sequence + 1));
    chunk.forceHash.fill(static_cast<std::uint8_t>(sequence + 101));
    return chunk;
}

inline scoring::ScoreCard someCard() {
    scoring::ScoreCard card;
    card.metrics = {{"path_length", 1, "m", 0.1 + 0.2, "", true},
                    {"sparc", 2, "", std::nullopt, "too short", std::nullopt}};
    card.trials = {{{"path_length", 1, "m", 0.1, "", std::nullopt}},
                   {{"path_length", 1, "m", 1e-300, "", std::nullopt}}};
    card.passed = true;
    return card;
}

/// A whole session of the actor: chunks, summaries, trials, events, end, scores.
inline core::Result<database::SessionId> storeSession(database::Database& database,
                                                      const database::Actor& actor, std::uint32_t chunks = 4,
                                                      std::size_t chunkBytes = 700,
                                                      const database::NewSession& setup = someSession()) {
    using namespace database;
    auto id = database.write([&](WriteContext& w) -> core::Result<SessionId> {
        SessionRepository sessions(w.connection(), actor);
        const auto session = sessions.beginSession(setup);
        if (!session) {
            return session;
        }
        auto sink = sessions.openSink(*session);
        CHIRON_TRY(sink);
        for (std::uint32_t i = 0; i < chunks; ++i) {
            const recording::Chunk chunk = someChunk(i, chunkBytes);
            const recording::SecondSummary second{i, 0, 250, 0.01, 1.5, 0.5, 0.25, 0.0, 3};
            CHIRON_TRY((*sink)->write({&chunk, 1}, {&second, 1}));
        }
        TrialRecord trial;
        trial.lastTick = 999;
        trial.sceneJson = R"({"R_m":0.02})";
        const EventRecord event{17, 0.017, 0, "marked", "{}"};
        auto done = sessions.storeTrial(*session, trial);
        done = done ? sessions.storeEvents(*session, {&event, 1}) : done;
        done = done ? sessions.finishSession(*session, {SessionState::completed, 1000, 1000, 0, "{}"}) : done;
        return done ? session : core::Result<SessionId>(tl::unexpected(done.error()));
    });
    if (!id) {
        return id;
    }
    const auto scored = database.write(
        [&](WriteContext& w) { return ScoreRepository(w.connection(), actor).storeScores(*id, someCard()); });
    return scored ? id : core::Result<SessionId>(tl::unexpected(scored.error()));
}

/// Restores over the fixture's database as its administrator.
inline database::RestoreRequest requestFor(const DatabaseFixture& f, const std::string& folder) {
    return {folder, f.path(), "ada", kPassword, ""};
}

/// The bytes of a file; empty if it cannot be read.
inline QByteArray contentOf(const std::string& name) {
    QFile file(QString::fromStdString(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace chiron::test
