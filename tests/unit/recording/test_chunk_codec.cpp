// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "recording/byte_cursor.h"
#include "recording/chunk_decoder.h"
#include "recording/chunk_encoder.h"
#include "recording/column_decoder.h"
#include "recording/digest.h"
#include "recording/wrench_rounding.h"
#include "support/haptic_trace.h"

#include <QtTest>
#include <limits>
#include <set>

using namespace chiron;
using namespace chiron::recording;

class TestChunkCodec : public QObject {
    Q_OBJECT
private slots:
    void randomFramesRoundTrip_data();
    void randomFramesRoundTrip();
    void oneChannelEqualsTheWholeDecode();
    void channelsAtRestCostTwoBytes();
    void unknownChannelsAreSkipped();
    void missingChannelsLeaveZero();
    void refusesFramesThatDoNotFit();
    void aChunkMayBeAsLargeAsItsLimits();
    void everyDamagedByteIsAnErrorOrAValue();
    void everyTruncationIsAnError();
    void bombsAreRefused();
    void forceHashSeesEveryBit();
    void forceHashFillsItsBufferToTheBrim();
    void payloadDigestCoversHeaderAndHash();
    void aMinuteTakesAnEighteenthOfRows();

private:
    static ChannelTable table(int tools) {
        return *ChannelTable::forTools(tests::HapticTrace::channels(tools));
    }
};

namespace {
std::vector<core::HapticFrame> randomFrames(std::uint64_t seed, int tools, std::size_t count) {
    core::Random random = core::Random::stream(seed, "codec frames");
    std::vector<core::HapticFrame> frames;
    for (std::size_t i = 0; i < count; ++i)
        frames.push_back(tests::randomFrame(random, tools, 40 + i * i));
    return frames;
}
} // namespace

void TestChunkCodec::randomFramesRoundTrip_data() {
    QTest::addColumn<int>("tools");
    QTest::addColumn<int>("frames");
    for (int tools = 1; tools <= core::kMaxTools; ++tools)
        for (const int frames : {1, 2, 3, 32, 33, 199, 200})
            QTest::addRow("%d tools, %d frames", tools, frames) << tools << frames;
}

void TestChunkCodec::randomFramesRoundTrip() {
    QFETCH(int, tools);
    QFETCH(int, frames);
    const auto input =
        randomFrames(static_cast<std::uint64_t>(tools), tools, static_cast<std::size_t>(frames));
    const auto chunk = ChunkEncoder(table(tools)).encode(16, input);
    QVERIFY(chunk);
    QCOMPARE(chunk->firstTick, input.front().header.index);
    ChunkDecoder decoder(table(tools));
    std::vector<core::HapticFrame> read;
    const auto decoded = decoder.decode(*chunk, read);
    QVERIFY2(decoded, decoded ? "" : decoded.error().message.c_str());
    QCOMPARE(read.size(), input.size());
    for (std::size_t i = 0; i < input.size(); ++i)
        QVERIFY(tests::sameFrame(read[i], roundedFrame(input[i])));
    const auto last = decoder.decodeTick(*chunk, input.back().header.index);
    QVERIFY(last && tests::sameFrame(*last, read.back()));
    QCOMPARE(decoder.decodeTick(*chunk, 1'000'000).error().code, core::ErrorCode::notFound);
}

void TestChunkCodec::oneChannelEqualsTheWholeDecode() {
    const auto input = tests::HapticTrace(4, 2).take(200);
    const auto chunk = ChunkEncoder(table(2)).encode(0, input);
    ChunkDecoder decoder(table(2));
    const auto& channels = decoder.table().channels();
    for (std::size_t c = 0; c < channels.size(); ++c) {
        std::vector<std::int64_t> counts, expected(input.size());
        QVERIFY(decoder.decodeChannel(*chunk, c, counts));
        gather(fieldOf(channels[c]), input, expected);
        QVERIFY2(counts == expected, channels[c].id.c_str());
    }
}

