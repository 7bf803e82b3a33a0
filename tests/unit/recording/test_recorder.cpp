// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/frame_drain.h"
#include "recording/memory_chunk_store.h"
#include "recording/recording_reader.h"
#include "recording/ring_recovery.h"
#include "recording/wrench_rounding.h"
#include "support/haptic_trace.h"

#include <QTemporaryDir>
#include <QtTest>
#include <map>
#include <thread>

using namespace chiron;
using namespace chiron::recording;

namespace {
struct Position final : IPositionOf {
    core::Vec3 p_WT_m(int, const core::ToolFrame& frame) const noexcept override {
        return 1e-5 * core::Vec3(frame.counts[0], frame.counts[1], frame.counts[2]);
    }
};

/// Refuses while `full`.
struct Sink final : TrialSink {
    explicit Sink(MemoryChunkStore& to) : store(to) {}
    MemoryChunkStore& store;
    bool full = false;
    int calls = 0;
    core::Result<void> write(std::span<const Chunk> chunks, std::span<const SecondSummary> summaries) override {
        ++calls;
        if (full)
            return core::fail(core::ErrorCode::storage, "disk full");
        return store.write(chunks, summaries);
    }
};

struct Fixture {
    explicit Fixture(int tools = 1)
        : table(*ChannelTable::forTools(tests::HapticTrace::channels(tools))), store(table.encode()), sink(store) {
        settings.forceLimit_N = 0.8;
    }
    ChannelTable table;
    MemoryChunkStore store;
    Sink sink;
    Position position;
    RecorderSettings settings;
    Recorder recorder() { return Recorder(table, position, sink, settings); }
};

bool sameSummary(const SecondSummary& a, const SecondSummary& b) {
    return a.second == b.second && a.tool == b.tool && a.frames == b.frames && a.pathLength_m == b.pathLength_m &&
           a.maximumForce_N == b.maximumForce_N && a.meanForce_N == b.meanForce_N && a.impulse_Ns == b.impulse_Ns &&
           a.timeOverLimit_s == b.timeOverLimit_s && a.events == b.events;
}

/// The definition in second_summaries.h, written the long way.
std::vector<SecondSummary> bruteForce(const std::vector<core::HapticFrame>& frames, std::size_t tool, double limit_N) {
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
            static_cast<double>(frames[i].tool[tool].deviceTime_us - frames[i - 1].tool[tool].deviceTime_us) / 1e6;
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

bool near(double a, double b) { return std::abs(a - b) <= 1e-12 * std::max(1.0, std::abs(b)); }
} // namespace

class TestRecorder : public QObject {
    Q_OBJECT
private slots:
    void chunksCloseAtTheirLength();
    void chunksCloseAtTheirAge();
    void summariesMatchBruteForce();
    void knownForceGivesKnownNumbers();
    void pausedSpansCountInNothing();
    void nonFiniteForcesAreLeftOut();
    void clockSetBackReordersNothing();
    void refusedBatchesAreOfferedAgain();
    void refusesOtherToolsAndFramesAfterTheEnd();
    void resumedRecordingEqualsAnUndisturbedOne_data();
    void resumedRecordingEqualsAnUndisturbedOne();
    void ringToStoreLosesNothing();
    void fullSinkFillsTheRingAndIsReported();
    void crashBetweenStoreAndMarkStoresNothingTwice();
    void twoThreads();

private:
    QTemporaryDir m_folder;
    std::int64_t m_session = 0;
    std::unique_ptr<CrashRing> ring(int tools = 1) {
        RingSettings s;
        s.folder = m_folder.path().toStdString();
        s.session = ++m_session;
        s.tools = tools;
        return std::move(*CrashRing::create(s));
    }
};

void TestRecorder::chunksCloseAtTheirLength() {
    Fixture f;
    Recorder recorder = f.recorder();
    const auto frames = tests::HapticTrace(1).take(1050);
    QVERIFY(recorder.add(frames));
    QCOMPARE(recorder.framesCommitted(), std::uint64_t{0});
    QVERIFY(recorder.write());
    QCOMPARE(f.sink.calls, 1); // one batch
    QCOMPARE(f.store.chunkCount(), std::size_t{5});
    QCOMPARE(recorder.framesCommitted(), std::uint64_t{1000});
    QVERIFY(recorder.finish());
    QCOMPARE(recorder.framesCommitted(), std::uint64_t{1050});
    auto reader = RecordingReader::open(f.store);
    QVERIFY(reader);
    const auto read = reader->allFrames();
    QVERIFY(read);
    QCOMPARE(read->size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        QVERIFY(tests::sameFrame((*read)[i], roundedFrame(frames[i])));
    std::uint64_t bytes = 0;
    for (const Chunk& c : f.store.chunks())
        bytes += c.payload.size();
    QCOMPARE(recorder.bytesWritten(), bytes);
    QCOMPARE(recorder.chunksWritten(), 6u);
}

void TestRecorder::chunksCloseAtTheirAge() {
    Fixture f;
    Recorder recorder = f.recorder();
    const auto frames = tests::HapticTrace(1).take(10);
    const std::int64_t first = frames[0].header.now_ns;
    QVERIFY(recorder.add(frames));
    QVERIFY(recorder.closeOld(first + 199'999'999) && recorder.write());
    QCOMPARE(f.store.chunkCount(), std::size_t{0});
    QVERIFY(recorder.closeOld(first + 200'000'000) && recorder.write());
    QCOMPARE(f.store.chunkCount(), std::size_t{1});
    QVERIFY(recorder.closeOld(first + 900'000'000)); // nothing open: nothing to close
    QVERIFY(recorder.write());
    QCOMPARE(f.store.chunkCount(), std::size_t{1});
}

void TestRecorder::summariesMatchBruteForce() {
    Fixture f(2);
    Recorder recorder = f.recorder();
    auto frames = tests::HapticTrace(3, 2).take(4321);
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

// 3 N straight for 1 s at 1 mm a tick along x: path 0.999 m, impulse 2.997 N·s (999 steps), all of it over 0.8 N.
void TestRecorder::knownForceGivesKnownNumbers() {
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

void TestRecorder::pausedSpansCountInNothing() {
    Fixture f;
    Recorder recorder = f.recorder();
    auto frames = tests::HapticTrace(3).take(500);
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

void TestRecorder::nonFiniteForcesAreLeftOut() {
    Fixture f;
    Recorder recorder = f.recorder();
    auto frames = tests::HapticTrace(3).take(300);
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

void TestRecorder::clockSetBackReordersNothing() {
    Fixture f;
    Recorder recorder = f.recorder();
    auto frames = tests::HapticTrace(3).take(3000);
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

void TestRecorder::refusedBatchesAreOfferedAgain() {
    Fixture f, undisturbed;
    Recorder recorder = f.recorder(), other = undisturbed.recorder();
    const auto frames = tests::HapticTrace(3).take(2500);
    const std::span<const core::HapticFrame> all(frames);
    for (std::size_t i = 0; i < 25; ++i) {
        f.sink.full = i % 3 != 0;
        QVERIFY(recorder.add(all.subspan(i * 100, 100)));
        QVERIFY(recorder.write() || f.sink.full);
    }
    QVERIFY(other.add(frames) && other.finish());
    f.sink.full = true;
    QVERIFY(!recorder.finish());
    QVERIFY(!recorder.finish());
    QVERIFY(recorder.framesCommitted() < 2500);
    f.sink.full = false;
    QVERIFY(recorder.finish());
    QCOMPARE(recorder.framesCommitted(), std::uint64_t{2500});
    QCOMPARE(f.store.chunkCount(), undisturbed.store.chunkCount());
    for (std::size_t i = 0; i < f.store.chunkCount(); ++i)
        QVERIFY(f.store.chunks()[i].payloadDigest == undisturbed.store.chunks()[i].payloadDigest);
    QCOMPARE(f.store.summaries().size(), undisturbed.store.summaries().size());
    for (std::size_t i = 0; i < f.store.summaries().size(); ++i)
        QVERIFY(sameSummary(f.store.summaries()[i], undisturbed.store.summaries()[i]));
}

void TestRecorder::refusesOtherToolsAndFramesAfterTheEnd() {
    Fixture f(2);
    Recorder recorder = f.recorder();
    const auto wrong = tests::HapticTrace(1, 1).take(1);
    QCOMPARE(recorder.add(wrong).error().code, core::ErrorCode::wrongUse);
    QVERIFY(recorder.finish());
    QCOMPARE(f.sink.calls, 0); // nothing recorded, nothing written
    QCOMPARE(recorder.add(tests::HapticTrace(1, 2).take(1)).error().code, core::ErrorCode::wrongUse);
}

void TestRecorder::resumedRecordingEqualsAnUndisturbedOne_data() {
    QTest::addColumn<int>("crashAt");
    for (const int at : {0, 1, 199, 200, 201, 999, 1000, 1001, 1234, 2999, 3000})
        QTest::addRow("after %d frames", at) << at;
}

void TestRecorder::resumedRecordingEqualsAnUndisturbedOne() {
    QFETCH(int, crashAt);
    Fixture crashed(2), whole(2);
    const auto frames = tests::HapticTrace(8, 2).take(3000);
    const std::span<const core::HapticFrame> all(frames);
    {
        Recorder recorder = crashed.recorder();
        QVERIFY(recorder.add(all.first(static_cast<std::size_t>(crashAt))) && recorder.write());
    } // died here: the open chunk and the open second are gone, the ring has them
    Recorder resumed = crashed.recorder();
    QVERIFY(resumed.resume(crashed.store));
    const std::size_t ringHad = static_cast<std::size_t>(std::max(0, crashAt - 700));
    QVERIFY(resumed.add(all.subspan(ringHad)) && resumed.finish());
    Recorder recorder = whole.recorder();
    QVERIFY(recorder.add(frames) && recorder.finish());
    auto reader = RecordingReader::open(crashed.store);
    QVERIFY(reader);
    QVERIFY(reader->verify());
    const auto read = reader->allFrames();
    QCOMPARE(read->size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        QVERIFY(tests::sameFrame((*read)[i], roundedFrame(frames[i])));
    QCOMPARE(crashed.store.summaries().size(), whole.store.summaries().size());
    for (std::size_t i = 0; i < whole.store.summaries().size(); ++i)
        QVERIFY(sameSummary(crashed.store.summaries()[i], whole.store.summaries()[i]));
}

void TestRecorder::ringToStoreLosesNothing() {
    Fixture f;
    const auto crashRing = ring();
    Recorder recorder = f.recorder();
    FrameDrain drain(*crashRing, recorder);
    const auto frames = tests::HapticTrace(9).take(6000);
    std::int64_t oldest_ns = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        QVERIFY(crashRing->tryPush(frames[i]));
        if (i % 20 != 19)
            continue;
        QVERIFY(drain.drain(frames[i].header.now_ns));
        const std::uint64_t committed = recorder.framesCommitted();
        if (committed <= i)
            oldest_ns = std::max(oldest_ns, frames[i].header.now_ns - frames[committed].header.now_ns);
    }
    QVERIFY2(oldest_ns <= 250'000'000, "data.md: at most 250 ms until committed");
    QVERIFY(drain.finish());
    QCOMPARE(drain.lost(), std::uint64_t{0});
    QCOMPARE(*RecordingReader::open(f.store)->frameCount(), std::uint64_t{6000});
}

void TestRecorder::fullSinkFillsTheRingAndIsReported() {
    Fixture f;
    const auto crashRing = ring();
    Recorder recorder = f.recorder();
    FrameDrain drain(*crashRing, recorder);
    const auto frames = tests::HapticTrace(9).take(5000);
    f.sink.full = true;
    std::uint64_t kept = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        kept += crashRing->tryPush(frames[i]) ? 1 : 0;
        if (i % 20 == 19 && i > 200)
            QVERIFY(!drain.drain(frames[i].header.now_ns));
    }
    QCOMPARE(kept, std::uint64_t{4096});
    QCOMPARE(drain.lost(), std::uint64_t{5000 - 4096});
    f.sink.full = false;
    QVERIFY(drain.finish());
    QCOMPARE(*RecordingReader::open(f.store)->frameCount(), kept);
    QVERIFY(crashRing->hasRoom());
}

void TestRecorder::crashBetweenStoreAndMarkStoresNothingTwice() {
    Fixture f;
    std::filesystem::path path;
    const auto frames = tests::HapticTrace(9).take(1234);
    {
        const auto crashRing = ring();
        path = crashRing->path();
        Recorder recorder = f.recorder();
        for (const auto& frame : frames)
            crashRing->tryPush(frame);
        RingDrain reader(*crashRing);
        std::vector<core::HapticFrame> read(frames.size());
        QCOMPARE(reader.read(read), frames.size());
        QVERIFY(recorder.add(read) && recorder.write());
        reader.commit(recorder.framesCommitted() - 200); // the mark of the batch before
    }
    auto dead = recoverRing(path);
    QVERIFY(dead);
    Recorder recorder = f.recorder();
    QVERIFY(recorder.resume(f.store));
    QVERIFY(recorder.add(dead->frames()) && recorder.finish());
    QVERIFY(dead->remove());
    auto reader = RecordingReader::open(f.store);
    const auto read = reader->allFrames();
    QCOMPARE(read->size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        QCOMPARE((*read)[i].header.index, frames[i].header.index);
}

void TestRecorder::twoThreads() {
    Fixture f(2);
    const auto crashRing = ring(2);
    Recorder recorder = f.recorder();
    FrameDrain drain(*crashRing, recorder);
    const auto frames = tests::HapticTrace(9, 2).take(15'000);
    std::atomic<bool> ended = false;
    std::thread loop([&] {
        for (const auto& frame : frames) {
            while (!crashRing->hasRoom())
                std::this_thread::yield();
            crashRing->tryPush(frame);
        }
        ended = true;
    });
    bool written = true;
    while (!ended) {
        written = drain.drain(0) && written;
        std::this_thread::yield();
    }
    loop.join();
    QVERIFY(written);
    QVERIFY(drain.finish());
    QCOMPARE(drain.lost(), std::uint64_t{0});
    const auto read = RecordingReader::open(f.store)->allFrames();
    QCOMPARE(read->size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        QVERIFY(tests::sameFrame((*read)[i], roundedFrame(frames[i])));
}

QTEST_APPLESS_MAIN(TestRecorder)
#include "test_recorder.moc"
