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
    void eachColumnKeepsItsFour();
    void fourAColumnAreLeftAsTheyAre();
    void partAboveCrossesAtTheLimit();
    void pagesHoldTheirBlocks();
    void headingsGoWithWhatFollows();
    void tableHeadsAreRepeated();
    void aTallBlockGetsItsOwnPage();
    void blocksStandUnderEachOther();
    void aPageIsFilledToItsEnd();
    void numbersFollowTheLocale();
    void digitsFollowTheSize();
    void whatWasFeltInWords();
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

// As it is said, written down once more: of each column first, lowest, highest and last, a run of what is no
// number as one gap.
void TestReportParts::eachColumnKeepsItsFour() {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> x, y;
    double at = 3.0; // neither even nor from 0
    for (int i = 0; i < 4000; ++i) {
        at += 0.01 + 0.009 * std::sin(0.7 * i);
        x.push_back(at);
        y.push_back(i % 700 > 680 || i == 100 ? nothing : std::sin(0.013 * i) + 0.3 * std::sin(2.1 * i));
    }
    x[50] = nothing;
    constexpr int columns = 37;
    Polyline expected;
    const double width = x.back() - x.front();
    std::vector<std::size_t> held;
    const auto keep = [&] {
        if (held.empty())
            return;
        const auto lower = [&](std::size_t a, std::size_t b) { return y[a] < y[b]; };
        std::vector<std::size_t> four{held.front(), *std::min_element(held.begin(), held.end(), lower),
                                      *std::max_element(held.begin(), held.end(), lower), held.back()};
        std::sort(four.begin(), four.end());
        four.erase(std::unique(four.begin(), four.end()), four.end());
        for (const std::size_t i : four) {
            expected.x.push_back(x[i]);
            expected.y.push_back(y[i]);
        }
        held.clear();
    };
    int before = -1;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
            keep();
            if (std::isfinite(x[i]) && !std::isnan(expected.y.back())) {
                expected.x.push_back(x[i]);
                expected.y.push_back(nothing);
            }
            continue;
        }
        const int column = static_cast<int>(std::floor((x[i] - x.front()) / width * columns));
        if (column != before)
            keep();
        before = column;
        held.push_back(i);
    }
    keep();
    const Polyline line = decimate(x, y, columns);
    QVERIFY(line.x == expected.x);
    QCOMPARE(line.y.size(), expected.y.size());
    for (std::size_t i = 0; i < line.y.size(); ++i)
        QVERIFY(line.y[i] == expected.y[i] || (std::isnan(line.y[i]) && std::isnan(expected.y[i])));
    QVERIFY(line.x.size() > 4 * (columns - 1) && line.x.size() < 4 * columns + 20);
}

