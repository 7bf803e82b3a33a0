// SPDX-License-Identifier: GPL-3.0-or-later
// What the start of a program does with what an earlier one left behind, case by case.
#include "database/repositories/score_repository.h"
#include "database/repositories/session_repository.h"
#include "recording/crash_ring.h"
#include "session/channels.h"
#include "session/integrity_check.h"
#include "session/live_recording.h"
#include "session/recovery.h"
#include "support/session_fixture.h"

#include <QDir>
#include <QFile>
#include <QtTest>

using namespace chiron;
using tests::SessionFixture;

namespace {

constexpr std::uint64_t kFrames = 700;

session::SessionSetup setupOf(const session::TrainingRequest& request) {
    session::SessionSetup setup;
    setup.level = request.level;
    setup.seed = request.seed;
    setup.devices = {request.station.tools.front().device->descriptor()};
    setup.mappings = request.station.mappings();
    setup.safety = session::headlessSafety(request.level);
    return setup;
}

/// Begins a session, records so many frames, and leaves it as a program does that is killed.
database::SessionId leaveBehind(SessionFixture& site, const QString& folder, std::uint64_t frames) {
    const session::SessionSetup setup = setupOf(site.request(tests::shortLevel(2, 1, 5.0), "novice", 3));
    database::NewSession columns = session::toNewSession(setup);
    columns.channelTable = session::channelTableFor(setup)->encode();
    columns.ringFile = folder.toStdString();
    const database::Actor actor = database::Actor::simulated();
    const auto id = site.database->write([&](database::WriteContext& context) {
        return database::SessionRepository(context.connection(), actor).beginSession(columns);
    });
    auto live = session::LiveRecording::start(*site.database, actor, *id, setup, folder.toStdString(), true);
    core::HapticFrame frame;
    frame.tools = 1;
    for (; frame.header.index < frames; ++frame.header.index) {
        frame.tool[0].deviceTime_us = frame.header.index * 1000;
        (*live)->sink().tryPush(frame);
    }
    return *id;
}

QStringList rings(const QTemporaryDir& folder) {
    return QDir(folder.path()).entryList(QDir::Files);
}

core::Result<std::vector<session::RecoveredSession>> recover(SessionFixture& site,
                                                             const QTemporaryDir& folder) {
    return session::recoverSessions(*site.database, folder.path().toStdString());
}

} // namespace

class TestRecovery : public QObject {
    Q_OBJECT
private slots:
    void nothingToDo();
    void ringFramesAreStored();
    void sessionWithoutARing();
    void ringInItsOwnFolder();
    void ringOfAnEndedSessionGoes();
    void ringOfAnUnknownSessionStays();
    void halfMadeRingGoes();
    void unreadableRingIsNotThrownAway();
};

void TestRecovery::nothingToDo() {
    SessionFixture site;
    const QTemporaryDir folder;
    const auto recovered = recover(site, folder);
    QVERIFY(recovered && recovered->empty());
}

void TestRecovery::ringFramesAreStored() {
    SessionFixture site;
    const QTemporaryDir folder;
    const auto id = leaveBehind(site, folder.path(), kFrames);
    const auto recovered = recover(site, folder);
    QVERIFY2(recovered, recovered ? "" : recovered.error().message.c_str());
    QCOMPARE(recovered->size(), std::size_t{1});
    QCOMPARE(recovered->front().session, id);
    QCOMPARE(recovered->front().frames, kFrames);
    QVERIFY(rings(folder).isEmpty());
    tests::OpenStored stored(*site.database, id);
    QCOMPARE(stored.session->record().summary.state, database::SessionState::interrupted);
    QCOMPARE(stored.session->reader().allFrames()->size(), std::size_t{kFrames});
    QVERIFY(database::ScoreRepository(*stored.connection, database::Actor::simulated()).scores(id));
    QVERIFY(recover(site, folder)->empty());
    QVERIFY(session::verifyEverything(site.file()).ok());
}

