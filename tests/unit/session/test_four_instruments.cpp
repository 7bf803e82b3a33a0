// SPDX-License-Identifier: GPL-3.0-or-later
// Two and four simulated gimbals at once on one scene: caps, stop, arming, recording, recovery and replay
// hold for each of them.
#include "devices/drivers/simulated/simulated_device.h"
#include "mechanisms/scripted_motion.h"
#include "recording/crash_ring.h"
#include "recording/ring_recovery.h"
#include "session/live_recording.h"
#include "session/recovery.h"
#include "session/replayer.h"
#include "support/haptic_bench.h"
#include "support/looked_back.h"
#include "support/session_fixture.h"

#include <QtTest>
#include <array>
#include <cstring>
#include <filesystem>
#include <optional>

using namespace chiron;
using core::Vec3;

namespace {

constexpr double kCap_N = 2.0;

/// A hand that comes down on the floor beside the sphere and strokes it, pressing much harder than the device
/// gives.
std::unique_ptr<mechanisms::HandStrategy> presser(std::size_t tool) {
    const double phase = 0.5 * static_cast<double>(tool);
    return std::make_unique<mechanisms::ScriptedMotion>(
        Vec3(0.0, 0.0, 0.010), std::vector<mechanisms::ScriptedMotion::Term>{
                                   {Vec3(0.010, 0.0, 0.0), 0.7, phase}, {Vec3(0.0, 0.0, 0.025), 0.2, phase}});
}

session::Station pressers(std::size_t tools, const catalogue::ExerciseLevel& level) {
    // The first hand is a real trainee's, so that trials go on; the others only press.
    auto station = session::scriptedStation(**session::exerciseKind("sphere_apex"), level, "novice", 5);
    constexpr std::array<std::array<double, 3>, 3> kPlaces{
        {{-0.06, 0.0, 0.0}, {0.0, 0.05, 0.0}, {0.05, -0.03, 0.0}}};
    for (std::size_t i = 1; i < tools; ++i) {
        devices::SimulatedDevice::Configuration configuration;
        configuration.mapping.origin_m = kPlaces[i - 1];
        configuration.seed = i;
        configuration.jaw = mechanisms::JawParameters{};
        auto device = devices::SimulatedDevice::create(configuration, presser(i));
        if (!device)
            qFatal("%s", device.error().message.c_str());
        station->tools.push_back({std::move(*device), configuration.mapping, {}});
    }
    return std::move(*station);
}

double forceOf(const core::Array6& wrench) {
    return std::hypot(wrench[0], wrench[1], wrench[2]);
}

/// A loop with so many gimbals, run by hand.
struct Bench {
    explicit Bench(std::size_t tools) : station(pressers(tools, tests::shortLevel(1, 2, 20.0))) {
        std::vector<haptics::LoopTool> list;
        for (std::size_t i = 0; i < tools; ++i) {
            if (auto opened = station.tools[i].device->open(); !opened)
                qFatal("%s", opened.error().message.c_str());
            list.push_back({*station.tools[i].device, station.tools[i].mapping});
        }
        haptics::SafetySettings safety;
        safety.heartbeatWatched = false;
        safety.exerciseForce_N = kCap_N;
        loop.emplace(list, inputs, store, tests::apexScene(tests::benchExercise(2, 20.0)), safety);
        inputs.post({core::CommandKind::start});
    }
    void run(int ticks) {
        for (int n = 0; n < ticks; ++n, ++m_done)
            loop->loop->tick(source.next(static_cast<std::int64_t>(m_done) * 1'000'000));
    }
    session::Station station;
    haptics::LiveInputs inputs;
    tests::FrameStore store;
    std::optional<tests::LoopBench> loop;
    realtime::TickSource source;

private:
    int m_done = 0;
};

} // namespace

class TestFourInstruments : public QObject {
    Q_OBJECT
private slots:
    void capsHoldForEach_data() { counts(); }
    void capsHoldForEach();
    void stopReachesAll_data() { counts(); }
    void stopReachesAll();
    void theSessionReplaysToTheSameBits_data() { counts(); }
    void theSessionReplaysToTheSameBits();
    void aCrashLeavesAllOfThem();

private:
    static void counts() {
        QTest::addColumn<int>("tools");
        QTest::newRow("two") << 2;
        QTest::newRow("four") << 4;
    }
};

