// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/digest.h"
#include "recording/memory_chunk_store.h"
#include "recording/recorder.h"
#include "recording/recording_reader.h"
#include "recording/wrench_rounding.h"
#include "support/haptic_trace.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::recording;

namespace {
struct Nowhere final : IPositionOf {
    core::Vec3 p_WT_m(int, const core::ToolFrame&) const noexcept override { return core::Vec3::Zero(); }
};

/// A recording whose loop dropped frames 500..549.
struct Recorded {
    explicit Recorded(int tools = 1)
        : table(*ChannelTable::forTools(tests::HapticTrace::channels(tools))), store(table.encode()) {
        frames = tests::HapticTrace(21, tools).take(1700);
        frames.erase(frames.begin() + 500, frames.begin() + 550);
        const Nowhere position;
        Recorder recorder(table, position, store, {});
        ok = recorder.add(frames) && recorder.finish();
    }
    ChannelTable table;
    MemoryChunkStore store;
    std::vector<core::HapticFrame> frames;
    bool ok = false;
};
} // namespace

class TestRecordingReader : public QObject {
    Q_OBJECT
private slots:
    void seekFindsEveryTick();
    void channelsEqualFrames();
    void hashesAreThoseOfTheUnroundedForces();
    void damagedChunksAreNamed();
    void swappedAndMissingChunksAreFound();
    void verifyReadsEverythingAgain();
    void damagedTableIsRefused();
    void emptyRecordingIsFine();
};

void TestRecordingReader::seekFindsEveryTick() {
    Recorded r(2);
    QVERIFY(r.ok);
    auto reader = RecordingReader::open(r.store);
    QVERIFY(reader);
    QCOMPARE(*reader->frameCount(), std::uint64_t{1650});
    QCOMPARE(reader->tools(), 2);
    for (std::size_t i = 0; i < r.frames.size(); i += 7) {
        const auto frame = reader->frameAtTick(r.frames[i].header.index);
        QVERIFY2(frame, frame ? "" : frame.error().message.c_str());
        QVERIFY(tests::sameFrame(*frame, roundedFrame(r.frames[i])));
    }
    for (const std::uint64_t missing :
         {std::uint64_t{500}, std::uint64_t{549}, std::uint64_t{1700}, ~std::uint64_t{0}})
        QCOMPARE(reader->frameAtTick(missing).error().code, core::ErrorCode::notFound);
}

void TestRecordingReader::channelsEqualFrames() {
    Recorded r(2);
    auto reader = RecordingReader::open(r.store);
    const auto forces = reader->channelValues(1, "tissue.fz");
    const auto commanded = reader->channelValues(1, "commanded.fz");
    const auto roll = reader->channelValues(0, "axis.roll");
    const auto now = reader->channelCounts(kNoTool, "now");
    QVERIFY(forces && commanded && roll && now);
    QCOMPARE(forces->size(), r.frames.size());
    for (std::size_t i = 0; i < r.frames.size(); ++i) {
        const auto rounded = roundedFrame(r.frames[i]);
        QCOMPARE((*forces)[i], rounded.tool[1].tissue[2]);
        QCOMPARE((*commanded)[i], rounded.tool[1].commanded[2]);
        QCOMPARE((*roll)[i], 1e-4 * r.frames[i].tool[0].counts[3]);
        QCOMPARE((*now)[i], r.frames[i].header.now_ns);
    }
    QCOMPARE(reader->channelCounts(0, "temperature").error().code, core::ErrorCode::notFound);
    QCOMPARE(reader->channelCounts(3, "axis.x").error().code, core::ErrorCode::notFound);
}

void TestRecordingReader::hashesAreThoseOfTheUnroundedForces() {
    Recorded r;
    auto reader = RecordingReader::open(r.store);
    std::size_t first = 0;
    for (std::size_t i = 0; i < reader->chunkCount(); ++i) {
        const std::size_t frames = reader->framesOf(i)->size();
        const auto span = std::span(r.frames).subspan(first, frames);
        QCOMPARE(*reader->forceHash(i), forceHashOf(span));
        first += frames;
    }
}

