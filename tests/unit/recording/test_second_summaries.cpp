// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/wrench_rounding.h"
#include "unit/recording/recorder_support.h"

#include <QtTest>
#include <map>

using namespace chiron;
using namespace chiron::recording;
using namespace chiron::tests;

namespace {
/// The definition in second_summaries.h, written the long way.
std::vector<SecondSummary> bruteForce(const std::vector<core::HapticFrame>& frames, std::size_t tool,
                                      double limit_N) {
    const Position position;
    std::map<std::uint32_t, SecondSummary> seconds;
    std::map<std::uint32_t, std::vector<double>> forces;
    const auto force = [&](std::size_t i) {
        const core::HapticFrame rounded = roundedFrame(frames[i]);
        return core::toWrench(rounded.tool[tool].tissue).force.norm();
    };
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto second = static_cast<std::uint32_t>(
            (frames[i].tool[tool].deviceTime_us - frames[0].tool[tool].deviceTime_us) / 1'000'000);
        SecondSummary& sum = seconds[second];
        sum.second = second;
        sum.tool = static_cast<std::uint8_t>(tool);
        sum.events |= frames[i].header.events;
        if (frames[i].header.paused)
            continue;
        ++sum.frames;
        forces[second].push_back(force(i));
        if (i == 0 || frames[i - 1].header.paused)
            continue;
        const double dt_s =
            static_cast<double>(frames[i].tool[tool].deviceTime_us - frames[i - 1].tool[tool].deviceTime_us) /
            1e6;
        const int t = static_cast<int>(tool);
        sum.pathLength_m +=
            (position.p_WT_m(t, frames[i].tool[tool]) - position.p_WT_m(t, frames[i - 1].tool[tool])).norm();
        sum.impulse_Ns += (force(i) + force(i - 1)) / 2 * dt_s;
        sum.timeOverLimit_s += force(i) > limit_N ? dt_s : 0.0;
    }
    std::vector<SecondSummary> all;
    for (auto& [second, sum] : seconds) {
        for (const double f : forces[second]) {
            sum.maximumForce_N = std::max(sum.maximumForce_N, f);
            sum.meanForce_N += f / static_cast<double>(forces[second].size());
        }
        all.push_back(sum);
    }
    return all;
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max(1.0, std::abs(b));
}
} // namespace

class TestSecondSummaries : public QObject {
    Q_OBJECT
private slots:
    void summariesMatchBruteForce();
    void knownForceGivesKnownNumbers();
    void pausedSpansCountInNothing();
    void nonFiniteForcesAreLeftOut();
    void clockSetBackReordersNothing();
    void refusedPacketsCountInNothing();
};

void TestSecondSummaries::summariesMatchBruteForce() {
    Fixture f(2);
    Recorder recorder = f.recorder();
    auto frames = HapticTrace(3, 2).take(4321);
    for (std::size_t i = 1500; i < 1800; ++i)
        frames[i].header.paused = 1;
    QVERIFY(recorder.add(frames) && recorder.finish());
    for (std::size_t tool = 0; tool < 2; ++tool) {
        std::vector<SecondSummary> ours;
        for (const SecondSummary& s : f.store.summaries())
            if (s.tool == tool)
                ours.push_back(s);
        const auto expected = bruteForce(frames, tool, f.settings.forceLimit_N);
        QCOMPARE(ours.size(), expected.size());
        for (std::size_t i = 0; i < ours.size(); ++i) {
            QCOMPARE(ours[i].second, expected[i].second);
            QCOMPARE(ours[i].frames, expected[i].frames);
            QCOMPARE(ours[i].events, expected[i].events);
            QCOMPARE(ours[i].maximumForce_N, expected[i].maximumForce_N);
            QVERIFY(near(ours[i].pathLength_m, expected[i].pathLength_m));
            QVERIFY(near(ours[i].meanForce_N, expected[i].meanForce_N));
            QVERIFY(near(ours[i].impulse_Ns, expected[i].impulse_Ns));
            QVERIFY(near(ours[i].timeOverLimit_s, expected[i].timeOverLimit_s));
        }
    }
}

