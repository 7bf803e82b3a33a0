// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "recording/bit_packing.h"
#include "recording/byte_cursor.h"
#include "recording/chunk_decoder.h"
#include "recording/chunk_encoder.h"
#include "recording/column_decoder.h"
#include "recording/column_encoder.h"
#include "recording/digest.h"
#include "recording/wrench_rounding.h"
#include "support/haptic_trace.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using namespace chiron::recording;

class TestChunkCodec : public QObject {
    Q_OBJECT
private slots:
    void columnsRoundTrip_data();
    void columnsRoundTrip();
    void modesFitTheirData();
    void repeatingColumnsAreCompressed();
    void roundingGivesTheDoubleOfTheDecimal();
    void roundingIsDefinedForEveryDouble();
    void randomFramesRoundTrip_data();
    void randomFramesRoundTrip();
    void oneChannelEqualsTheWholeDecode();
    void unknownChannelsAreSkipped();
    void missingChannelsLeaveZero();
    void refusesFramesThatDoNotFit();
    void everyDamagedByteIsAnErrorOrAValue();
    void everyTruncationIsAnError();
    void bombsAreRefused();
    void forceHashSeesEveryBit();
    void payloadDigestCoversHeaderAndHash();
    void aMinuteTakesAnEighteenthOfRows();

private:
    static ChannelTable table(int tools) { return *ChannelTable::forTools(tests::HapticTrace::channels(tools)); }
};

namespace {
std::vector<core::HapticFrame> randomFrames(std::uint64_t seed, int tools, std::size_t count) {
    core::Random random = core::Random::stream(seed, "codec frames");
    std::vector<core::HapticFrame> frames;
    for (std::size_t i = 0; i < count; ++i)
        frames.push_back(tests::randomFrame(random, tools, 40 + i * i));
    return frames;
}

void checkColumn(const std::vector<std::int64_t>& values, bool zstd) {
    ColumnEncoder encoder;
    std::vector<std::uint8_t> bytes;
    encoder.encode(values, zstd, bytes);
    QVERIFY(bytes.size() <= maximumPlainBytes(values.size()));
    ColumnDecoder decoder;
    std::vector<std::int64_t> read(values.size(), -1);
    const auto decoded = decoder.decode(bytes, 0, read);
    QVERIFY2(decoded, decoded ? "" : decoded.error().message.c_str());
    QVERIFY(read == values);
}
} // namespace

void TestChunkCodec::columnsRoundTrip_data() {
    QTest::addColumn<int>("width");
    for (const int width : {0, 1, 2, 3, 7, 8, 9, 13, 16, 31, 32, 33, 47, 56, 57, 58, 61, 63, 64})
        QTest::addRow("%d bits", width) << width;
}

void TestChunkCodec::columnsRoundTrip() {
    QFETCH(int, width);
    core::Random random = core::Random::stream(static_cast<std::uint64_t>(width), "columns");
    const std::uint64_t mask = width == 64 ? ~0ULL : (1ULL << width) - 1;
    for (const std::size_t count : {1u, 2u, 3u, 31u, 32u, 33u, 34u, 64u, 65u, 200u, 4096u}) {
        std::vector<std::int64_t> values;
        std::int64_t walk = 0;
        std::vector<std::int64_t> walked;
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t noise = random.next() & mask;
            values.push_back(static_cast<std::int64_t>(unZigZag(noise)));
            walk = static_cast<std::int64_t>(static_cast<std::uint64_t>(walk) + unZigZag(noise));
            walked.push_back(walk);
        }
        for (const bool zstd : {false, true}) {
            checkColumn(values, zstd);
            checkColumn(walked, zstd);
        }
    }
    constexpr auto kLow = std::numeric_limits<std::int64_t>::min();
    constexpr auto kHigh = std::numeric_limits<std::int64_t>::max();
    checkColumn({kLow, kHigh, kLow, 0, kHigh, -1, kLow}, false);
    checkColumn({kHigh, kLow}, false);
    checkColumn({kLow}, false);
}

