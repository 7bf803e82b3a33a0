// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "frames.h"
#include "session/event_extractor.h"

#include <QtTest>

using namespace chiron;
using core::CommandKind;
using database::SessionState;
using tests::someFrames;
namespace bits = core::event_bits;
namespace guards = core::guard_bits;

namespace {

constexpr double kLimit_N = 2.0;
constexpr std::uint64_t kSeed = 99;

session::EventExtractor extracted(const std::vector<core::HapticFrame>& frames, int tools = 1,
                                  std::span<const session::SceneEvent> sceneEvents = {}) {
    session::EventExtractor extractor(kLimit_N, kSeed, tools, nullptr, sceneEvents);
    extractor.add(frames);
    return extractor;
}

std::vector<std::pair<std::string, std::uint64_t>> named(const session::EventExtractor& extractor) {
    std::vector<std::pair<std::string, std::uint64_t>> all;
    for (const database::EventRecord& event : extractor.events())
        all.emplace_back(event.kind, event.tick);
    return all;
}

using Named = std::vector<std::pair<std::string, std::uint64_t>>;

} // namespace

class TestEventExtractor : public QObject {
    Q_OBJECT
private slots:
    void commands_data();
    void commands();
    void guardOnsets_data();
    void guardOnsets();
    void guardsThatAlwaysActAreNoEvents();
    void overForceOnce();
    void overForceOfEachTool();
    void overForceWhilePaused();
    void tissueThatGaveWay();
    void tissueThatGaveWayHasAPlace();
    void trials();
    void procedures();
    void states();
    void times();
    void timesFollowNoRefusedPacket();
    void chunksMakeNoDifference();
};

void TestEventExtractor::commands_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QByteArray>("word");
    const std::pair<CommandKind, const char*> all[] = {
        {CommandKind::start, "start"},          {CommandKind::pause, "pause"},
        {CommandKind::resume, "resume"},        {CommandKind::confirmHold, "confirm_hold"},
        {CommandKind::stopForce, "stop_force"}, {CommandKind::rearm, "rearm"},
        {CommandKind::mark, "mark_command"},    {CommandKind::end, "end"}};
    for (const auto& [kind, word] : all)
        QTest::newRow(word) << int(kind) << QByteArray(word);
}

void TestEventExtractor::commands() {
    QFETCH(int, kind);
    QFETCH(QByteArray, word);
    auto frames = someFrames(5);
    frames[3].header.commands[1] = {static_cast<CommandKind>(kind),
                                    0}; // the second place counts as the first
    const auto extractor = extracted(frames);
    QCOMPARE(named(extractor), (Named{{word.toStdString(), 3}}));
    QCOMPARE(extractor.ended(), static_cast<CommandKind>(kind) == CommandKind::end);
}

void TestEventExtractor::guardOnsets_data() {
    QTest::addColumn<quint32>("bit");
    QTest::addColumn<QByteArray>("word");
    const std::pair<std::uint32_t, const char*> all[] = {
        {guards::kOverVelocity, "over_velocity"},   {guards::kBadSample, "bad_sample"},
        {guards::kSampleFault, "sample_fault"},     {guards::kWatchdog, "watchdog"},
        {guards::kWatchdogFault, "watchdog_fault"}, {guards::kHeartbeat, "window_frozen"},
        {guards::kPassivity, "passivity"},          {guards::kDeviceFault, "device_fault"}};
    for (const auto& [bit, word] : all)
        QTest::newRow(word) << bit << QByteArray(word);
}

// Once when it begins, not at every tick that it lasts; again when it comes back.
void TestEventExtractor::guardOnsets() {
    QFETCH(quint32, bit);
    QFETCH(QByteArray, word);
    auto frames = someFrames(12);
    for (const std::size_t i : {2u, 3u, 4u, 8u, 9u})
        frames[i].header.guards = bit;
    QCOMPARE(named(extracted(frames)), (Named{{word.toStdString(), 2}, {word.toStdString(), 8}}));
}

void TestEventExtractor::guardsThatAlwaysActAreNoEvents() {
    auto frames = someFrames(6);
    frames[2].header.guards = guards::kCap | guards::kSlew | guards::kArming;
    QVERIFY(extracted(frames).events().empty());
}

void TestEventExtractor::overForceOnce() {
    auto frames = someFrames(12);
    for (const std::size_t i : {2u, 3u, 4u, 8u})
        frames[i].tool[0].tissue = {1.5, 0.0, 1.5, 0.0, 0.0, 0.0}; // 2.12 N, no part of it over the limit
    frames[6].tool[0].tissue[2] = kLimit_N;                        // at the limit is not over it
    frames[6].tool[0].commanded[2] = 9.0;                          // tissue force is what counts
    QCOMPARE(named(extracted(frames)), (Named{{"force_over_limit", 2}, {"force_over_limit", 8}}));
}