// 3 N straight for 1 s at 1 mm a tick along x: path 0.999 m, impulse 2.997 N·s (999 steps), all of it over
// 0.8 N.
void TestSecondSummaries::knownForceGivesKnownNumbers() {
    Fixture f;
    Recorder recorder = f.recorder();
    for (std::uint64_t i = 0; i < 1000; ++i) {
        core::HapticFrame frame;
        frame.tools = 1;
        frame.header.index = i;
        frame.tool[0].counts[0] = static_cast<std::int32_t>(100 * i);
        frame.tool[0].deviceTime_us = 1000 * i;
        frame.tool[0].tissue = {1.0, 2.0, 2.0, 9.0, 9.0, 9.0}; // torque does not count
        QVERIFY(recorder.add({&frame, 1}));
    }
    QVERIFY(recorder.finish());
    QCOMPARE(f.store.summaries().size(), std::size_t{1});
    const SecondSummary& s = f.store.summaries()[0];
    QCOMPARE(s.frames, 1000u);
    QVERIFY(near(s.pathLength_m, 0.999));
    QVERIFY(near(s.impulse_Ns, 2.997));
    QVERIFY(near(s.timeOverLimit_s, 0.999));
    QCOMPARE(s.maximumForce_N, 3.0);
    QVERIFY(near(s.meanForce_N, 3.0));
}

void TestSecondSummaries::pausedSpansCountInNothing() {
    Fixture f;
    Recorder recorder = f.recorder();
    auto frames = HapticTrace(3).take(500);
    for (auto& frame : frames) {
        frame.header.paused = 1;
        frame.header.events = core::event_bits::kMarked;
    }
    QVERIFY(recorder.add(frames) && recorder.finish());
    QCOMPARE(f.store.summaries().size(), std::size_t{1});
    SecondSummary expected;
    expected.events = core::event_bits::kMarked;
    QVERIFY(sameSummary(f.store.summaries()[0], expected));
}

void TestSecondSummaries::nonFiniteForcesAreLeftOut() {
    Fixture f;
    Recorder recorder = f.recorder();
    auto frames = HapticTrace(3).take(300);
    for (auto& frame : frames)
        frame.tool[0].tissue = {0.0, 0.0, 0.5, 0.0, 0.0, 0.0};
    frames[100].tool[0].tissue[1] = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(recorder.add(frames) && recorder.finish());
    const SecondSummary& s = f.store.summaries()[0];
    QCOMPARE(s.frames, 300u);
    QCOMPARE(s.maximumForce_N, 0.5);
    QVERIFY(near(s.meanForce_N, 0.5));
    QVERIFY(near(s.impulse_Ns, 0.5 * 0.297)); // two of 299 steps touch the bad sample
}

void TestSecondSummaries::clockSetBackReordersNothing() {
    Fixture f;
    Recorder recorder = f.recorder();
    auto frames = HapticTrace(3).take(3000);
    for (std::size_t i = 1500; i < 3000; ++i)
        frames[i].tool[0].deviceTime_us -= 1'400'000;
    QVERIFY(recorder.add(frames) && recorder.finish());
    std::uint32_t counted = 0;
    for (std::size_t i = 0; i < f.store.summaries().size(); ++i) {
        counted += f.store.summaries()[i].frames;
        if (i > 0)
            QVERIFY(f.store.summaries()[i].second > f.store.summaries()[i - 1].second);
    }
    QCOMPARE(counted, 3000u);
}

void TestSecondSummaries::refusedPacketsCountInNothing() {
    const Position position;
    const auto sums = [&](bool withRefused) {
        SecondSummaries summaries(position, 4.0);
        std::vector<SecondSummary> done;
        for (core::HapticFrame frame : HapticTrace(5, 1).take(900)) {
            const bool bad = frame.header.index % 100 == 50;
            if (bad && !withRefused)
                continue;
            if (bad) {
                frame.tool[0].counts[0] += 500'000;
                frame.tool[0].deviceTime_us += 9'000'000'000;
                frame.tool[0].status |= core::sample_status::kRefused;
            }
            summaries.add(frame, done);
        }
        summaries.finish(done);
        return done;
    };
    const auto with = sums(true);
    const auto without = sums(false);
    QCOMPARE(with.size(), without.size());
    for (std::size_t i = 0; i < with.size(); ++i)
        QVERIFY(sameSummary(with[i], without[i]));
}

QTEST_APPLESS_MAIN(TestSecondSummaries)
#include "test_second_summaries.moc"
