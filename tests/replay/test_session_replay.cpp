// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_device.h"
#include "mechanisms/scripted_motion.h"
#include "session/integrity_check.h"
#include "session/replayer.h"
#include "support/session_fixture.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QtTest>

using namespace chiron;
using tests::OpenStored;
using tests::SessionFixture;
using tests::shortLevel;

namespace {

/// A second hand that moves over the plane without looking or feeling.
void addSecondTool(session::Station& station) {
    devices::SimulatedDevice::Configuration configuration;
    configuration.seed = 77;
    auto device = devices::SimulatedDevice::create(
        configuration, std::make_unique<mechanisms::ScriptedMotion>(
                           core::Vec3(0.0, 0.0, 0.01), std::vector<mechanisms::ScriptedMotion::Term>{
                                                           {core::Vec3(0.03, 0.02, 0.015), 0.4, 0.0}}));
    QVERIFY(device);
    station.tools.push_back({std::move(*device), configuration.mapping, {}});
}

std::vector<core::HapticFrame> framesOf(SessionFixture& site, database::SessionId id) {
    OpenStored stored(*site.database, id);
    auto frames = stored.session->reader().allFrames();
    return frames ? *frames : std::vector<core::HapticFrame>{};
}

} // namespace

class TestSessionReplay : public QObject {
    Q_OBJECT
private slots:
    void replaysToTheSameBits_data();
    void replaysToTheSameBits();
    void anotherSeedIsNoticed();
    void twoToolsReplay();
    void realtimeAndAsFastAgree();
    void aSoftOrganInRealTimeReplays();
    void verifyFindsNothingWrong();
};

void TestSessionReplay::replaysToTheSameBits_data() {
    QTest::addColumn<int>("level");
    QTest::addColumn<QString>("operatorName");
    QTest::newRow("visible, expert") << 1 << "expert";
    QTest::newRow("by touch, novice") << 2 << "novice";
    QTest::newRow("varied, intermediate") << 3 << "intermediate";
    QTest::newRow("dimple, unsafe") << 4 << "unsafe";
    QTest::newRow("mesh, intermediate") << 5 << "intermediate";
    QTest::newRow("soft organ, expert") << 6 << "expert";
}

void TestSessionReplay::replaysToTheSameBits() {
    QFETCH(int, level);
    QFETCH(QString, operatorName);
    SessionFixture site;
    auto result = site.run(site.request(shortLevel(level, 2, 20.0), operatorName.toStdString(), 5));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    QCOMPARE(result->recording.dropped, std::uint64_t{0});
    QCOMPARE(result->recording.frames, result->loop.ticks);
    OpenStored stored(*site.database, result->session);
    QCOMPARE(stored.session->record().summary.state, database::SessionState::completed);
    auto replay = session::replaySession(*stored.session);
    QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
    QVERIFY(replay->comparable);
    QVERIFY(replay->identical);
    QCOMPARE(replay->maximumDifference_N, 0.0);
    QCOMPARE(replay->frames, result->loop.ticks);
}

// So that the comparison can fail: the same inputs in another scene give other forces.
void TestSessionReplay::anotherSeedIsNoticed() {
    SessionFixture site;
    auto result = site.run(site.request(shortLevel(2, 1, 20.0), "expert", 6));
    QVERIFY(result);
    auto changed = site.database->write([&](database::WriteContext& context) -> core::Result<void> {
        QSqlQuery query(context.connection().qt());
        query.prepare("UPDATE session SET seed = seed + 1 WHERE id = ?");
        query.addBindValue(qint64(result->session));
        if (!query.exec())
            return core::fail(core::ErrorCode::storage, query.lastError().text().toStdString());
        return {};
    });
    QVERIFY2(changed, changed ? "" : changed.error().message.c_str());
    OpenStored stored(*site.database, result->session);
    auto replay = session::replaySession(*stored.session);
    QVERIFY(replay);
    QVERIFY(!replay->identical);
    QVERIFY(replay->maximumDifference_N > 0.01);
    QVERIFY(replay->firstDifferentTick.has_value());
}

