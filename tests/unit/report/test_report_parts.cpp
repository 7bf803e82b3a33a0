// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/decimate.h"
#include "report/page_layout.h"
#include "report/report_text.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace chiron::report;

class TestReportParts : public QObject {
    Q_OBJECT
private slots:
    void shortLinesStayAsTheyAre();
    void everyPeakSurvives();
    void columnsAreBounded();
    void gapsStay();
    void partAboveCrossesAtTheLimit();
    void pagesHoldTheirBlocks();
    void headingsGoWithWhatFollows();
    void tableHeadsAreRepeated();
    void aTallBlockGetsItsOwnPage();
    void numbersFollowTheLocale();
    void gatesAndBandsInWords();
    void momentsShowTheirOffset();
};

namespace {
std::vector<double> ramp(std::size_t count) {
    std::vector<double> x(count);
    for (std::size_t i = 0; i < count; ++i)
        x[i] = 0.001 * static_cast<double>(i);
    return x;
}

std::vector<Block> rows(int count, double height) {
    std::vector<Block> blocks(static_cast<std::size_t>(count));
    for (Block& block : blocks)
        block.height = height;
    return blocks;
}
} // namespace

void TestReportParts::shortLinesStayAsTheyAre() {
    const std::vector<double> x{0.0, 1.0, 2.0}, y{3.0, -1.0, 4.0};
    const Polyline line = decimate(x, y, 10);
    QVERIFY(line.x == x);
    QVERIFY(line.y == y);
    QVERIFY(decimate({}, {}, 10).x.empty());
    QCOMPARE(decimate(x, std::vector<double>{1.0}, 10).x.size(), std::size_t{1}); // the shorter counts
    QCOMPARE(decimate(x, y, 0).x.size(), std::size_t{3});
}

void TestReportParts::everyPeakSurvives() {
    const auto x = ramp(100000);
    std::vector<double> y(x.size(), 0.0);
    for (std::size_t i = 37; i < y.size(); i += 997)
        y[i] = (i % 2 ? 1.0 : -1.0) * static_cast<double>(i);
    const Polyline line = decimate(x, y, 300);
    // Of each column the extremes, so of the whole line too, and each column's own peak.
    QCOMPARE(*std::max_element(line.y.begin(), line.y.end()), *std::max_element(y.begin(), y.end()));
    QCOMPARE(*std::min_element(line.y.begin(), line.y.end()), *std::min_element(y.begin(), y.end()));
    QVERIFY(std::is_sorted(line.x.begin(), line.x.end()));
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        const auto at = static_cast<std::size_t>(std::llround(line.x[i] / 0.001));
        QCOMPARE(line.y[i], y[at]); // samples, nothing invented
    }
    QCOMPARE(line.x.front(), x.front());
    QCOMPARE(line.x.back(), x.back());
}

void TestReportParts::columnsAreBounded() {
    const auto x = ramp(50000);
    std::vector<double> y;
    for (const double t : x)
        y.push_back(std::sin(1e4 * t));
    QVERIFY(decimate(x, y, 200).x.size() <= 4 * 201);
    const std::vector<double> still(50000, 1.0); // no time passes: nothing to divide by
    QCOMPARE(decimate(still, y, 200).x.size(), std::size_t{50000});
}

void TestReportParts::gapsStay() {
    const auto x = ramp(10000);
    std::vector<double> y(x.size(), 1.0);
    for (std::size_t i = 4000; i < 5000; ++i)
        y[i] = std::numeric_limits<double>::quiet_NaN();
    const Polyline line = decimate(x, y, 100);
    QCOMPARE(std::count_if(line.y.begin(), line.y.end(), [](double v) { return std::isnan(v); }), 1);
}

void TestReportParts::partAboveCrossesAtTheLimit() {
    const Polyline line{{0.0, 1.0, 2.0}, {0.0, 4.0, 0.0}};
    const Polyline above = partAbove(line, 1.0);
    const std::vector<double> x{0.0, 0.25, 1.0, 1.75, 2.0}, y{1.0, 1.0, 4.0, 1.0, 1.0};
    QVERIFY(above.x == x);
    QVERIFY(above.y == y);
    const Polyline gap{{0.0, 1.0}, {std::numeric_limits<double>::quiet_NaN(), 2.0}};
    QCOMPARE(partAbove(gap, 1.0).y.front(), 1.0);
}