void TestEventExtractor::overForceOfEachTool() {
    auto frames = someFrames(4, 0, 2);
    frames[1].tool[1].tissue[2] = 3.0;
    frames[2].tool[0].tissue[2] = frames[2].tool[1].tissue[2] = 3.0;
    const auto extractor = extracted(frames, 2);
    QCOMPARE(named(extractor), (Named{{"force_over_limit", 1}, {"force_over_limit", 2}}));
    QCOMPARE(extractor.events()[0].tool, 1);
    QCOMPARE(extractor.events()[1].tool, 0);
}

void TestEventExtractor::overForceWhilePaused() {
    auto frames = someFrames(4);
    frames[1].tool[0].tissue[2] = 3.0;
    frames[1].header.paused = 1;
    QVERIFY(extracted(frames).events().empty());
}

void TestEventExtractor::tissueThatGaveWay() {
    auto frames = someFrames(12, 0, 2);
    frames[4].tool[1].tissue = {0.0, 0.0, 7.5, 0.0, 0.0, 0.0};
    frames[5].tool[1].tissue = {0.0, 0.0, 6.0, 0.0, 0.0, 0.0};
    frames[5].tool[1].status |=
        core::contactStatus(core::contact_bits::kYielded | core::contact_bits::kThrough);
    for (std::size_t i = 6; i < 9; ++i)
        frames[i].tool[1].status |= core::contactStatus(core::contact_bits::kThrough);
    frames[10].tool[0].tissue = {0.0, 2.0, 0.0, 0.0, 0.0, 0.213};
    frames[10].tool[0].status |=
        core::contactStatus(core::contact_bits::kYielded | core::contact_bits::kThrough);
    const auto extractor = extracted(frames, 2);
    int found = 0;
    for (const database::EventRecord& event : extractor.events())
        if (event.kind == "tissue_yielded" && event.tool == 0) {
            QCOMPARE(event.detailJson, std::string("{\"trial\":0,\"force_mN\":2000,\"torque_mN_m\":213}"));
        } else if (event.kind == "tissue_yielded") {
            ++found;
            QCOMPARE(event.tick, frames[5].header.index);
            QCOMPARE(event.tool, 1);
            QCOMPARE(event.detailJson, std::string("{\"trial\":0,\"force_mN\":7500}"));
        }
    QCOMPARE(found, 1);
}

// Where the tip was, of the tool that broke it; to a micrometre, and in no language's decimals. A packet that
// cannot be trusted says nothing about a place.
void TestEventExtractor::tissueThatGaveWayHasAPlace() {
    const tests::MillimetreCounts positions{};
    auto frames = someFrames(12, 0, 2);
    const auto yield = [&](std::size_t at, std::size_t tool) {
        frames[at].tool[tool].counts = {};
        frames[at].tool[tool].counts[0] = 12;
        frames[at].tool[tool].counts[1] = -4;
        frames[at].tool[tool].status |= core::contactStatus(core::contact_bits::kYielded);
    };
    yield(3, 0);
    yield(5, 1);
    yield(8, 0);
    frames[8].tool[0].status |= core::sample_status::kRefused;
    session::EventExtractor extractor(kLimit_N, kSeed, 2, &positions);
    extractor.add(frames);
    std::vector<std::string> details;
    for (const database::EventRecord& event : extractor.events())
        if (event.kind == "tissue_yielded")
            details.push_back(event.detailJson);
    QCOMPARE(details,
             (std::vector<std::string>{"{\"trial\":0,\"force_mN\":0,\"position_m\":[0.012,-0.004,0]}",
                                       "{\"trial\":0,\"force_mN\":0,\"position_m\":[0.112,-0.004,0]}",
                                       "{\"trial\":0,\"force_mN\":0}"}));
}

void TestEventExtractor::trials() {
    auto frames = someFrames(20);
    frames[2].header.events = bits::kTrialStarted;
    frames[6].header.events = bits::kMarked;
    frames[9].header.events = bits::kTrialStarted;
    frames[13].header.events = bits::kTimedOut;
    frames[15].header.events = bits::kTrialStarted;
    for (std::size_t i = 9; i < 20; ++i)
        frames[i].header.trial = i < 15 ? 1 : 2;
    const auto extractor = extracted(frames);
    QCOMPARE(named(extractor), (Named{{"trial_started", 2},
                                      {"marked", 6},
                                      {"trial_started", 9},
                                      {"timed_out", 13},
                                      {"trial_started", 15}}));
    const auto& trials = extractor.trials();
    QCOMPARE(trials.size(), std::size_t{3});
    QVERIFY(trials[0].marked && !trials[0].timedOut && trials[0].state == SessionState::completed);
    QVERIFY(!trials[1].marked && trials[1].timedOut && trials[1].state == SessionState::completed);
    QVERIFY(trials[2].state == SessionState::running); // its fate is the session's
    QCOMPARE(trials[0].firstTick, std::uint64_t{2});
    QCOMPARE(trials[0].lastTick, std::uint64_t{6});
    QCOMPARE(trials[2].lastTick, std::uint64_t{19});
    QCOMPARE(trials[1].index, 1);
    QCOMPARE(trials[1].seed, kSeed);
    QCOMPARE(extractor.events()[3].detailJson, std::string("{\"trial\":1}"));
}