void TestChunkCodec::modesFitTheirData() {
    const auto modeOf = [](auto value) {
        std::vector<std::int64_t> values;
        for (int i = 0; i < 200; ++i)
            values.push_back(value(i));
        ColumnEncoder encoder;
        std::vector<std::uint8_t> bytes;
        encoder.encodePlain(values, bytes);
        return static_cast<int>(bytes[0]);
    };
    core::Random random(9);
    QCOMPARE(modeOf([](int) { return 0; }), static_cast<int>(ColumnMode::zero));
    QCOMPARE(modeOf([](int) { return -7; }), static_cast<int>(ColumnMode::constant));
    QCOMPARE(modeOf([](int i) { return 5 + 3 * i; }), static_cast<int>(ColumnMode::line));
    QCOMPARE(modeOf([&](int) { return static_cast<std::int64_t>(random.below(64)); }), static_cast<int>(ColumnMode::offset));
    QCOMPARE(modeOf([](int i) { return 1000 * (i / 50) + i % 2; }), static_cast<int>(ColumnMode::difference));
    QCOMPARE(modeOf([](int i) { return i * i; }), static_cast<int>(ColumnMode::secondDifference));
}

void TestChunkCodec::repeatingColumnsAreCompressed() {
    std::vector<std::int64_t> values;
    for (int i = 0; i < 1000; ++i)
        values.push_back((i % 8) * 12345);
    ColumnEncoder encoder;
    std::vector<std::uint8_t> plain, compressed;
    QVERIFY(!encoder.encode(values, false, plain));
    QVERIFY(encoder.encode(values, true, compressed));
    QCOMPARE(static_cast<int>(compressed[0]), static_cast<int>(ColumnMode::zstd));
    QVERIFY(compressed.size() < plain.size());
    checkColumn(values, true);
}

void TestChunkCodec::roundingGivesTheDoubleOfTheDecimal() {
    const double steps = stepsPerUnit(kForceResolution_N);
    QCOMPARE(steps, 1000.0);
    QCOMPARE(stepsPerUnit(kTorqueResolution_Nm), 100000.0);
    for (int count = -5000; count <= 5000; ++count) { // as printed with three decimals and read back
        const double decimal = QString::number(count / 1000.0, 'f', 3).toDouble();
        QCOMPARE(dequantise(count, steps), decimal);
        QCOMPARE(quantise(decimal, steps), static_cast<std::int64_t>(count));
    }
    QCOMPARE(quantise(1.2344, steps), std::int64_t{1234});
    QCOMPARE(quantise(-1.2346, steps), std::int64_t{-1235});
}

void TestChunkCodec::roundingIsDefinedForEveryDouble() {
    const double inf = std::numeric_limits<double>::infinity();
    QVERIFY(std::isnan(dequantise(quantise(std::numeric_limits<double>::quiet_NaN(), 1000.0), 1000.0)));
    QCOMPARE(dequantise(quantise(inf, 1000.0), 1000.0), inf);
    QCOMPARE(dequantise(quantise(-inf, 1000.0), 1000.0), -inf);
    QCOMPARE(quantise(1e300, 1000.0), kMaximumQuantum);
    QCOMPARE(quantise(-1e300, 1000.0), -kMaximumQuantum);
    core::Random random(3);
    for (int i = 0; i < 100'000; ++i) {
        const auto value = std::bit_cast<double>(random.next());
        const std::int64_t count = quantise(value, 1000.0);
        QVERIFY(count >= -kNaNQuantum && count <= kNaNQuantum);
        QVERIFY(quantise(dequantise(count, 1000.0), 1000.0) == count); // rounding twice is rounding once
    }
}

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
    const auto input = randomFrames(static_cast<std::uint64_t>(tools), tools, static_cast<std::size_t>(frames));
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

// Goal: at least 18 times fewer bytes than one SQLite row of 24 REAL channels a sample, measured as 12.9 MB a minute.
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