/// Force comes only once it is armed; then nobody gets more than the cap, though each asks for more.
void TestFourInstruments::capsHoldForEach() {
    QFETCH(int, tools);
    const auto count = static_cast<std::size_t>(tools);
    Bench bench(count);
    bench.run(12'000);
    std::array<double, core::kMaxTools> asked{};
    std::array<double, core::kMaxTools> given{};
    bool armed = false;
    for (const core::HapticFrame& frame : bench.store.frames) {
        QCOMPARE(frame.tools, static_cast<std::uint32_t>(tools));
        armed = armed || frame.header.force == core::ForceState::on;
        for (std::size_t i = 0; i < count; ++i) {
            asked[i] = std::max(asked[i], forceOf(frame.tool[i].tissue));
            given[i] = std::max(given[i], forceOf(frame.tool[i].commanded));
            if (!armed && frame.header.force == core::ForceState::arming)
                QCOMPARE(forceOf(frame.tool[i].commanded), 0.0);
        }
    }
    QVERIFY(armed);
    for (std::size_t i = 1; i < count; ++i) {
        QVERIFY2(asked[i] > kCap_N,
                 qPrintable(QStringLiteral("tool %1 asked for %2 N").arg(i).arg(asked[i])));
        QVERIFY2(given[i] > 0.5 * kCap_N && given[i] <= kCap_N + 1e-9,
                 qPrintable(QStringLiteral("tool %1 got %2 N").arg(i).arg(given[i])));
    }
}

/// Zero on every device within two ticks, and it stays so until somebody re-arms.
void TestFourInstruments::stopReachesAll() {
    QFETCH(int, tools);
    const auto count = static_cast<std::size_t>(tools);
    Bench bench(count);
    const auto someForce = [&bench, count] {
        for (std::size_t i = 1; i < count; ++i)
            if (forceOf(bench.store.frames.back().tool[i].commanded) < 0.05)
                return false;
        return true;
    };
    int waited = 0;
    while (waited++ < 20'000 && (bench.store.frames.empty() || !someForce()))
        bench.run(1);
    QVERIFY(someForce()); // all press at once
    bench.inputs.post({core::CommandKind::stopForce});
    bench.run(2);
    for (int n = 0; n < 500; ++n) {
        for (std::size_t i = 0; i < count; ++i)
            QCOMPARE(forceOf(bench.store.frames.back().tool[i].commanded), 0.0);
        bench.run(1);
    }
    QVERIFY(bench.store.frames.back().header.force == core::ForceState::stopped);
}

void TestFourInstruments::theSessionReplaysToTheSameBits() {
    QFETCH(int, tools);
    tests::SessionFixture site;
    const catalogue::ExerciseLevel level = tests::shortLevel(1, 1, 6.0);
    session::TrainingRequest request = site.request(level, "novice", 5);
    request.station = pressers(static_cast<std::size_t>(tools), level);
    const auto result = site.run(std::move(request));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    tests::OpenStored stored(*site.database, result->session);
    QCOMPARE(stored.session->positions().tools(), tools);
    const auto report = session::replaySession(*stored.session);
    QVERIFY2(report, report ? "" : report.error().message.c_str());
    QVERIFY(report->comparable && report->identical);
    QCOMPARE(report->maximumDifference_N, 0.0);
    const auto trace = tests::traceOf(*stored.session);
    QVERIFY(trace && trace->trials.size() == 1);
    QCOMPARE(trace->trials[0].tools.size(), static_cast<std::size_t>(tools));
    for (const scoring::ToolTrace& tool : trace->trials[0].tools) {
        QCOMPARE(tool.t_s.size(), trace->trials[0].tools[0].t_s.size());
        QCOMPARE(tool.q_WT.size(), tool.t_s.size()); // gimbals turn
    }
}

/// Frames of four tools that were pushed and never stored come back after the program died.
void TestFourInstruments::aCrashLeavesAllOfThem() {
    Bench bench(4);
    bench.run(3000);
    QTemporaryDir folder;
    recording::RingSettings settings;
    settings.folder = folder.path().toStdString();
    settings.session = 1;
    settings.tools = 4;
    std::filesystem::path path;
    {
        auto ring = recording::CrashRing::create(settings);
        QVERIFY(ring.has_value());
        path = (*ring)->path();
        for (const core::HapticFrame& frame : bench.store.frames)
            QVERIFY((*ring)->tryPush(frame));
    }
    const auto ring = recording::recoverRing(path);
    QVERIFY2(ring, ring ? "" : ring.error().message.c_str());
    QCOMPARE(ring->tools(), 4);
    QCOMPARE(ring->frames().size(), bench.store.frames.size());
    for (std::size_t i = 0; i < ring->frames().size(); ++i)
        QVERIFY(std::memcmp(&ring->frames()[i], &bench.store.frames[i], sizeof(core::HapticFrame)) == 0);
}

QTEST_GUILESS_MAIN(TestFourInstruments)
#include "test_four_instruments.moc"
