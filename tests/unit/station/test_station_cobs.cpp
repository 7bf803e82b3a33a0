// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/protocol/station_cobs.h"
#include "unit/station/station_samples.h"

#include <QtTest>
#include <algorithm>
#include <vector>

using namespace chiron;
using namespace chiron::test;

namespace {

using Line = std::vector<std::uint8_t>;

struct Heard {
    std::vector<StationFrame> frames; ///< with a right CRC
    int broken = 0;
    int badCrc = 0;
};

Heard hear(const Line& line) {
    station_cobs decoder;
    station_cobs_begin(&decoder);
    Heard heard;
    for (const std::uint8_t byte : line) {
        StationFrame frame{};
        switch (station_cobs_take(&decoder, byte, frame.data())) {
        case STATION_COBS_NOTHING:
            break;
        case STATION_COBS_BROKEN:
            ++heard.broken;
            break;
        case STATION_COBS_FRAME:
            if (station_check_crc(frame.data()) == STATION_OK)
                heard.frames.push_back(frame);
            else
                ++heard.badCrc;
        }
    }
    return heard;
}

Line encoded(const StationFrame& frame) {
    Line line(STATION_COBS_SIZE);
    station_cobs_encode(frame.data(), line.data());
    return line;
}

StationFrame randomFrame(core::Random& random) {
    StationFrame frame{};
    fillRandomly(random, frame.data(), frame.size());
    const std::uint64_t zeros = random.below(40);
    for (std::uint64_t i = 0; i < zeros; ++i)
        frame[random.below(frame.size())] = 0;
    return sealed(frame);
}

} // namespace

class TestStationCobs : public QObject {
    Q_OBJECT
private slots:
    void theBytesAreThoseOfTheMethod();
    void framesComeBackWithoutAZeroWithin();
    void emptyBlocksAreNothing();
    void blocksOfAnotherLengthAreBroken();
    void aBrokenDistanceIsBroken();
    void inStepAgainAtTheNextZero();
    void noiseHarmsOnlyWhatItTouches();
};

void TestStationCobs::theBytesAreThoseOfTheMethod() {
    StationFrame frame{};
    Line expected(STATION_COBS_SIZE, 1); // 64 zeros: each a distance of 1, and the last
    expected.back() = 0;
    QCOMPARE(encoded(frame), expected);
    for (std::size_t i = 0; i < frame.size(); ++i)
        frame[i] = static_cast<std::uint8_t>(i + 1);
    expected = {65};
    for (std::uint8_t i = 1; i <= 64; ++i)
        expected.push_back(i);
    expected.push_back(0);
    QCOMPARE(encoded(frame), expected);
    frame[0] = 0;
    frame[10] = 0;
    expected[0] = 1;
    expected[1] = 10;
    expected[11] = 54;
    QCOMPARE(encoded(frame), expected);
    frame[63] = 0;
    expected[11] = 53;
    expected[64] = 1;
    QCOMPARE(encoded(frame), expected);
}

void TestStationCobs::framesComeBackWithoutAZeroWithin() {
    core::Random random(11);
    for (int i = 0; i < 20000; ++i) {
        const StationFrame frame = randomFrame(random);
        const Line line = encoded(frame);
        QCOMPARE(std::count(line.begin(), line.end(), 0), 1);
        QCOMPARE(int(line.back()), 0);
        const Heard heard = hear(line);
        QCOMPARE(heard.broken, 0);
        QCOMPARE(heard.frames, std::vector{frame});
    }
}

void TestStationCobs::emptyBlocksAreNothing() {
    core::Random random(12);
    const StationFrame frame = randomFrame(random);
    Line line{0, 0, 0};
    const Line one = encoded(frame);
    line.insert(line.end(), one.begin(), one.end());
    line.insert(line.end(), {0, 0});
    line.insert(line.end(), one.begin(), one.end());
    const Heard heard = hear(line);
    QCOMPARE(heard.broken, 0);
    QCOMPARE(heard.frames, (std::vector{frame, frame}));
}

