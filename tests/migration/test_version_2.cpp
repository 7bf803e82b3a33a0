// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_site.h"

#include "database/integrity/verifier.h"
#include "database/upkeep/manifest.h"

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// What the second version of the schema brought: a comment's moment.
class TestVersion2 : public QObject {
    Q_OBJECT
private slots:
    void commentsOfVersion1KeepTheirDigest();
    void backupOfVersion1IsRestored();
};

void TestVersion2::commentsOfVersion1KeepTheirDigest() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    REQUIRE(f.reopen());
    QCOMPARE(f.database->schemaVersion(), MigrationRunner().newest());
    QCOMPARE(
        numberIn(f.path() + ".before-v" + std::to_string(MigrationRunner().newest()), "PRAGMA user_version"),
        std::int64_t{1});
    const auto ada = AccountService(*f.database).login("ada", kPassword);
    REQUIRE(ada);
    REQUIRE(f.database->write([&](WriteContext& w) {
        return SessionRepository(w.connection(), *ada).addComment(1, "here it shook", 250);
    }));
    auto reader = f.database->openReader();
    const auto comments = SessionReader(**reader, *ada).comments(1);
    REQUIRE(comments);
    QCOMPARE(comments->size(), std::size_t{2});
    QVERIFY(!comments->front().tick && comments->back().tick == 250U);
    reader->reset();
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
    // A moment given to an old comment, or taken from a new one, shows.
    for (const char* change : {"UPDATE session_comment SET tick = 3 WHERE id = 1",
                               "UPDATE session_comment SET tick = NULL WHERE id = 2"}) {
        auto connection = Connection::open(f.path(), Connection::Mode::readWrite);
        REQUIRE((*connection)->execute("BEGIN"));
        REQUIRE((*connection)->execute(change));
        REQUIRE((*connection)->execute("COMMIT"));
        connection->reset();
        const VerifyReport report = verifyDatabase(f.path(), f.options);
        QVERIFY(!report.ok() && report.findings[0].table == "session_comment");
    }
}

void TestVersion2::backupOfVersion1IsRestored() {
    DatabaseFixture f;
    REQUIRE(makeStoredSite(f.path()));
    const auto key = SiteKey::load(f.path() + ".site");
    REQUIRE(key);
    QDir().mkpath(QString::fromStdString(f.path("backup")));
    Manifest manifest{"backup", "2026-11-20T12:30:00.000Z", 1, readHeadFile(**key)->value(), {}};
    auto old = Connection::open(f.path(), Connection::Mode::readOnly);
    REQUIRE(copyDatabase(**old, f.path("backup") + "/" + kSnapshotFile));
    old->reset();
    manifest.files[kSnapshotFile] = fileDigest(f.path("backup") + "/" + kSnapshotFile).value();
    REQUIRE(writeManifest(f.path("backup"), manifest, **key));
    const auto info = Upkeep::restore(requestFor(f, f.path("backup")), f.options);
    REQUIRE(info);
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{MigrationRunner().newest()});
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
    // Nothing of it lies about: no copy from before the step.
    QVERIFY(QDir(f.folder.path()).entryList({"*restoring*"}).isEmpty());
    REQUIRE(f.reopen());
    REQUIRE(AccountService(*f.database).login("ada", kPassword));
}

QTEST_GUILESS_MAIN(TestVersion2)
#include "test_version_2.moc"
