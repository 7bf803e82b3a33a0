// SPDX-License-Identifier: GPL-3.0-or-later
// Sites with a session of every exercise, as earlier versions recorded and scored them: their sessions list,
// play and score as they did, and a replay says that the laws are others now, not that somebody tampered.
#include "stored_site.h"
#include "support/looked_back.h"

#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "core/fp_environment.h"
#include "database/accounts/account_service.h"
#include "database/integrity/verifier.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "session/replayer.h"
#include "session/session_view.h"

#include <zstd.h>

#include <array>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

constexpr const char* kOldPassword = "an old password"; // guards nothing but this fixture

QByteArray unpacked(const QByteArray& packed) {
    QByteArray plain(static_cast<qsizetype>(ZSTD_getFrameContentSize(
                         packed.constData(), static_cast<std::size_t>(packed.size()))),
                     '\0');
    const std::size_t got = ZSTD_decompress(plain.data(), static_cast<std::size_t>(plain.size()),
                                            packed.constData(), static_cast<std::size_t>(packed.size()));
    return ZSTD_isError(got) || got != static_cast<std::size_t>(plain.size()) ? QByteArray() : plain;
}

/// A stored site: the name of its files, and the models id of the program that made it.
struct SiteBefore {
    const char* name;
    const char* models;
};
constexpr SiteBefore kSitesBefore[] = {{"v3_sessions", "models 1"}, {"v3_sessions_models2", "models 2"}};

core::Result<void> makeSiteBefore(const std::string& file, const char* name) {
    auto connection = Connection::create(file);
    CHIRON_TRY(connection);
    const std::string stored = std::string(kStoredSite) + name;
    auto built = (*connection)
                     ->execute(unpacked(contentOf(stored + ".sql.zst")).toStdString() +
                               "PRAGMA application_id=" + std::to_string(kApplicationId) +
                               "; PRAGMA user_version=3; PRAGMA journal_mode=WAL;");
    QDir().mkpath(QString::fromStdString(file + ".site"));
    copyTo(file + ".site/site.key", contentOf(stored + ".key"));
    copyTo(file + ".site/audit_head.json", contentOf(stored + "_audit_head.json"));
    QFile::setPermissions(QString::fromStdString(file + ".site/site.key"),
                          QFile::ReadOwner | QFile::WriteOwner);
    return built;
}

} // namespace

class TestSessionsBefore : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void verifies_data() { sites(); }
    void verifies();
    void everySessionListsPlaysAndScores_data();
    void everySessionListsPlaysAndScores();

private:
    struct Opened {
        std::unique_ptr<DatabaseFixture> site;
        std::optional<Actor> ada;
    };
    static void sites();
    std::array<Opened, std::size(kSitesBefore)> m_sites;
};

void TestSessionsBefore::initTestCase() {
    for (std::size_t i = 0; i < m_sites.size(); ++i) {
        auto& opened = m_sites[i];
        opened.site = std::make_unique<DatabaseFixture>();
        REQUIRE(makeSiteBefore(opened.site->path(), kSitesBefore[i].name));
        REQUIRE(opened.site->reopen());
        const auto ada = AccountService(*opened.site->database).login("ada", kOldPassword);
        REQUIRE(ada);
        opened.ada = *ada;
    }
}

void TestSessionsBefore::sites() {
    QTest::addColumn<int>("site");
    for (int i = 0; i < static_cast<int>(std::size(kSitesBefore)); ++i)
        QTest::newRow(kSitesBefore[i].name) << i;
}

void TestSessionsBefore::verifies() {
    QFETCH(int, site);
    const auto& opened = m_sites[static_cast<std::size_t>(site)];
    auto reader = opened.site->database->openReader();
    QCOMPARE(SessionReader(**reader, *opened.ada).listSessions()->size(), std::size_t{5});
    QVERIFY(verifyDatabase(opened.site->path(), opened.site->options).ok());
}

void TestSessionsBefore::everySessionListsPlaysAndScores_data() {
    QTest::addColumn<int>("site");
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("exercise");
    for (int site = 0; site < static_cast<int>(std::size(kSitesBefore)); ++site) {
        int id = 0;
        for (const char* exercise :
             {"sphere_apex", "urethra_insertion", "elastic_tube", "object_handling", "palpation"})
            QTest::addRow("%s, %s", kSitesBefore[site].name, exercise) << site << ++id << exercise;
    }
}

void TestSessionsBefore::everySessionListsPlaysAndScores() {
    QFETCH(int, site);
    QFETCH(int, id);
    QFETCH(QString, exercise);
    const auto& opened = m_sites[static_cast<std::size_t>(site)];
    auto connection = opened.site->database->openReader();
    REQUIRE(connection);
    auto stored = session::SessionView::open(**connection, *opened.ada, SessionId{id});
    REQUIRE(stored);
    QCOMPARE((*stored)->record().summary.exercise, exercise.toStdString());

    // Its content has the texts of its time in it: the digest is what it was, and the task is known without
    // them.
    const auto& record = (*stored)->record();
    QCOMPARE(record.contentSha256, catalogue::sha256Hex(record.setup.contentJson));
    QCOMPARE(catalogue::taskSha256(record.setup.contentJson).size(), std::size_t{64});
    QVERIFY(catalogue::taskSha256(record.setup.contentJson) != record.contentSha256);
    QByteArray reworded = QByteArray::fromStdString(record.setup.contentJson);
    QVERIFY(reworded.contains("\"title\":{"));
    reworded.replace("\"title\":{", "\"title\":{\"fr\":\"Un titre\",");
    QCOMPARE(catalogue::taskSha256(reworded.toStdString()), catalogue::taskSha256(record.setup.contentJson));

    const auto track = tests::trackOf(**stored);
    REQUIRE(track);
    QVERIFY(track->duration_s > 1.0);

    // Scored then, and scored again from the stored channels now: the same to the bit.
    const auto then = ScoreRepository(**connection, *opened.ada).scores(SessionId{id});
    const auto now = (*stored)->computeScores();
    REQUIRE(then);
    REQUIRE(now);
    QCOMPARE(now->passed, then->passed);
    QCOMPARE(now->metrics.size(), then->metrics.size());
    QVERIFY(now->metrics.size() > 10);
    for (std::size_t i = 0; i < now->metrics.size(); ++i) {
        const auto &a = now->metrics[i], &b = then->metrics[i];
        const QByteArray where = QByteArray::fromStdString(b.id);
        QCOMPARE(a.id, b.id);
        QVERIFY2(a.version == b.version && a.value == b.value && a.passed == b.passed, where.constData());
    }

    const auto replay = session::replaySession(**stored);
    REQUIRE(replay);
    const char* models = kSitesBefore[site].models;
    if (core::buildId().ends_with(models)) { // no law has changed since
        QVERIFY2(replay->identical || !replay->comparable, replay->note.c_str());
    } else {
        QVERIFY(!replay->comparable);
        QVERIFY2(replay->note.find(models) != std::string::npos, replay->note.c_str());
    }
}

QTEST_GUILESS_MAIN(TestSessionsBefore)
#include "test_sessions_before.moc"