void TestStationCobs::blocksOfAnotherLengthAreBroken() {
    core::Random random(13);
    const StationFrame frame = randomFrame(random);
    const Line good = encoded(frame);
    for (std::size_t length = 1; length < 700; ++length) { // far beyond what the length is counted in
        if (length == STATION_COBS_BLOCK)
            continue;
        Line line;
        for (std::size_t i = 0; i < length; ++i)
            line.push_back(static_cast<std::uint8_t>(1 + random.below(255)));
        line.push_back(0);
        line.insert(line.end(), good.begin(), good.end());
        const Heard heard = hear(line);
        QCOMPARE(heard.broken, 1);
        QCOMPARE(heard.frames, std::vector{frame});
    }
}

void TestStationCobs::aBrokenDistanceIsBroken() {
    StationFrame frame{};
    frame.fill(7);
    Line line = encoded(frame);
    for (int first = 1; first < 256; ++first) {
        line[0] = static_cast<std::uint8_t>(first);
        const Heard heard = hear(line);
        // 65 ends the block; 7s on the way from a smaller one lead to the end or beyond it.
        const int next = first >= 65 ? first : first + 7 * ((65 - first + 6) / 7);
        QCOMPARE(heard.broken, next == 65 ? 0 : 1);
    }
}

void TestStationCobs::inStepAgainAtTheNextZero() {
    core::Random random(14);
    for (int round = 0; round < 3000; ++round) { // good, hurt, good: the two good ones are always heard
        const StationFrame before = randomFrame(random), hurt = randomFrame(random),
                           after = randomFrame(random);
        Line middle = encoded(hurt);
        middle.pop_back(); // its 0x00 stays: what comes after begins there
        const std::size_t at = random.below(middle.size());
        switch (random.below(4)) {
        case 0: // cut
            middle.erase(middle.begin() + static_cast<std::ptrdiff_t>(at),
                         middle.begin() +
                             static_cast<std::ptrdiff_t>(at + 1 + random.below(middle.size() - at)));
            break;
        case 1: // doubled
            middle.insert(middle.begin() + static_cast<std::ptrdiff_t>(at), middle[at]);
            break;
        case 2: // changed, into a 0x00, too
            middle[at] ^= static_cast<std::uint8_t>(1 + random.below(255));
            break;
        default: // begun in the middle
            middle.erase(middle.begin(), middle.begin() + static_cast<std::ptrdiff_t>(at));
        }
        Line line = encoded(before);
        line.insert(line.end(), middle.begin(), middle.end());
        line.push_back(0);
        const Line last = encoded(after);
        line.insert(line.end(), last.begin(), last.end());
        const Heard heard = hear(line);
        QVERIFY(heard.frames.size() >= 2);
        QCOMPARE(heard.frames.front(), before);
        QCOMPARE(heard.frames.back(), after);
        if (heard.frames.size() == 3) // a cut or a beginning of nothing at all
            QCOMPARE(heard.frames[1], hurt);
    }
}

void TestStationCobs::noiseHarmsOnlyWhatItTouches() {
    core::Random random(15);
    Line line;
    std::vector<StationFrame> untouched;
    bool clean = true; // the line since the last 0x00
    for (int i = 0; i < 20000; ++i) {
        const StationFrame frame = randomFrame(random);
        Line one = encoded(frame);
        bool hurt = false;
        if (random.below(3) == 0)
            for (std::uint8_t& byte : one)
                if (random.below(20) == 0) {
                    byte = static_cast<std::uint8_t>(random.next());
                    hurt = true;
                }
        line.insert(line.end(), one.begin(), one.end());
        if (clean && !hurt)
            untouched.push_back(frame);
        clean = line.back() == 0;
    }
    const Heard heard = hear(line);
    QVERIFY(untouched.size() > 10000);
    QVERIFY(heard.broken + heard.badCrc > 1000);
    auto next = heard.frames.begin(); // each untouched one is there, in order
    for (const StationFrame& frame : untouched) {
        next = std::find(next, heard.frames.end(), frame);
        QVERIFY(next != heard.frames.end());
        ++next;
    }
    // What else passed was touched by a byte of the same value; a CRC of 16 bits lets one in 65,536 others
    // through.
    QVERIFY(heard.frames.size() - untouched.size() < 100);
}

QTEST_GUILESS_MAIN(TestStationCobs)
#include "test_station_cobs.moc"
