// SPDX-License-Identifier: GPL-3.0-or-later
// A site with a session of every exercise, as the version before this one recorded and scored it: its sessions list, play and score as they
// did, and a replay says that the laws are others now, not that somebody tampered.
#include "stored_site.h"

#include "database/accounts/account_service.h"
#include "database/integrity/verifier.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "session/playback_builder.h"
#include "session/replayer.h"
#include "session/stored_session.h"

#include <zstd.h>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

constexpr const char* kOldPassword = "an old password"; // guards nothing but this fixture

QByteArray unpacked(const QByteArray& packed) {
    QByteArray plain(static_cast<qsizetype>(ZSTD_getFrameContentSize(packed.constData(), static_cast<std::size_t>(packed.size()))), '\0');
    const std::size_t got = ZSTD_decompress(plain.data(), static_cast<std::size_t>(plain.size()), packed.constData(), static_cast<std::size_t>(packed.size()));
    return ZSTD_isError(got) || got != static_cast<std::size_t>(plain.size()) ? QByteArray() : plain;
}

core::Result<void> makeSiteBefore(const std::string& file) {
    auto connection = Connection::create(file);
    if (!connection)
        return tl::unexpected(connection.error());
    const std::string folder = kStoredSite;
    auto built = (*connection)->execute(unpacked(contentOf(folder + "v3_sessions.sql.zst")).toStdString() + "PRAGMA application_id=" +
                                        std::to_string(kApplicationId) + "; PRAGMA user_version=3; PRAGMA journal_mode=WAL;");
    QDir().mkpath(QString::fromStdString(file + ".site"));
    copyTo(file + ".site/site.key", contentOf(folder + "v3_sessions.key"));
    copyTo(file + ".site/audit_head.json", contentOf(folder + "v3_sessions_audit_head.json"));
    QFile::setPermissions(QString::fromStdString(file + ".site/site.key"), QFile::ReadOwner | QFile::WriteOwner);
    return built;
}

} // namespace

class TestSessionsBefore : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void verifies();
    void everySessionListsPlaysAndScores_data();
    void everySessionListsPlaysAndScores();

private:
    std::unique_ptr<DatabaseFixture> m_site;
    std::optional<Actor> m_ada;
};

void TestSessionsBefore::initTestCase() {
    m_site = std::make_unique<DatabaseFixture>();
    REQUIRE(makeSiteBefore(m_site->path()));
    REQUIRE(m_site->reopen());
    const auto ada = AccountService(*m_site->database).login("ada", kOldPassword);
    REQUIRE(ada);
    m_ada = *ada;
}

void TestSessionsBefore::verifies() {
    auto reader = m_site->database->openReader();
    QCOMPARE(SessionReader(**reader, *m_ada).listSessions()->size(), std::size_t{5});
    QVERIFY(verifyDatabase(m_site->path(), m_site->options).ok());
}

void TestSessionsBefore::everySessionListsPlaysAndScores_data() {
    QTest::addColumn<int>("id");
    int id = 0;
    for (const char* exercise : {"sphere_apex", "urethra_insertion", "elastic_tube", "object_handling", "palpation"})
        QTest::newRow(exercise) << ++id;
}

void TestSessionsBefore::everySessionListsPlaysAndScores() {
    QFETCH(int, id);
    auto connection = m_site->database->openReader();
    REQUIRE(connection);
    auto stored = session::StoredSession::open(**connection, *m_ada, SessionId{id});
    REQUIRE(stored);
    QCOMPARE((*stored)->record().summary.exercise, std::string(QTest::currentDataTag()));

    const auto track = session::buildPlaybackTrack(**stored);
    REQUIRE(track);
    QVERIFY(track->duration_s > 1.0);

    // Scored then, and scored again from the stored channels now: the same to the bit.
    const auto then = ScoreRepository(**connection, *m_ada).scores(SessionId{id});
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
    QVERIFY(!replay->comparable);
    QVERIFY2(replay->note.find("models 1") != std::string::npos, replay->note.c_str());
}

QTEST_GUILESS_MAIN(TestSessionsBefore)
#include "test_sessions_before.moc"