// Killed before its first frame, or after the machine was restarted: memory is empty then.
void TestRecovery::sessionWithoutARing() {
    SessionFixture site;
    const QTemporaryDir folder;
    const auto empty = leaveBehind(site, folder.path(), 0);
    const auto lost = leaveBehind(site, folder.path(), kFrames);
    for (const QString& name : rings(folder))
        QVERIFY(QFile::remove(folder.filePath(name)));
    const auto recovered = recover(site, folder);
    QVERIFY2(recovered, recovered ? "" : recovered.error().message.c_str());
    QCOMPARE(recovered->size(), std::size_t{2});
    QCOMPARE(recovered->front().session, empty);
    QCOMPARE(recovered->front().frames, std::uint64_t{0});
    QCOMPARE(recovered->back().session, lost);
    QCOMPARE(recovered->back().framesFromRing, std::uint64_t{0});
    QVERIFY(session::verifyEverything(site.file()).ok());
}

void TestRecovery::ringInItsOwnFolder() {
    SessionFixture site;
    const QTemporaryDir then;
    const QTemporaryDir now; // another login, another runtime folder
    leaveBehind(site, then.path(), kFrames);
    const auto recovered = recover(site, now);
    QVERIFY2(recovered, recovered ? "" : recovered.error().message.c_str());
    QCOMPARE(recovered->front().frames, kFrames);
    QVERIFY(rings(then).isEmpty());
}

void TestRecovery::ringOfAnEndedSessionGoes() {
    SessionFixture site;
    const QTemporaryDir folder;
    leaveBehind(site, folder.path(), kFrames);
    const QString ring = folder.filePath(rings(folder).front());
    const QString kept = ring + ".kept";
    QVERIFY(QFile::copy(ring, kept));
    QVERIFY(recover(site, folder));
    QVERIFY(QFile::rename(kept, ring)); // as if the program had died just before removing it
    const auto again = recover(site, folder);
    QVERIFY(again && again->empty());
    QVERIFY(rings(folder).isEmpty());
    QVERIFY(session::verifyEverything(site.file()).ok());
}

void TestRecovery::ringOfAnUnknownSessionStays() {
    SessionFixture site;
    const QTemporaryDir folder;
    auto ring = recording::CrashRing::create({.folder = folder.path().toStdString(),
                                              .database = *session::ringIdOf(*site.database),
                                              .session = 4711});
    QVERIFY2(ring, ring ? "" : ring.error().message.c_str());
    ring->reset(); // its program is gone
    QVERIFY(recover(site, folder)->empty());
    QCOMPARE(rings(folder).size(), 1);
}

void TestRecovery::halfMadeRingGoes() {
    SessionFixture site;
    const QTemporaryDir folder;
    leaveBehind(site, folder.path(), 10);
    const QString ring = folder.filePath(rings(folder).front());
    QVERIFY(QFile::rename(ring, ring + ".part"));
    const auto recovered = recover(site, folder);
    QVERIFY(recovered && recovered->size() == 1);
    QVERIFY(rings(folder).isEmpty());
}

void TestRecovery::unreadableRingIsNotThrownAway() {
    SessionFixture site;
    const QTemporaryDir folder;
    const auto id = leaveBehind(site, folder.path(), kFrames);
    const QString ring = folder.filePath(rings(folder).front());
    QFile file(ring);
    QVERIFY(file.open(QIODevice::ReadWrite) && file.putChar('x'));
    file.close();
    const auto recovered = recover(site, folder);
    QVERIFY(recovered && recovered->size() == 1); // the site opens all the same, and says what is wrong
    QVERIFY2(recovered->front().problem.find(ring.toStdString()) != std::string::npos,
             recovered->front().problem.c_str());
    QVERIFY(QFile::exists(ring));
    tests::OpenStored stored(*site.database, id);
    QCOMPARE(stored.session->record().summary.state,
             database::SessionState::interrupted); // what was committed is kept
}

QTEST_GUILESS_MAIN(TestRecovery)
#include "test_recovery.moc"