// Commanded and measured refer to tissue; while force is off they stay zero though tissue moves.
void TestChunkCodec::channelsAtRestCostTwoBytes() {
    auto input = tests::HapticTrace(4).take(200);
    const auto moving = ChunkEncoder(table(1)).encode(0, input);
    for (core::HapticFrame& frame : input) {
        frame.tool[0].commanded = frame.tool[0].tissue;
        frame.tool[0].measured = {};
    }
    const auto passedOn = ChunkEncoder(table(1)).encode(0, input);
    for (core::HapticFrame& frame : input)
        frame.tool[0].commanded = {};
    const auto off = ChunkEncoder(table(1)).encode(0, input);
    QCOMPARE(off->payload.size(),
             passedOn->payload.size()); // a byte of length and a byte of mode a column either way
    QVERIFY(off->payload.size() + 6 * 100 < moving->payload.size());
    ChunkDecoder decoder(table(1));
    std::vector<core::HapticFrame> read;
    std::vector<std::int64_t> counts;
    QVERIFY(decoder.decode(*off, read));
    QVERIFY(decoder.decodeChannel(*off, *decoder.table().find(0, "commanded.fz"), counts));
    for (std::size_t i = 0; i < input.size(); ++i) {
        QVERIFY(tests::sameFrame(read[i], roundedFrame(input[i])));
        QCOMPARE(counts[i], std::int64_t{0});
    }
}

void TestChunkCodec::unknownChannelsAreSkipped() {
    auto channels = table(1).channels();
    Channel future;
    future.tool = 0;
    future.id = "temperature"; // something that a later version records
    future.unit = "K";
    channels.push_back(future);
    std::rotate(channels.begin(), channels.begin() + 2, channels.begin() + 5); // and in another order
    for (Channel& c : channels)
        c.reference = kNoReference;
    const auto other = ChannelTable::fromChannels(channels);
    QVERIFY(other);
    const auto input = tests::HapticTrace(5).take(50);
    const auto chunk = ChunkEncoder(*other).encode(0, input);
    std::vector<core::HapticFrame> read;
    QVERIFY(ChunkDecoder(*other).decode(*chunk, read));
    for (std::size_t i = 0; i < input.size(); ++i)
        QVERIFY(tests::sameFrame(read[i], roundedFrame(input[i])));
}

void TestChunkCodec::missingChannelsLeaveZero() {
    auto channels = table(1).channels();
    const auto known = table(1).find(0, "measured.fz");
    QVERIFY(known);
    channels.erase(channels.begin() + static_cast<std::ptrdiff_t>(*known));
    const auto fewer = ChannelTable::fromChannels(channels);
    QVERIFY(fewer);
    const auto input = tests::HapticTrace(6).take(20);
    const auto chunk = ChunkEncoder(*fewer).encode(0, input);
    std::vector<core::HapticFrame> read;
    QVERIFY(ChunkDecoder(*fewer).decode(*chunk, read));
    QCOMPARE(read[7].tool[0].measured[2], 0.0);
    QCOMPARE(read[7].tool[0].measured[1], roundedFrame(input[7]).tool[0].measured[1]);
}

void TestChunkCodec::refusesFramesThatDoNotFit() {
    ChunkEncoder encoder(table(2));
    QCOMPARE(encoder.encode(0, {}).error().code, core::ErrorCode::wrongUse);
    QCOMPARE(encoder.encode(0, tests::HapticTrace(1, 1).take(3)).error().code, core::ErrorCode::wrongUse);
    QVERIFY(encoder.encode(0, tests::HapticTrace(1, 2).take(kMaximumFramesPerChunk)));
    QVERIFY(!encoder.encode(0, tests::HapticTrace(1, 2).take(kMaximumFramesPerChunk + 1)));
}

