// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/query.h"
#include "database/schema/migration_runner.h"
#include "support/patience.h"

#include <QFile>
#include <QProcess>
#include <atomic>
#include <csignal>
#include <sys/resource.h>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {
class CountingSource final : public IDrainable {
public:
    core::Result<void> drain() override {
        const int count = ++calls;
        return count < failAt || count >= mendedAt ? core::Result<void>()
                                                   : core::fail(core::ErrorCode::storage, "ring is torn");
    }
    std::atomic<int> calls{0};
    int failAt = 1 << 30;
    int mendedAt = 1 << 30;
};
} // namespace

/// The writer thread and what may be stored.
class TestWriter : public QObject {
    Q_OBJECT
private slots:
    void failingJobLeavesNothing();
    void jobInsideAJobIsRefused();
    void writerDrainsSourcesAndKeepsTheirErrors();
    void maintenanceWaitsForSources();
    void checksRefuseWhatIsNoNumber();
    void textIsNeverSql();
    void fullDiskIsAnErrorAndLeavesTheFileGood();
};

void TestWriter::failingJobLeavesNothing() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto failed = f.database->write([](WriteContext& w) -> core::Result<SessionId> {
        const auto id = SessionRepository(w.connection(), Actor::simulated()).beginSession(someSession());
        return id ? core::fail(core::ErrorCode::cancelled, "changed my mind") : id;
    });
    QCOMPARE(failed.error().code, core::ErrorCode::cancelled);
    auto reader = f.database->openReader();
    QCOMPARE(selectInteger(**reader, "SELECT count(*) FROM session")->value(), std::int64_t{0});
    QCOMPARE(selectInteger(**reader, "SELECT count(*) FROM content")->value(), std::int64_t{0});
    QCOMPARE(selectInteger(**reader, "SELECT count(*) FROM audit")->value(), std::int64_t{1}); // the creation
    REQUIRE(storeSession(*f.database, Actor::simulated())); // and the writer goes on
}

void TestWriter::jobInsideAJobIsRefused() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto outer = f.database->write([&](WriteContext&) -> core::Result<void> {
        return f.database->write([](WriteContext&) -> core::Result<void> { return {}; });
    });
    QCOMPARE(outer.error().code, core::ErrorCode::wrongUse);
}

void TestWriter::writerDrainsSourcesAndKeepsTheirErrors() {
    DatabaseFixture f;
    REQUIRE(f.create());
    CountingSource good;
    CountingSource torn;
    CountingSource mended; // a disk that was full for a moment
    torn.failAt = 2;
    mended.failAt = 2;
    mended.mendedAt = 3;
    f.database->writer().addSource(good);
    f.database->writer().addSource(torn);
    f.database->writer().addSource(mended);
    QTRY_VERIFY_WITH_TIMEOUT(good.calls >= 3, kPatience_ms); // by itself, without any job
    QTRY_VERIFY_WITH_TIMEOUT(torn.calls >= 3, kPatience_ms); // asked again after an error
    QTRY_VERIFY_WITH_TIMEOUT(mended.calls >= 3, kPatience_ms);
    REQUIRE(f.database->writer().removeSource(mended));
    const int before = good.calls;
    QCOMPARE(f.database->writer().flush().error().code, core::ErrorCode::storage);
    QVERIFY(good.calls > before);
    QCOMPARE(f.database->writer().removeSource(torn).error().message, std::string("ring is torn"));
    REQUIRE(f.database->writer().removeSource(good));
    QVERIFY(!f.database->writer().removeSource(good));
}

void TestWriter::maintenanceWaitsForSources() {
    DatabaseFixture f;
    REQUIRE(f.create());
    CountingSource source;
    const auto vacuum = [](WriteContext& w) { return w.connection().execute("VACUUM"); };
    f.database->writer().addSource(source);
    QCOMPARE(f.database->writer().runMaintenance(vacuum).error().code, core::ErrorCode::wrongUse);
    REQUIRE(f.database->writer().removeSource(source));
    REQUIRE(f.database->writer().runMaintenance(vacuum));
}

