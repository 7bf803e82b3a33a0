// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/frame_drain.h"
#include "recording/recording_reader.h"
#include "recording/ring_recovery.h"
#include "recording/wrench_rounding.h"
#include "unit/recording/recorder_support.h"

#include <QTemporaryDir>
#include <QtTest>
#include <atomic>
#include <thread>

using namespace chiron;
using namespace chiron::recording;
using namespace chiron::tests;

class TestRecorder : public QObject {
    Q_OBJECT
private slots:
    void chunksCloseAtTheirLength();
    void chunksCloseAtTheirAge();
    void refusedBatchesAreOfferedAgain();
    void refusesOtherToolsAndFramesAfterTheEnd();
    void resumedRecordingEqualsAnUndisturbedOne_data();
    void resumedRecordingEqualsAnUndisturbedOne();
    void ringToStoreLosesNothing();
    void fullSinkFillsTheRingAndIsReported();
    void framesThatWereNotTakenAreOfferedAgain_data();
    void framesThatWereNotTakenAreOfferedAgain();
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
    const auto frames = HapticTrace(1).take(1050);
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
        QVERIFY(sameFrame((*read)[i], roundedFrame(frames[i])));
    std::uint64_t bytes = 0;
    for (const Chunk& c : f.store.chunks())
        bytes += c.payload.size();
    QCOMPARE(recorder.bytesWritten(), bytes);
    QCOMPARE(recorder.chunksWritten(), 6u);
}

void TestRecorder::chunksCloseAtTheirAge() {
    Fixture f;
    Recorder recorder = f.recorder();
    const auto frames = HapticTrace(1).take(10);
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

void TestRecorder::refusedBatchesAreOfferedAgain() {
    Fixture f, undisturbed;
    Recorder recorder = f.recorder(), other = undisturbed.recorder();
    const auto frames = HapticTrace(3).take(2500);
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
    const auto wrong = HapticTrace(1, 1).take(1);
    QCOMPARE(recorder.add(wrong).error().code, core::ErrorCode::wrongUse);
    QVERIFY(recorder.finish());
    QCOMPARE(f.sink.calls, 0); // nothing recorded, nothing written
    QCOMPARE(recorder.add(HapticTrace(1, 2).take(1)).error().code, core::ErrorCode::wrongUse);
    // Of a batch, what comes before the refused frame is taken, and the count says so.
    Fixture other(1);
    Recorder partly = other.recorder();
    auto frames = HapticTrace(1, 1).take(5);
    frames[3].tools = 2;
    QVERIFY(!partly.add(frames));
    QCOMPARE(partly.framesTaken(), std::uint64_t{3});
    frames[3].tools = 1;
    QVERIFY(partly.add(std::span(frames).subspan(3)));
    QVERIFY(partly.finish());
    QCOMPARE(*RecordingReader::open(other.store)->frameCount(), std::uint64_t{5});
}

void TestRecorder::resumedRecordingEqualsAnUndisturbedOne_data() {
    QTest::addColumn<int>("crashAt");
    for (const int at : {0, 1, 199, 200, 201, 999, 1000, 1001, 1234, 2999, 3000})
        QTest::addRow("after %d frames", at) << at;
}

void TestRecorder::resumedRecordingEqualsAnUndisturbedOne() {
    QFETCH(int, crashAt);
    Fixture crashed(2), whole(2);
    const auto frames = HapticTrace(8, 2).take(3000);
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
        QVERIFY(sameFrame((*read)[i], roundedFrame(frames[i])));
    QCOMPARE(crashed.store.summaries().size(), whole.store.summaries().size());
    for (std::size_t i = 0; i < whole.store.summaries().size(); ++i)
        QVERIFY(sameSummary(crashed.store.summaries()[i], whole.store.summaries()[i]));
}

void TestRecorder::ringToStoreLosesNothing() {
    Fixture f;
    const auto crashRing = ring();
    Recorder recorder = f.recorder();
    FrameDrain drain(*crashRing, recorder);
    const auto frames = HapticTrace(9).take(6000);
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
    const auto frames = HapticTrace(9).take(5000);
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

void TestRecorder::framesThatWereNotTakenAreOfferedAgain_data() {
    QTest::addColumn<int>("frames");
    QTest::addRow("one batch") << 10;
    QTest::addRow("many batches") << 700;
}

/// What the recorder refused once it refuses again, so that no end of a session passes for a complete one:
/// the ring's file stays, and the frames can be recovered from it.
void TestRecorder::framesThatWereNotTakenAreOfferedAgain() {
    QFETCH(int, frames);
    std::filesystem::path path;
    {
        Fixture f(2); // the table has two tools, the ring one
        const auto crashRing = ring();
        path = crashRing->path();
        Recorder recorder = f.recorder();
        FrameDrain drain(*crashRing, recorder);
        for (const auto& frame : HapticTrace(9).take(static_cast<std::size_t>(frames)))
            QVERIFY(crashRing->tryPush(frame));
        for (int again = 0; again < 20; ++again) {
            const auto drained = drain.drain(0);
            QVERIFY(!drained && drained.error().code == core::ErrorCode::wrongUse);
        }
        QVERIFY(!drain.finish());
        QVERIFY(!drain.finish());
        QCOMPARE(recorder.framesTaken(), std::uint64_t{0});
    }
    auto left = recoverRing(path);
    QVERIFY(left);
    QCOMPARE(left->frames().size(), static_cast<std::size_t>(frames));
    QVERIFY(left->remove());

    Fixture ended; // frames that come after the end
    const auto late = ring();
    Recorder closed = ended.recorder();
    FrameDrain lateDrain(*late, closed);
    QVERIFY(lateDrain.finish());
    QVERIFY(late->tryPush(HapticTrace(9).take(1).front()));
    QVERIFY(!lateDrain.finish());
    QVERIFY(!lateDrain.finish());
}

void TestRecorder::crashBetweenStoreAndMarkStoresNothingTwice() {
    Fixture f;
    std::filesystem::path path;
    const auto frames = HapticTrace(9).take(1234);
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
    const auto frames = HapticTrace(9, 2).take(15'000);
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
        QVERIFY(sameFrame((*read)[i], roundedFrame(frames[i])));
}

QTEST_APPLESS_MAIN(TestRecorder)
#include "test_recorder.moc"
