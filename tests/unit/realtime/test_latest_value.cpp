// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/latest_value.h"

#include <QtTest>
#include <array>
#include <thread>

using chiron::realtime::LatestValue;

namespace {
/// Larger than a cache line, and consistent only as a whole: a torn copy has differing words.
struct Pattern {
    std::array<std::uint64_t, 24> words{};
};
Pattern patternOf(std::uint64_t n) {
    Pattern p;
    p.words.fill(n);
    return p;
}
bool isWhole(const Pattern& p) {
    for (const auto w : p.words)
        if (w != p.words[0])
            return false;
    return true;
}
} // namespace

class TestLatestValue : public QObject {
    Q_OBJECT
private slots:
    void startsWithTheInitialValueAndNoNews() {
        LatestValue<int> value(7);
        int seen = 0;
        QVERIFY(!value.read(seen));
        QCOMPARE(seen, 7);
        QCOMPARE(value.latest(), 7);
    }

    void givesTheNewestOnceAsNewsAndThenAgainAsOld() {
        LatestValue<int> value;
        int seen = -1;
        for (int n = 1; n <= 5; ++n)
            value.publish(n);
        QVERIFY(value.read(seen));
        QCOMPARE(seen, 5);
        QVERIFY(!value.read(seen));
        QCOMPARE(seen, 5);
        value.publish(6);
        QCOMPARE(value.latest(), 6);
        QVERIFY(!value.read(seen));
        QCOMPARE(seen, 6);
    }

    void readersNeverSeeATornOrAnOlderValue() {
        constexpr std::uint64_t kValues = 200'000;
        LatestValue<Pattern> value;
        std::thread writer([&] {
            for (std::uint64_t n = 1; n <= kValues; ++n)
                value.publish(patternOf(n));
        });
        std::uint64_t last = 0;
        std::uint64_t torn = 0;
        std::uint64_t older = 0;
        std::uint64_t falseNews = 0;
        while (last != kValues) {
            Pattern seen;
            const bool news = value.read(seen);
            torn += isWhole(seen) ? 0 : 1;
            older += seen.words[0] < last ? 1 : 0;
            falseNews += (news != (seen.words[0] != last)) ? 1 : 0;
            last = seen.words[0];
        }
        writer.join();
        QCOMPARE(torn, 0u);
        QCOMPARE(older, 0u);
        QCOMPARE(falseNews, 0u);
    }

    void theLatestReferenceStaysStillWhileTheWriterGoesOn() {
        constexpr std::uint64_t kValues = 50'000;
        LatestValue<Pattern> value;
        std::thread writer([&] {
            for (std::uint64_t n = 1; n <= kValues; ++n)
                value.publish(patternOf(n));
        });
        std::uint64_t changedInHand = 0;
        std::uint64_t last = 0;
        while (last != kValues) {
            const Pattern& held = value.latest();
            last = held.words[0];
            for (int look = 0; look < 20; ++look)
                changedInHand += (held.words[23] != last || held.words[0] != last) ? 1 : 0;
        }
        writer.join();
        QCOMPARE(changedInHand, 0u);
    }
};

QTEST_APPLESS_MAIN(TestLatestValue)
#include "test_latest_value.moc"