void TestRecordingReader::damagedChunksAreNamed() {
    Recorded r;
    core::Random random(1);
    for (int i = 0; i < 300; ++i) {
        MemoryChunkStore damaged = r.store;
        const std::size_t which = random.below(damaged.chunkCount());
        auto& payload = damaged.chunks()[which].payload;
        payload[random.below(payload.size())] ^= static_cast<std::uint8_t>(1u << random.below(8));
        auto reader = RecordingReader::open(damaged);
        QVERIFY(reader);
        const auto verified = reader->verify();
        QVERIFY(!verified);
        QCOMPARE(verified.error().code, core::ErrorCode::doesNotHold);
        QVERIFY(verified.error().message.starts_with("chunk " + std::to_string(which) + ":"));
        QVERIFY(!reader->frameAtTick(damaged.chunks()[which].firstTick));
        QVERIFY(!reader->channelCounts(kNoTool, "tick"));
        QVERIFY(!reader->allFrames());
    }
    auto reader = RecordingReader::open(r.store);
    QVERIFY(reader->verify());
}

void TestRecordingReader::swappedAndMissingChunksAreFound() {
    Recorded r;
    MemoryChunkStore swapped = r.store;
    std::swap(swapped.chunks()[2], swapped.chunks()[3]);
    const auto found = RecordingReader::open(swapped)->verify();
    QVERIFY(!found);
    QCOMPARE(found.error().code, core::ErrorCode::doesNotHold);
    MemoryChunkStore renumbered = r.store; // splice: the number fits, the digest does not
    std::swap(renumbered.chunks()[2].payload, renumbered.chunks()[3].payload);
    QVERIFY(!RecordingReader::open(renumbered)->verify());
    MemoryChunkStore missing = r.store;
    missing.chunks().erase(missing.chunks().begin() + 4);
    const auto refused = RecordingReader::open(missing)->verify();
    QVERIFY(!refused);
    QVERIFY(refused.error().message.find("expected 4") != std::string::npos);
}

/// A chunk is checked when it is first used; verify() takes nothing for sound that was sound once.
void TestRecordingReader::verifyReadsEverythingAgain() {
    Recorded r;
    auto reader = RecordingReader::open(r.store);
    QVERIFY(reader && reader->allFrames() && reader->verify());
    r.store.chunks()[2].payloadDigest[0] ^= 1; // the frames decode as before: only the digest tells
    const auto verified = reader->verify();
    QVERIFY(!verified);
    QCOMPARE(verified.error().code, core::ErrorCode::doesNotHold);
    QVERIFY2(verified.error().message.starts_with("chunk 2:"), verified.error().message.c_str());
}

void TestRecordingReader::damagedTableIsRefused() {
    auto bytes = ChannelTable::forTools(tests::HapticTrace::channels(1))->encode();
    bytes[0] ^= 1;
    MemoryChunkStore store(bytes);
    QCOMPARE(RecordingReader::open(store).error().code, core::ErrorCode::badInput);
}

void TestRecordingReader::emptyRecordingIsFine() {
    MemoryChunkStore store(ChannelTable::forTools(tests::HapticTrace::channels(1))->encode());
    auto reader = RecordingReader::open(store);
    QVERIFY(reader);
    QCOMPARE(*reader->frameCount(), std::uint64_t{0});
    QVERIFY(reader->allFrames()->empty());
    QVERIFY(reader->channelCounts(kNoTool, "tick")->empty());
    QVERIFY(reader->verify());
    QCOMPARE(reader->frameAtTick(0).error().code, core::ErrorCode::notFound);
}

QTEST_APPLESS_MAIN(TestRecordingReader)
#include "test_recording_reader.moc"
