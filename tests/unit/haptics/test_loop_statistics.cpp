// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/loop_statistics.h"

#include "core/random.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

using chiron::haptics::LatencyHistogram;
using chiron::haptics::LoopStatistics;
using chiron::realtime::TickTiming;

static_assert(std::is_trivially_copyable_v<LoopStatistics>);

class TestLoopStatistics : public QObject {
    Q_OBJECT
private slots:
    void emptyIsZero() {
        const LatencyHistogram h;
        QCOMPARE(h.count(), 0u);
        QCOMPARE(h.percentile_us(0.99), 0.0);
        QCOMPARE(h.maximum_ns(), 0);
    }

    void smallValuesAreExact() {
        LatencyHistogram h;
        for (int v = 0; v < 20; ++v)
            h.add(v);
        QCOMPARE(h.percentile_us(0.5), 0.009);
        QCOMPARE(h.percentile_us(1.0), 0.019);
        QCOMPARE(h.percentile_us(0.0), 0.0);
    }

    /// From 32 ns on a bucket is a sixteenth of a power of two wide; its upper edge is told.
    void largerValuesAreToldByTheirBucketsEnd() {
        for (const auto& [value, end] :
             {std::pair{31, 31}, std::pair{32, 33}, std::pair{33, 33}, std::pair{34, 35}, std::pair{63, 63},
              std::pair{64, 67}, std::pair{67, 67}, std::pair{68, 71}, std::pair{1000, 1023}}) {
            LatencyHistogram h;
            h.add(value);
            h.add(1'000'000);
            QCOMPARE(h.percentile_us(0.5), end * 1e-3);
            QCOMPARE(h.countUpTo(end), 1u);
            QCOMPARE(h.countUpTo(end - 1), 0u);
        }
    }

    /// Against sorting: never below the true percentile, never more than one bucket (6.25 %) above.
    void percentilesAgreeWithSortingToABucket() {
        LatencyHistogram h;
        std::vector<std::int64_t> values;
        chiron::core::Random random(3);
        for (int n = 0; n < 50'000; ++n) {
            const auto v = static_cast<std::int64_t>(std::exp(random.uniform(0.0, 24.0)));
            values.push_back(v);
            h.add(v);
        }
        std::sort(values.begin(), values.end());
        for (const double fraction : {0.001, 0.1, 0.5, 0.9, 0.99, 0.999}) {
            const auto rank = static_cast<std::size_t>(std::ceil(fraction * 50'000)) - 1;
            const double truth_us = static_cast<double>(values[rank]) * 1e-3;
            const double got_us = h.percentile_us(fraction);
            QVERIFY(got_us >= truth_us);
            QVERIFY(got_us <= truth_us * 1.0625);
        }
        QCOMPARE(h.maximum_ns(), values.back());
        QCOMPARE(h.percentile_us(1.0), static_cast<double>(values.back()) * 1e-3);
    }

    void extremesAreCountedAndNothingIsWrittenBeside() {
        LatencyHistogram h;
        h.add(-5);
        h.add(INT64_MAX);
        h.add(INT64_MIN);
        QCOMPARE(h.count(), 3u);
        QCOMPARE(h.maximum_ns(), INT64_MAX);
        QCOMPARE(h.percentile_us(0.5), 0.0);
        QCOMPARE(h.percentile_us(1.0), static_cast<double>(INT64_MAX) * 1e-3);
    }

    void mergingIsCountingTogether() {
        LoopStatistics a;
        LoopStatistics b;
        LoopStatistics both;
        for (std::int64_t n = 0; n < 1000; ++n) {
            const TickTiming timing{n * 200, n * 17, static_cast<std::uint32_t>(n % 3)};
            (n % 2 == 0 ? a : b).add(timing);
            both.add(timing);
        }
        a.merge(b);
        QCOMPARE(a.ticks(), both.ticks());
        QCOMPARE(a.late(), both.late());
        QCOMPARE(a.skippedDeadlines(), both.skippedDeadlines());
        for (const double fraction : {0.1, 0.5, 0.99, 1.0}) {
            QCOMPARE(a.lateness().percentile_us(fraction), both.lateness().percentile_us(fraction));
            QCOMPARE(a.duration().percentile_us(fraction), both.duration().percentile_us(fraction));
        }
    }

    void lateMeansMoreThanAHundredMicroseconds() {
        LoopStatistics s;
        s.add({100'000, 1, 0});
        QCOMPARE(s.late(), 0u);
        s.add({100'001, 1, 4});
        QCOMPARE(s.late(), 1u);
        QCOMPARE(s.skippedDeadlines(), 4u);
        QCOMPARE(s.ticks(), 2u);
    }
};

QTEST_APPLESS_MAIN(TestLoopStatistics)
#include "test_loop_statistics.moc"
