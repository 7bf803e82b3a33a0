// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_site.h"

#include "database/integrity/verifier.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "database/upkeep/manifest.h"

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

// The stored site as version 2 has it.
core::Result<void> makeVersion2(const std::string& file) {
    if (auto made = makeStoredSite(file); !made) {
        return made;
    }
    auto steps = builtInMigrations();
    steps.resize(2);
    auto connection = Connection::open(file, Connection::Mode::readWrite);
    const auto migrated =
        connection ? MigrationRunner(steps).migrate(**connection) : tl::unexpected(connection.error());
    return migrated ? core::Result<void>() : tl::unexpected(migrated.error());
}

} // namespace

/// What the third version of the schema brought: studies.
class TestVersion3 : public QObject {
    Q_OBJECT
private slots:
    void version2VerifiesAndOpens();
    void backupOfVersion2IsRestored();
    void tablesCannotBePassedOver();
};

void TestVersion3::version2VerifiesAndOpens() {
    DatabaseFixture f;
    REQUIRE(makeVersion2(f.path()));
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{2});
    QVERIFY(verifyDatabase(f.path(), f.options).ok()); // as it is, without the tables of studies
    REQUIRE(f.reopen());
    QCOMPARE(f.database->schemaVersion(), MigrationRunner().newest());
    QCOMPARE(
        numberIn(f.path() + ".before-v" + std::to_string(MigrationRunner().newest()), "PRAGMA user_version"),
        std::int64_t{2});
    const auto ada = AccountService(*f.database).login("ada", kPassword);
    REQUIRE(ada);
    REQUIRE(f.database->write([&](WriteContext& w) {
        return StudyRepository(w.connection(), *ada).createStudy("first", "First", "{}");
    }));
    auto reader = f.database->openReader();
    QCOMPARE(StudyReader(**reader, *ada).listStudies()->size(), std::size_t{1});
    reader->reset();
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestVersion3::backupOfVersion2IsRestored() {
    DatabaseFixture f;
    REQUIRE(makeVersion2(f.path()));
    const auto key = SiteKey::load(f.path() + ".site");
    REQUIRE(key);
    QDir().mkpath(QString::fromStdString(f.path("backup")));
    Manifest manifest{"backup", "2026-11-21T12:30:00.000Z", 2, readHeadFile(**key)->value(), {}};
    auto old = Connection::open(f.path(), Connection::Mode::readOnly);
    REQUIRE(copyDatabase(**old, f.path("backup") + "/" + kSnapshotFile));
    old->reset();
    manifest.files[kSnapshotFile] = fileDigest(f.path("backup") + "/" + kSnapshotFile).value();
    REQUIRE(writeManifest(f.path("backup"), manifest, **key));
    REQUIRE(Upkeep::restore(requestFor(f, f.path("backup")), f.options));
    QCOMPARE(numberIn(f.path(), "PRAGMA user_version"), std::int64_t{MigrationRunner().newest()});
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestVersion3::tablesCannotBePassedOver() {
    // A lower number in the file's header does not keep verify from the studies.
    DatabaseFixture f;
    REQUIRE(makeVersion2(f.path()));
    REQUIRE(f.reopen());
    const auto ada = AccountService(*f.database).login("ada", kPassword);
    REQUIRE(f.database->write([&](WriteContext& w) {
        return StudyRepository(w.connection(), *ada).createStudy("first", "First", "{}");
    }));
    f.database.reset();
    auto connection = Connection::open(f.path(), Connection::Mode::readWrite);
    REQUIRE((*connection)->execute("UPDATE study SET title = 'other'; PRAGMA user_version=2"));
    connection->reset();
    const VerifyReport report = verifyDatabase(f.path(), f.options);
    QVERIFY(!report.ok() && report.findings[0].table == "study");
}

QTEST_GUILESS_MAIN(TestVersion3)
#include "test_version_3.moc"
