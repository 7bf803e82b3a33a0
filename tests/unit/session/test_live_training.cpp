// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/live_training.h"
#include "session/replayer.h"
#include "support/patience.h"
#include "support/session_fixture.h"

#include <QtTest>
#include <chrono>
#include <set>

using chiron::tests::kPatience_ms;

using namespace chiron;
using core::CommandKind;
using database::SessionState;

namespace {

session::TrainingRequest mouseRequest(int trials, double limit_s) {
    session::TrainingRequest request;
    request.level = tests::shortLevel(1, trials, limit_s);
    request.seed = 3;
    request.ringFolder = recording::defaultRingFolder();
    request.station = std::move(*session::keyboardMouseStation());
    return request;
}

std::unique_ptr<session::LiveTraining> begin(tests::SessionFixture& site, session::TrainingRequest request,
                                             std::function<void()> onFinished = {}) {
    auto live = session::LiveTraining::start(*site.database, database::Actor::simulated(), std::move(request),
                                             std::move(onFinished));
    if (!live)
        qFatal("%s", live.error().message.c_str());
    return std::move(*live);
}

/// What a window does each frame.
bool frame(session::LiveTraining& live, haptics::DisplayState& shown) {
    live.beat();
    live.display().read(shown);
    for (session::LiveSample sample;
         live.samples().tryPop(sample);) // or there is no room for more after 8 s, which a busy machine needs
        continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return !live.finished();
}

SessionState stateOf(tests::SessionFixture& site, database::SessionId id) {
    return tests::OpenStored(*site.database, id).session->record().summary.state;
}

} // namespace

class TestLiveTraining : public QObject {
    Q_OBJECT
private slots:
    void aPersonsSetEndsWithItsLastTrial();
    void theEndCommandEndsIt();
    void destroyingItEndsAndStoresIt();
    void itWaitsForTheStartCommand();
    void failuresComeOutOfTheResult();
    void refusesAStationWithoutDevice();
    void aStallOfTheWindowBesideTheSameRunWithout();
};

void TestLiveTraining::aPersonsSetEndsWithItsLastTrial() {
    tests::SessionFixture site;
    std::atomic<int> called{0};
    auto live = begin(site, mouseRequest(2, 20.0), [&] { ++called; });
    QVERIFY(!live->felt() && live->pointer());
    live->post(CommandKind::start);
    haptics::DisplayState shown;
    std::set<int> marked;
    while (frame(*live, shown)) {
        if (shown.phase != core::TrialPhase::running || marked.count(shown.trial) != 0)
            continue;
        live->pointer()->move(0.0, 0.0, -0.001);
        if (shown.tool[0].p_WT_m[2] < 0.03) {
            live->post(CommandKind::mark);
            marked.insert(shown.trial);
        }
    }
    QTRY_COMPARE_WITH_TIMEOUT(called.load(), 1, kPatience_ms);
    QVERIFY2(live->result(), live->result() ? "" : live->result().error().message.c_str());
    QCOMPARE(live->result()->session, live->sessionId());
    QCOMPARE(live->droppedSamples(), std::uint64_t{0});
    QVERIFY(stateOf(site, live->sessionId()) == SessionState::completed);
    tests::OpenStored stored(*site.database,
                             live->sessionId()); // a person's hand replays to the same bits, too
    const auto replay = session::replaySession(*stored.session);
    QVERIFY2(replay, replay ? "" : replay.error().message.c_str());
    QVERIFY(replay->identical && replay->comparable);
    QVERIFY(replay->frames > 100);
}

void TestLiveTraining::theEndCommandEndsIt() {
    tests::SessionFixture site;
    auto live = begin(site, mouseRequest(1, 60.0));
    live->post(CommandKind::start);
    haptics::DisplayState shown;
    while (frame(*live, shown)) {
        if (shown.phase == core::TrialPhase::running)
            live->post(CommandKind::end);
    }
    QVERIFY(live->result());
    QVERIFY(stateOf(site, live->sessionId()) == SessionState::stopped);
}

