// SPDX-License-Identifier: GPL-3.0-or-later
// A session that runs out of room half-way, or finds none: a clear Error, nothing half-done, nothing lost
// that was there.
#include "session/integrity_check.h"
#include "session/recovery.h"
#include "session/replayer.h"
#include "short_of_space.h"
#include "support/session_fixture.h"

#include <QDir>
#include <QFileInfo>
#include <QtTest>
#include <functional>

using namespace chiron;
using tests::SessionFixture;
using tests::shortLevel;

namespace {

constexpr std::uint64_t kRoomEndsAt_frames = 3000;

/// Makes the disk full at one frame, and counts.
class Disaster final : public core::IFrameSink {
public:
    explicit Disaster(std::function<void()> strike) : m_strike(std::move(strike)) {}
    bool tryPush(const core::HapticFrame&) noexcept override {
        if (++m_frames == kRoomEndsAt_frames)
            m_strike();
        return true;
    }
    std::uint64_t frames() const { return m_frames; }

private:
    std::function<void()> m_strike;
    std::uint64_t m_frames = 0;
};

database::SessionSummary onlySession(database::Database& database) {
    auto connection = database.openReader();
    auto listed = database::SessionReader(**connection, database::Actor::anonymous()).listSessions();
    return listed && listed->size() == 1 ? listed->front() : database::SessionSummary{};
}

QStringList ringFiles(const QString& folder) {
    return QDir(folder).entryList({"*.ring", "*.part"}, QDir::Files);
}

/// After the room came back: what had been recorded is there, whole, and can be re-simulated.
void checkRecovered(SessionFixture& site, const QString& rings, std::uint64_t produced) {
    auto recovered = session::recoverSessions(*site.database, rings.toStdString());
    QVERIFY2(recovered, recovered ? "" : recovered.error().message.c_str());
    QCOMPARE(recovered->size(), std::size_t{1});
    const database::SessionSummary summary = onlySession(*site.database);
    QCOMPARE(summary.state, database::SessionState::interrupted);
    QVERIFY2(summary.dropped > 0, "the session was longer than the ring: the rest is known to be lost");
    QCOMPARE(summary.frames + summary.dropped, produced);
    QVERIFY(summary.frames >= kRoomEndsAt_frames);
    tests::OpenStored stored(*site.database, summary.id);
    auto replay = session::replaySession(*stored.session);
    QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
    QVERIFY(replay->identical);
    QCOMPARE(replay->frames, summary.frames);
    QVERIFY(ringFiles(rings).isEmpty());
    const auto report = session::verifyEverything(site.file());
    QVERIFY2(report.ok(), report.ok() ? "" : report.findings.front().detail.c_str());
}

} // namespace

class TestHalfWay : public QObject {
    Q_OBJECT
private slots:
    void diskFullDuringASession_data();
    void diskFullDuringASession();
    void noRoomForTheRing_data();
    void noRoomForTheRing();

private:
    void reopen(SessionFixture& site);
};

void TestHalfWay::reopen(SessionFixture& site) {
    site.database.reset();
    auto again = database::Database::openForWriting(site.file());
    QVERIFY2(again, again ? "" : again.error().message.c_str());
    site.database = std::move(*again);
}

void TestHalfWay::diskFullDuringASession_data() {
    QTest::addColumn<bool>("fileSystem");
    QTest::newRow("files may not grow") << false;
    QTest::newRow("file system full") << true;
}

void TestHalfWay::diskFullDuringASession() {
    QFETCH(bool, fileSystem);
    TinyFileSystem disk(fileSystem ? 8192 : 64);
    if (!disk.isMounted() && fileSystem)
        QSKIP("mounting a file system is not permitted here");
    const QByteArray usual = qgetenv("TMPDIR");
    if (fileSystem)
        qputenv("TMPDIR", disk.path().toLocal8Bit());
    SessionFixture site;
    if (usual.isEmpty())
        qunsetenv("TMPDIR");
    else
        qputenv("TMPDIR", usual);
    const QTemporaryDir rings; // memory that is not full
    std::unique_ptr<FileSizeLimit> limit;
    Disaster disaster([&] {
        if (fileSystem)
            disk.fill();
        else
            limit = std::make_unique<FileSizeLimit>(
                QFileInfo(QString::fromStdString(site.file()) + "-wal").size());
    });
    session::TrainingRequest request = site.request(shortLevel(2, 2, 20.0), "novice", 12);
    request.ringFolder = rings.path().toStdString();
    request.witness = &disaster;
    auto result = site.run(std::move(request));
    QVERIFY2(disaster.frames() > kRoomEndsAt_frames + 4096, "the session must outlast the ring");
    QVERIFY(!result);
    QCOMPARE(result.error().code, core::ErrorCode::storage);
    QVERIFY2(result.error().message.find(site.file()) != std::string::npos, result.error().message.c_str());
    qInfo("%s", result.error().message.c_str());
    QCOMPARE(onlySession(*site.database).state, database::SessionState::running); // to be recovered
    QCOMPARE(ringFiles(rings.path()).size(), 1);
    limit.reset();
    disk.empty();
    QVERIFY(session::verifyEverything(site.file()).ok()); // nothing half-done before anybody repairs it
    reopen(site);
    checkRecovered(site, rings.path(), disaster.frames());
    // And the site goes on as if nothing had been.
    auto next = site.run(site.request(shortLevel(2, 1, 2.0), "novice", 13));
    QVERIFY2(next, next ? "" : next.error().message.c_str());
    site.database.reset(); // before its file system goes
}

void TestHalfWay::noRoomForTheRing_data() {
    diskFullDuringASession_data();
}

void TestHalfWay::noRoomForTheRing() {
    QFETCH(bool, fileSystem);
    const TinyFileSystem memory(512);
    if (!memory.isMounted() && fileSystem)
        QSKIP("mounting a file system is not permitted here");
    const QTemporaryDir plain;
    const QString rings = fileSystem ? memory.path() : plain.path();
    SessionFixture site;
    std::unique_ptr<FileSizeLimit> limit;
    if (!fileSystem)
        limit = std::make_unique<FileSizeLimit>(1 << 20); // enough for the database, too little for a ring
    session::TrainingRequest request = site.request(shortLevel(2, 1, 2.0), "novice", 14);
    request.ringFolder = rings.toStdString();
    auto result = site.run(std::move(request));
    QVERIFY(!result);
    QCOMPARE(result.error().code, core::ErrorCode::storage);
    QVERIFY2(result.error().message.find(rings.toStdString()) != std::string::npos,
             result.error().message.c_str());
    QVERIFY(ringFiles(rings).isEmpty());
    const database::SessionSummary refused = onlySession(*site.database);
    QCOMPARE(refused.state, database::SessionState::faulted);
    QCOMPARE(refused.frames, std::uint64_t{0});
    limit.reset();
    reopen(site);
    auto recovered = session::recoverSessions(*site.database, rings.toStdString());
    QVERIFY(recovered && recovered->empty());
    QVERIFY(session::verifyEverything(site.file()).ok());
    auto next = site.run(site.request(shortLevel(2, 1, 2.0), "novice", 14));
    QVERIFY2(next, next ? "" : next.error().message.c_str());
}

QTEST_GUILESS_MAIN(TestHalfWay)
#include "test_half_way.moc"