void TestSessionReplay::twoToolsReplay() {
    SessionFixture site;
    session::TrainingRequest request = site.request(shortLevel(2, 1, 15.0), "intermediate", 8);
    addSecondTool(request.station);
    auto result = site.run(std::move(request));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    OpenStored stored(*site.database, result->session);
    QCOMPARE(stored.session->positions().tools(), 2);
    auto frames = stored.session->reader().allFrames();
    QVERIFY(frames);
    double firstLargest = 0.0;
    double secondLargest = 0.0;
    for (const core::HapticFrame& frame : *frames) {
        QCOMPARE(frame.tools, 2u);
        firstLargest = std::max(firstLargest, frame.tool[0].tissue[2]);
        secondLargest = std::max(secondLargest, frame.tool[1].tissue[2]);
    }
    QVERIFY2(firstLargest > 0.02 && secondLargest > 0.02, "both hands touched the object");
    auto replay = session::replaySession(*stored.session);
    QVERIFY(replay && replay->identical);
}

void TestSessionReplay::realtimeAndAsFastAgree() {
    SessionFixture site;
    const catalogue::ExerciseLevel level = shortLevel(2, 1, 3.0);
    auto fast = site.run(site.request(level, "novice", 9));
    session::TrainingRequest slow = site.request(level, "novice", 9);
    slow.realtime = true;
    auto realtime = site.run(std::move(slow));
    QVERIFY2(fast && realtime, "both runs end");
    QCOMPARE(realtime->recording.dropped, std::uint64_t{0});
    QVERIFY(session::sameScores(fast->scores, realtime->scores));
    const auto a = framesOf(site, fast->session);
    const auto b = framesOf(site, realtime->session);
    QCOMPARE(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        QCOMPARE(a[i].tool[0].counts, b[i].tool[0].counts);
        QCOMPARE(a[i].tool[0].tissue, b[i].tool[0].tissue);
        QCOMPARE(a[i].tool[0].commanded, b[i].tool[0].commanded);
        QCOMPARE(a[i].header.events, b[i].header.events);
    }
    OpenStored one(*site.database, fast->session);
    OpenStored two(*site.database, realtime->session);
    for (std::size_t i = 0;
         i < std::min(one.session->reader().chunkCount(), two.session->reader().chunkCount()); ++i) {
        if (one.session->reader().framesOf(i)->size() != two.session->reader().framesOf(i)->size())
            break; // chunks close by the clock in real time: only equal spans can be compared by hash
        QVERIFY(*one.session->reader().forceHash(i) == *two.session->reader().forceHash(i));
    }
}

// The slow model on its thread, as late as this machine makes it: the recording says when its answers came.
void TestSessionReplay::aSoftOrganInRealTimeReplays() {
    SessionFixture site;
    session::TrainingRequest request = site.request(shortLevel(6, 1, 5.0), "unsafe", 4);
    request.realtime = true;
    auto result = site.run(std::move(request));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    int applied = 0;
    for (const core::HapticFrame& frame : framesOf(site, result->session))
        applied += (frame.header.events & core::event_bits::kSlowApplied) != 0 ? 1 : 0;
    QVERIFY(applied > 0);
    OpenStored stored(*site.database, result->session);
    auto replay = session::replaySession(*stored.session);
    QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
    QVERIFY(replay->identical);
    QCOMPARE(replay->maximumDifference_N, 0.0);
}

void TestSessionReplay::verifyFindsNothingWrong() {
    SessionFixture site;
    QVERIFY(site.run(site.request(shortLevel(1, 1, 15.0), "expert", 3)));
    const std::string file = site.file();
    site.database.reset();
    const database::VerifyReport report = session::verifyEverything(file);
    for (const database::Finding& finding : report.findings)
        qWarning("%s %s %s", finding.kind.c_str(), finding.row.c_str(), finding.detail.c_str());
    QVERIFY(report.ok());
}

QTEST_GUILESS_MAIN(TestSessionReplay)
#include "test_session_replay.moc"