void TestReportParts::pagesHoldTheirBlocks() {
    QCOMPARE(paginate({}, 100.0).size(), std::size_t{1});
    const auto pages = paginate(rows(25, 10.0), 100.0);
    QCOMPARE(pages.size(), std::size_t{3});
    int next = 0;
    for (const auto& page : pages) {
        for (const PlacedBlock& placed : page) {
            QCOMPARE(placed.block, next++);
            QVERIFY(placed.top + 10.0 <= 100.0);
        }
    }
    QCOMPARE(next, 25);
}

void TestReportParts::headingsGoWithWhatFollows() {
    auto blocks = rows(4, 30.0);
    blocks[2].keepWithNext = true; // would fit as third, its follower would not
    const auto pages = paginate(blocks, 100.0);
    QCOMPARE(pages.size(), std::size_t{2});
    QCOMPARE(pages[0].size(), std::size_t{2});
    QCOMPARE(pages[1].front().block, 2);
}

void TestReportParts::tableHeadsAreRepeated() {
    auto blocks = rows(12, 20.0);
    blocks[0].keepWithNext = true;
    for (std::size_t i = 1; i < blocks.size(); ++i)
        blocks[i].header = 0;
    const auto pages = paginate(blocks, 100.0);
    QCOMPARE(pages.size(), std::size_t{3});
    for (const auto& page : pages) {
        QCOMPARE(page.front().block, 0);
        QCOMPARE(page.front().top, 0.0);
        QCOMPARE(page[1].top, 20.0);
    }
}

void TestReportParts::aTallBlockGetsItsOwnPage() {
    auto blocks = rows(3, 10.0);
    blocks[1].height = 500.0;
    const auto pages = paginate(blocks, 100.0);
    QCOMPARE(pages.size(), std::size_t{3});
    QCOMPARE(pages[1].size(), std::size_t{1});
}

void TestReportParts::numbersFollowTheLocale() {
    const QLocale german(QLocale::German, QLocale::Germany);
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    QCOMPARE(formatNumber(14.2, english), QStringLiteral("14.20"));
    QCOMPARE(formatNumber(14.2, german), QStringLiteral("14,20"));
    QCOMPARE(formatNumber(0.0706, english), QStringLiteral("0.071"));
    QCOMPARE(formatNumber(1234.56, english), QStringLiteral("1,234.6"));
    QCOMPARE(formatNumber(std::numeric_limits<double>::quiet_NaN(), english), QStringLiteral("–"));
    QCOMPARE(formatValue(std::nullopt, QStringLiteral("N"), english), QStringLiteral("–"));
    QCOMPARE(formatValue(3.0, QStringLiteral("N"), english), QStringLiteral("3.00\u00a0N"));
    QCOMPARE(formatDuration(125.4, english), QStringLiteral("2\u00a0min 05\u00a0s"));
}

void TestReportParts::gatesAndBandsInWords() {
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    MetricRow row;
    row.unit = QStringLiteral("%");
    QVERIFY(formatGate(row, english).isEmpty());
    row.gateMaximum = 25.0;
    QCOMPARE(formatGate(row, english), QStringLiteral("≤ 25.00\u00a0%"));
    row.gateMinimum = 1.0;
    QCOMPARE(formatGate(row, english), QStringLiteral("1.00 – 25.00\u00a0%"));
    row.bandLow = 2.9;
    QVERIFY(formatBand(row, english).isEmpty()); // half a band is none
    row.bandHigh = 25.5;
    QCOMPARE(formatBand(row, english), QStringLiteral("2.90 – 25.50\u00a0%"));
}

void TestReportParts::momentsShowTheirOffset() {
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    const QDateTime utc(QDate(2026, 11, 20), QTime(23, 23), Qt::UTC);
    QCOMPARE(formatMoment(utc, 60, english), QStringLiteral("21 Nov 2026, 00:23 (UTC+01:00)"));
    QCOMPARE(formatMoment(utc, -210, english), QStringLiteral("20 Nov 2026, 19:53 (UTC−03:30)"));
    QCOMPARE(formatMoment({}, 0, english), QStringLiteral("–"));
}

QTEST_APPLESS_MAIN(TestReportParts)
#include "test_report_parts.moc"