void TestLiveTraining::destroyingItEndsAndStoresIt() {
    tests::SessionFixture site;
    auto live = begin(site, mouseRequest(1, 60.0));
    live->post(CommandKind::start);
    haptics::DisplayState shown;
    while (frame(*live, shown) && shown.phase != core::TrialPhase::running) {
    }
    const database::SessionId id = live->sessionId();
    QVERIFY(id != 0);
    live.reset();
    QVERIFY(stateOf(site, id) == SessionState::stopped);
}

void TestLiveTraining::itWaitsForTheStartCommand() {
    tests::SessionFixture site;
    auto live = begin(site, mouseRequest(1, 60.0));
    haptics::DisplayState shown;
    while (frame(*live, shown) && shown.tick < 200) {
    }
    QVERIFY(shown.phase == core::TrialPhase::idle && !shown.started);
    live->post(CommandKind::start);
    while (frame(*live, shown) && shown.phase != core::TrialPhase::running) {
    }
    QVERIFY(shown.started);
    live->requestStop();
    while (frame(*live, shown)) {
    }
    QVERIFY(live->result());
}

void TestLiveTraining::failuresComeOutOfTheResult() {
    tests::SessionFixture site;
    session::TrainingRequest request = mouseRequest(1, 60.0);
    request.ringFolder = site.folder() + "/missing/folder";
    auto live = begin(site, std::move(request));
    QTRY_VERIFY_WITH_TIMEOUT(live->finished(), kPatience_ms);
    QVERIFY(!live->result());
    QVERIFY(!live->result().error().message.empty());
    QVERIFY(stateOf(site, live->sessionId()) == SessionState::faulted);
}

void TestLiveTraining::refusesAStationWithoutDevice() {
    tests::SessionFixture site;
    session::TrainingRequest request = mouseRequest(1, 60.0);
    request.station = {};
    const auto live =
        session::LiveTraining::start(*site.database, database::Actor::simulated(), std::move(request));
    QVERIFY(!live);
    QVERIFY(live.error().code == core::ErrorCode::wrongUse);
}

/// Prints, and asserts nothing that a busy machine could break: what counts is on the virtual clock
/// (test_live_link).
void TestLiveTraining::aStallOfTheWindowBesideTheSameRunWithout() {
    for (const bool stall : {false, true}) {
        tests::SessionFixture site;
        auto live = begin(site, site.request(tests::shortLevel(1, 1, 60.0), "expert", 5));
        QVERIFY(live->felt() && !live->pointer());
        live->post(CommandKind::start);
        haptics::DisplayState shown;
        while (frame(*live, shown) && shown.tick < 500) {
        }
        if (stall)
            std::this_thread::sleep_for(std::chrono::seconds(1));
        const haptics::DisplayState after = live->display().latest();
        while (frame(*live, shown) && shown.tick < 2'000) {
        }
        live->requestStop();
        while (frame(*live, shown)) {
        }
        QVERIFY(live->result());
        const session::LoopReport& loop = live->result()->loop;
        qInfo("%s: %llu ticks, %llu late by more than 100 us, %llu skipped; p50 %.1f, p99 %.1f, max %.1f us",
              stall ? "window stalled for 1 s" : "window alive          ",
              static_cast<unsigned long long>(loop.ticks), static_cast<unsigned long long>(loop.late),
              static_cast<unsigned long long>(loop.skipped), loop.p50_us.value_or(0.0),
              loop.p99_us.value_or(0.0), loop.max_us.value_or(0.0));
        if (stall) // the guard looks at the heartbeat's age, not at this test's clock
            QVERIFY((after.guardsSeen & core::guard_bits::kHeartbeat) != 0);
        QCOMPARE(live->result()->recording.dropped, std::uint64_t{0});
    }
}

QTEST_GUILESS_MAIN(TestLiveTraining)
#include "test_live_training.moc"