/// The most frames that a chunk may have come back; a payload of the largest size is read, and one byte more
/// is refused for its size.
void TestChunkCodec::aChunkMayBeAsLargeAsItsLimits() {
    const auto input = tests::HapticTrace(1).take(kMaximumFramesPerChunk);
    const auto chunk = ChunkEncoder(table(1)).encode(0, input);
    QVERIFY(chunk);
    std::vector<core::HapticFrame> read;
    QVERIFY(ChunkDecoder(table(1)).decode(*chunk, read));
    QCOMPARE(read.size(), input.size());
    QVERIFY(tests::sameFrame(read.back(), roundedFrame(input.back())));
    Chunk large;
    large.frames = 1;
    for (const std::size_t more : {std::size_t{0}, std::size_t{1}}) {
        large.payload.resize(kMaximumPayloadBytes + more);
        const auto refused = ChunkDecoder(table(1)).decode(large, read); // its first byte is no version
        QVERIFY(!refused);
        QCOMPARE(refused.error().message.find("expected at most") != std::string::npos, more == 1);
    }
}

void TestChunkCodec::everyDamagedByteIsAnErrorOrAValue() {
    const auto chunk = ChunkEncoder(table(1)).encode(0, tests::HapticTrace(7).take(40));
    ChunkDecoder decoder(table(1));
    core::Random random(8);
    int errors = 0;
    for (std::size_t at = 0; at < chunk->payload.size(); ++at) {
        for (int i = 0; i < 10; ++i) {
            Chunk damaged = *chunk;
            damaged.payload[at] ^= static_cast<std::uint8_t>(i < 8 ? 1 << i : 1 + random.below(255));
            std::vector<core::HapticFrame> read;
            const auto decoded = decoder.decode(damaged, read);
            QVERIFY(payloadDigestOf(damaged) != chunk->payloadDigest); // the digest sees every one
            if (decoded)
                continue;
            ++errors;
            QVERIFY(read.empty());
            QVERIFY(decoded.error().message.find("byte ") != std::string::npos);
            QVERIFY(decoded.error().message.find("expected") != std::string::npos);
        }
    }
    QVERIFY(errors > 0);
}

void TestChunkCodec::everyTruncationIsAnError() {
    const auto chunk = ChunkEncoder(table(1)).encode(0, tests::HapticTrace(7).take(40));
    ChunkDecoder decoder(table(1));
    for (std::size_t length = 0; length < chunk->payload.size(); ++length) {
        Chunk shorter = *chunk;
        shorter.payload.resize(length);
        std::vector<core::HapticFrame> read;
        QVERIFY(!decoder.decode(shorter, read));
        std::vector<std::int64_t> counts;
        QVERIFY(!decoder.decodeChannel(shorter, 0, counts));
    }
    Chunk longer = *chunk;
    longer.payload.push_back(0);
    std::vector<core::HapticFrame> read;
    QVERIFY(!decoder.decode(longer, read));
}

void TestChunkCodec::bombsAreRefused() {
    // A zstd frame of 64 MiB of zeros takes some kilobytes; a column of 200 values never asks for it.
    std::vector<std::int64_t> values(200);
    std::vector<std::uint8_t> column = {16};
    appendVarint(column, 64 << 20);
    column.insert(column.end(), {0x28, 0xB5, 0x2F, 0xFD, 0xA0, 0, 0, 0, 4, 0, 0, 0}); // says 64 MiB
    ColumnDecoder decoder;
    QVERIFY(!decoder.decode(column, 0, values));
    column.assign({16});
    appendVarint(column, 100); // a short length does not let a longer frame through
    column.insert(column.end(), {0x28, 0xB5, 0x2F, 0xFD, 0xA0, 0, 0, 0, 4, 0, 0, 0});
    QVERIFY(!decoder.decode(column, 0, values));
    Chunk many = *ChunkEncoder(table(1)).encode(0, tests::HapticTrace(1).take(10));
    many.frames = 0xffffffff;
    std::vector<core::HapticFrame> read;
    QVERIFY(!ChunkDecoder(table(1)).decode(many, read));
    Chunk large;
    large.frames = 1;
    large.payload.resize(kMaximumPayloadBytes + 1);
    QVERIFY(!ChunkDecoder(table(1)).decode(large, read));
}