void TestReportParts::fourAColumnAreLeftAsTheyAre() {
    const auto of = [](std::size_t count, int columns) {
        const auto x = ramp(count);
        return decimate(x, std::vector<double>(count, 1.0), columns).x.size();
    };
    QCOMPARE(of(400, 100), std::size_t{400});
    QVERIFY(of(401, 100) < 401);
    QCOMPARE(of(4, 0), std::size_t{4}); // no columns are one
    QCOMPARE(of(4, -3), std::size_t{4});
    QVERIFY(of(5, 0) < 5);
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

// Each begins where the one before ended and its own gap has passed; the first of a page at its top, without
// a gap.
void TestReportParts::blocksStandUnderEachOther() {
    auto blocks = rows(5, 20.0);
    const std::vector<double> gaps{7.0, 3.0, 0.0, 5.0, 9.0};
    for (std::size_t i = 0; i < blocks.size(); ++i)
        blocks[i].gapBefore = gaps[i];
    const auto pages = paginate(blocks, 65.0);
    const std::vector<std::vector<double>> tops{{0.0, 23.0, 43.0}, {0.0, 29.0}};
    QCOMPARE(pages.size(), tops.size());
    int next = 0;
    for (std::size_t page = 0; page < tops.size(); ++page) {
        QCOMPARE(pages[page].size(), tops[page].size());
        for (std::size_t i = 0; i < tops[page].size(); ++i) {
            QCOMPARE(pages[page][i].block, next++);
            QCOMPARE(pages[page][i].top, tops[page][i]);
        }
    }
}

// What just fits stays, gaps counted; a head is repeated first, and what it heads stands under it with its
// gap.
void TestReportParts::aPageIsFilledToItsEnd() {
    auto blocks = rows(3, 30.0);
    blocks[1].gapBefore = blocks[2].gapBefore = 5.0;
    QCOMPARE(paginate(blocks, 100.0).size(), std::size_t{1});
    QCOMPARE(paginate(blocks, 99.9).size(), std::size_t{2});
    blocks[0].height = 10.0;
    blocks[2].header = 0;
    const auto pages = paginate(blocks, 79.0);
    QCOMPARE(pages.size(), std::size_t{2});
    QCOMPARE(pages[1].size(), std::size_t{2});
    QVERIFY(pages[1][0].block == 0 && pages[1][0].top == 0.0 && pages[1][1].block == 2 &&
            pages[1][1].top == 15.0);
    // A heading whose followers together do not fit goes with all of them.
    auto chain = rows(4, 20.0);
    chain[1].keepWithNext = chain[2].keepWithNext = true;
    for (auto& block : chain)
        block.gapBefore = 2.0;
    QCOMPARE(paginate(chain, 86.0).front().size(), std::size_t{4});
    QCOMPARE(paginate(chain, 85.9).front().size(), std::size_t{1});
}

void TestReportParts::numbersFollowTheLocale() {
    const QLocale german(QLocale::German, QLocale::Germany);
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    QCOMPARE(formatNumber(14.2, english), QStringLiteral("14.2"));
    QCOMPARE(formatNumber(14.2, german), QStringLiteral("14,2"));
    QCOMPARE(formatNumber(0.0706, english), QStringLiteral("0.071"));
    QCOMPARE(formatNumber(1234.56, english), QStringLiteral("1,235"));
    QCOMPARE(formatNumber(std::numeric_limits<double>::quiet_NaN(), english), QStringLiteral("–"));
    QCOMPARE(formatValue(std::nullopt, QStringLiteral("N"), english), QStringLiteral("–"));
    QCOMPARE(formatValue(3.0, QStringLiteral("N"), english), QStringLiteral("3.00\u00a0N"));
    QCOMPARE(formatDuration(125.4, english), QStringLiteral("2\u00a0min 05\u00a0s"));
}

// Three digits that say something, to the ends of each range, whatever the sign.
void TestReportParts::digitsFollowTheSize() {
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    for (const auto& [value, words] :
         std::initializer_list<std::pair<double, const char*>>{{0.0, "0.00"},
                                                               {0.0000099, "9.90e-06"},
                                                               {0.00001, "0.000010"},
                                                               {0.000464, "0.00046"},
                                                               {0.00099, "0.00099"},
                                                               {0.000996, "0.0010"},
                                                               {0.001, "0.0010"},
                                                               {0.0014, "0.0014"},
                                                               {0.0149, "0.015"},
                                                               {0.0996, "0.10"},
                                                               {0.9994, "0.999"},
                                                               {1.0, "1.00"},
                                                               {9.994, "9.99"},
                                                               {10.0, "10.0"},
                                                               {99.94, "99.9"},
                                                               {100.0, "100"},
                                                               {9'999'999.0, "9,999,999"},
                                                               {1e7, "1.00e+07"}}) {
        QCOMPARE(formatNumber(value, english).toLower(), QString::fromLatin1(words));
        if (value != 0.0)
            QCOMPARE(formatNumber(-value, english).toLower(), QLatin1Char('-') + QString::fromLatin1(words));
    }
    const QString count = QStringLiteral("count");
    QCOMPARE(formatValue(3.0, count, english), QStringLiteral("3"));    // counts need no word behind them
    QCOMPARE(formatValue(2.5, count, english), QStringLiteral("2.50")); // a mean of counts
    QCOMPARE(formatValue(2.5, QString(), english), QStringLiteral("2.50"));
    for (const auto& [seconds, words] :
         std::initializer_list<std::pair<double, const char*>>{{0.0, "0.0 s"},
                                                               {59.94, "59.9 s"},
                                                               {60.0, "1 min 00 s"},
                                                               {119.6, "2 min 00 s"},
                                                               {3599.0, "59 min 59 s"},
                                                               {-0.1, "–"}})
        QCOMPARE(formatDuration(seconds, english).replace(QChar(0x00a0), QLatin1Char(' ')),
                 QString::fromUtf8(words));
    QCOMPARE(formatDuration(std::numeric_limits<double>::infinity(), english), QStringLiteral("–"));
}

void TestReportParts::whatWasFeltInWords() {
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    ForceFacts force;
    force.tissue_N = 0.0199;
    QCOMPARE(feltWords(force, true, english), QStringLiteral("Nothing was touched."));
    force.tissue_N = 0.02; // a contact, as for every metric
    QVERIFY(
        feltWords(force, true, english).endsWith(QStringLiteral("0.020\u00a0N, and all of it was felt.")));
    QVERIFY(feltWords(force, false, english).endsWith(QStringLiteral("the force was only shown.")));
    force.firstLimited_s = 61.0;
    force.felt_N = 0.01;
    force.limited_s = 0.5;
    QVERIFY(feltWords(force, true, english)
                .endsWith(QStringLiteral("at most 0.010\u00a0N of it was felt: the force was limited for "
                                         "0.500\u00a0s, first after 1\u00a0min 01\u00a0s.")));
    force.beyondChecked = kBeyondCheckedSaid;
    QVERIFY(beyondCheckedWords(force, english).isEmpty());
    force.beyondChecked = 2.0 * kBeyondCheckedSaid;
    QVERIFY(beyondCheckedWords(force, english)
                .startsWith(formatValue(200.0 * kBeyondCheckedSaid, QStringLiteral("%"), english)));
    // Of what failed first, the three that stand on the first page.
    std::vector<MetricRow> rows(6);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].name = QString::number(i);
        rows[i].headline = i != 1;
        rows[i].passed = i == 4 ? std::optional(false) : i == 2 ? std::optional(true) : std::nullopt;
    }
    QStringList chosen;
    for (const MetricRow& row : headlineRows(rows))
        chosen << row.name;
    QCOMPARE(chosen, (QStringList{"4", "0", "2"}));
}

void TestReportParts::gatesAndBandsInWords() {
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    MetricRow row;
    row.unit = QStringLiteral("%");
    QVERIFY(formatGate(row, english).isEmpty());
    row.gateMaximum = 25.0;
    QCOMPARE(formatGate(row, english), QStringLiteral("≤ 25.0\u00a0%"));
    row.gateMinimum = 1.0;
    QCOMPARE(formatGate(row, english), QStringLiteral("1.00 – 25.0\u00a0%"));
    MetricRow all;
    all.unit = row.unit;
    all.gateMinimum = 100.0; // everything: nothing is more
    QCOMPARE(formatGate(all, english), QStringLiteral("100\u00a0%"));
    all.gateMinimum = 80.0;
    QCOMPARE(formatGate(all, english), QStringLiteral("≥ 80.0\u00a0%"));
    row.bandLow = 2.9;
    QVERIFY(formatBand(row, english).isEmpty()); // half a band is none
    row.bandHigh = 25.5;
    QCOMPARE(formatBand(row, english), QStringLiteral("2.90 – 25.5\u00a0%"));
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