void TestEventExtractor::procedures() {
    auto frames = someFrames(20);
    frames[2].header.events = bits::kTrialStarted;
    frames[4].header.events = bits::kStageChanged;
    const session::SceneEvent seen[]{{1u << 9, "landmark_seen", {"landmark_seen", "view-visible"}}};
    frames[7].header.events = seen[0].bit;
    frames[9].header.events = seen[0].bit | bits::kStageChanged; // the last one begins the withdrawal
    frames[15].header.events = bits::kCompleted | bits::kStageChanged;
    const auto extractor = extracted(frames, 1, seen);
    QCOMPARE(named(extractor), (Named{{"trial_started", 2},
                                      {"stage_changed", 4},
                                      {"landmark_seen", 7},
                                      {"stage_changed", 9},
                                      {"landmark_seen", 9},
                                      {"completed", 15}}));
    const auto& trials = extractor.trials();
    QCOMPARE(trials.size(), std::size_t{1});
    QVERIFY(trials[0].marked && !trials[0].timedOut && trials[0].state == SessionState::completed);
    QCOMPARE(trials[0].lastTick, std::uint64_t{15});
    // The bit says nothing in an exercise that gives it no meaning.
    QCOMPARE(named(extracted(frames)),
             (Named{{"trial_started", 2}, {"stage_changed", 4}, {"stage_changed", 9}, {"completed", 15}}));
    frames[15].header.events = bits::kTimedOut;
    const auto late = extracted(frames);
    QCOMPARE(late.events().back().kind, std::string("timed_out"));
    QVERIFY(!late.trials()[0].marked && late.trials()[0].timedOut);
}

void TestEventExtractor::timesFollowNoRefusedPacket() {
    auto frames = someFrames(6, 100);
    frames[0].tool[0].deviceTime_us = 4'000'000'000;
    frames[0].tool[0].status |= core::sample_status::kRefused;
    frames[5].header.commands[0] = {CommandKind::pause, 0};
    QCOMPARE(extracted(frames).events()[0].time_s, 0.004); // since the first packet that can be believed
    frames[5].tool[0].deviceTime_us = 4'000'000'000;
    frames[5].tool[0].status |= core::sample_status::kRefused;
    QCOMPARE(extracted(frames).events()[0].time_s, 0.003); // of the last one that can
}

void TestEventExtractor::states() {
    auto frames = someFrames(5);
    const auto usual = extracted(frames);
    QVERIFY(!usual.finished() && !usual.faulted() && !usual.ended());
    QCOMPARE(usual.frames(), std::uint64_t{5});
    QCOMPARE(usual.lastTick(), std::uint64_t{4});
    frames[2].header.force = core::ForceState::fault; // re-armed since
    QVERIFY(!extracted(frames).faulted());
    frames[4].header.force = core::ForceState::fault;
    QVERIFY(extracted(frames).faulted());
    frames[3].header.phase = core::TrialPhase::finished;
    QVERIFY(extracted(frames).finished());
}

void TestEventExtractor::times() {
    auto frames = someFrames(4, 100);
    frames[3].header.commands[0] = {CommandKind::pause, 0};
    const auto later = extracted(frames);
    QCOMPARE(later.events()[0].time_s, 0.003); // device time since the first frame
    QCOMPARE(later.events()[0].tick, std::uint64_t{103});
    frames[3].tool[0].deviceTime_us = 0; // a device clock set back
    QCOMPARE(extracted(frames).events()[0].time_s, 0.0);
}

void TestEventExtractor::chunksMakeNoDifference() {
    auto frames = someFrames(30);
    frames[4].header.events = bits::kTrialStarted;
    for (std::size_t i = 8; i < 15; ++i) {
        frames[i].header.guards = guards::kPassivity;
        frames[i].tool[0].tissue[1] = 5.0;
    }
    session::EventExtractor pieces(kLimit_N, kSeed, 1);
    for (const core::HapticFrame& frame : frames)
        pieces.add(std::span(&frame, 1));
    QCOMPARE(named(pieces), named(extracted(frames)));
    QCOMPARE(pieces.events().size(), std::size_t{3});
}

QTEST_APPLESS_MAIN(TestEventExtractor)
#include "test_event_extractor.moc"