void TestChunkCodec::forceHashSeesEveryBit() {
    auto frames = tests::HapticTrace(2, 2).take(3);
    const Digest before = forceHashOf(frames);
    for (const std::size_t quantity : {std::size_t{0}, core::kMaxQuantities - 1}) {
        frames.back().header.quantities[quantity] = 1e-12;
        QVERIFY(forceHashOf(frames) != before);
        frames.back().header.quantities[quantity] = 0.0;
    }
    QCOMPARE(forceHashOf(frames), before);
    for (std::size_t t = 0; t < 2; ++t)
        for (std::size_t i = 0; i < 6; ++i)
            for (double* value : {&frames[1].tool[t].tissue[i], &frames[1].tool[t].commanded[i]}) {
                const double kept = *value;
                *value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(kept) ^ 1); // below any rounding
                QVERIFY(forceHashOf(frames) != before);
                *value = kept;
            }
    frames[1].tool[0].measured[0] += 1.0; // not a model's answer: a replay has no plant to measure
    QCOMPARE(forceHashOf(frames), before);
}

/// Frames of 2 to 98 bytes reach every filling of the buffer; the address sanitizer sees a byte beyond it.
void TestChunkCodec::forceHashFillsItsBufferToTheBrim() {
    std::set<Digest> seen;
    for (std::size_t few = 0; few <= 12; ++few) {
        std::vector<core::HapticFrame> frames(120);
        for (std::size_t n = 0; n < frames.size(); ++n) {
            frames[n].tools = 1;
            for (std::size_t i = 0; i < (n < few ? 1U : 12U); ++i)
                (i < 6 ? frames[n].tool[0].tissue[i] : frames[n].tool[0].commanded[i - 6]) =
                    1.0 + static_cast<double>(i + n);
        }
        QVERIFY(seen.insert(forceHashOf(frames)).second);
    }
}

void TestChunkCodec::payloadDigestCoversHeaderAndHash() {
    const Chunk chunk = *ChunkEncoder(table(1)).encode(3, tests::HapticTrace(2).take(9));
    QCOMPARE(payloadDigestOf(chunk), chunk.payloadDigest);
    Chunk other = chunk;
    other.sequence ^= 1;
    QVERIFY(payloadDigestOf(other) != chunk.payloadDigest);
    other = chunk;
    other.firstTick ^= 1;
    QVERIFY(payloadDigestOf(other) != chunk.payloadDigest);
    other = chunk;
    other.frames ^= 1;
    QVERIFY(payloadDigestOf(other) != chunk.payloadDigest);
    other = chunk;
    other.forceHash[31] ^= 1;
    QVERIFY(payloadDigestOf(other) != chunk.payloadDigest);
}

// Goal: at least 18 times fewer bytes than one SQLite row of 24 REAL channels a sample, measured as 12.9 MB a
// minute.
void TestChunkCodec::aMinuteTakesAnEighteenthOfRows() {
    constexpr double kRowBytes = 12.9e6;
    tests::HapticTrace trace(11);
    ChunkEncoder encoder(table(1));
    std::size_t bytes = 0;
    for (std::uint32_t sequence = 0; sequence < 300; ++sequence) {
        const auto chunk = encoder.encode(sequence, trace.take(200));
        bytes += chunk->payload.size() + sizeof(chunk->payloadDigest) + sizeof(chunk->forceHash);
    }
    qInfo("%.3f MB a minute, %.1f times less than rows", static_cast<double>(bytes) * 1e-6,
          kRowBytes / static_cast<double>(bytes));
    QVERIFY(kRowBytes / static_cast<double>(bytes) >= 18.0);
}

QTEST_APPLESS_MAIN(TestChunkCodec)
#include "test_chunk_codec.moc"
