// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "recording/byte_cursor.h"
#include "recording/column_decoder.h"
#include "recording/column_encoder.h"
#include "recording/wrench_rounding.h"

#include <QtTest>
#include <bit>
#include <limits>

using namespace chiron;
using namespace chiron::recording;

class TestColumns : public QObject {
    Q_OBJECT
private slots:
    void columnsRoundTrip_data();
    void columnsRoundTrip();
    void modesFitTheirData();
    void repeatingColumnsAreCompressed();
    void roundingGivesTheDoubleOfTheDecimal();
    void roundingIsDefinedForEveryDouble();
};

namespace {
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

void TestColumns::columnsRoundTrip_data() {
    QTest::addColumn<int>("width");
    for (const int width : {0, 1, 2, 3, 7, 8, 9, 13, 16, 31, 32, 33, 47, 56, 57, 58, 61, 63, 64})
        QTest::addRow("%d bits", width) << width;
}

void TestColumns::columnsRoundTrip() {
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

void TestColumns::modesFitTheirData() {
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
    QCOMPARE(modeOf([&](int) { return static_cast<std::int64_t>(random.below(64)); }),
             static_cast<int>(ColumnMode::offset));
    QCOMPARE(modeOf([](int i) { return 1000 * (i / 50) + i % 2; }), static_cast<int>(ColumnMode::difference));
    QCOMPARE(modeOf([](int i) { return i * i; }), static_cast<int>(ColumnMode::secondDifference));
}

void TestColumns::repeatingColumnsAreCompressed() {
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

void TestColumns::roundingGivesTheDoubleOfTheDecimal() {
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

void TestColumns::roundingIsDefinedForEveryDouble() {
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

QTEST_APPLESS_MAIN(TestColumns)
#include "test_columns.moc"