void TestWriter::checksRefuseWhatIsNoNumber() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity, -1.0}) {
        NewSession session = someSession();
        session.forceLimit_N = bad;
        const auto began = f.database->write([&](WriteContext& w) {
            return SessionRepository(w.connection(), Actor::simulated()).beginSession(session);
        });
        QCOMPARE(began.error().code, core::ErrorCode::badInput);
    }
    const auto id = storeSession(*f.database, Actor::simulated());
    REQUIRE(id);
    for (const char* sql :
         {"UPDATE session SET force_limit_n = 9e999", "UPDATE session SET force_limit_n = NULL",
          "UPDATE session SET felt = 2", "UPDATE session SET level = 'two'",
          "UPDATE second_summary SET impulse_ns = 9e999", "UPDATE chunk SET frames = 0",
          "DELETE FROM session", "DELETE FROM chunk", "UPDATE score SET value = 1.0", "DELETE FROM audit",
          "UPDATE session SET person_id = 99"}) {
        const auto refused = f.database->write([&](WriteContext& w) { return w.connection().execute(sql); });
        QVERIFY2(!refused, sql);
    }
    scoring::ScoreCard card = someCard();
    card.metrics[0].value = nan;
    const auto scored = f.database->write([&](WriteContext& w) {
        return ScoreRepository(w.connection(), Actor::simulated()).storeScores(*id, card);
    });
    QCOMPARE(scored.error().code, core::ErrorCode::badInput);
}

void TestWriter::textIsNeverSql() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto admin = f.administrator("Robert'); DROP TABLE person;--");
    REQUIRE(admin);
    QCOMPARE(admin->name(), std::string("Robert'); DROP TABLE person;--"));
    for (const char* name : {"\" OR 1=1 --", "日本 太郎", "Åsa Öberg", "ひらがな😀", "a%_b", "$(reboot)"}) {
        const auto person = f.person(*admin, name, {Role::trainee});
        QVERIFY2(person.has_value(), name);
        QCOMPARE(person->name(), std::string(name));
    }
    QCOMPARE(AccountService(*f.database).listPeople(*admin)->size(), std::size_t{7});
    AccountService accounts(*f.database);
    for (const std::string& bad :
         {std::string("\xff\xfe"), std::string("a\0b", 3), std::string("\xef\xbb\xbfx"),
          std::string("two\nlines"), std::string(" x"), std::string(), std::string(65, 'n'),
          std::string("Simulated"), std::string("erased-7"), std::string("a,b")}) {
        const auto made = accounts.createPerson(*admin, {bad, "", {Role::trainee}, kPassword, false});
        QCOMPARE(made.error().code, core::ErrorCode::badInput);
    }
    // The same name in another case or composition is the same person.
    QCOMPARE(accounts.createPerson(*admin, {"åSA ÖBERG", "", {Role::trainee}, kPassword, false}).error().code,
             core::ErrorCode::badInput);
    QCOMPARE(accounts
                 .createPerson(*admin, {"A\xcc\x8asa O\xcc\x88"
                                        "berg",
                                        "",
                                        {Role::trainee},
                                        kPassword,
                                        false})
                 .error()
                 .code,
             core::ErrorCode::badInput);
}

void TestWriter::fullDiskIsAnErrorAndLeavesTheFileGood() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(storeSession(*f.database, Actor::simulated()));
    // No file of this process may grow beyond what the log has now and a little: writes then fail as on a
    // full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &old), 0);
    rlimit small = old;
    small.rlim_cur = static_cast<rlim_t>(QFileInfo(QString::fromStdString(f.path() + "-wal")).size() + 20000);
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    core::Result<SessionId> stored = 0;
    for (int i = 0; i < 50 && stored; ++i) {
        stored = storeSession(*f.database, Actor::simulated(), 20);
    }
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &old), 0);
    QVERIFY(!stored);
    QCOMPARE(stored.error().code, core::ErrorCode::storage);
    auto reader = f.database->openReader();
    REQUIRE(reader);
    QCOMPARE(selectText(**reader, "PRAGMA integrity_check")->value(), std::string("ok"));
    const auto whole =
        selectInteger(**reader, "SELECT count(*) FROM session WHERE chunks <> (SELECT count(*) FROM chunk "
                                "WHERE session_id = session.id)");
    QCOMPARE(whole->value(), std::int64_t{0}); // no session is half there
    reader->reset();
    REQUIRE(storeSession(*f.database, Actor::simulated(), 20)); // room again: goes on
}

QTEST_GUILESS_MAIN(TestWriter)
#include "test_writer.moc"
