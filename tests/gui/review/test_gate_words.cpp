// SPDX-License-Identifier: GPL-3.0-or-later
// A pass mark in words: which way it goes, and by how much it was missed.
#include "desktop/debrief/verdict.h"
#include "desktop/exercise_setup/gate_words.h"

#include <QtTest>

using namespace chiron;

namespace {
report::MetricRow row(std::optional<double> value, std::optional<double> minimum,
                      std::optional<double> maximum) {
    report::MetricRow row;
    row.id = "coverage";
    row.unit = "%";
    row.value = value;
    row.gateMinimum = minimum;
    row.gateMaximum = maximum;
    row.passed = false;
    return row;
}

QString missed(std::optional<double> value, std::optional<double> minimum, std::optional<double> maximum) {
    return desktop::missedGateText(row(value, minimum, maximum),
                                   QLocale(QLocale::English, QLocale::UnitedKingdom));
}
} // namespace

class TestGateWords : public QObject {
    Q_OBJECT
private slots:
    void missedByHowMuch();
    void markInWords();
};

void TestGateWords::missedByHowMuch() {
    const QString little = missed(62.0, 80.0, {});
    QVERIFY2(little.contains("too little") && little.contains("(18") && little.contains("62") &&
                 little.contains("80"),
             qPrintable(little));
    QVERIFY2(!little.contains(QStringLiteral("-18")) && !little.contains(QStringLiteral("−18")),
             qPrintable(little));
    const QString much = missed(95.0, {}, 80.0);
    QVERIFY2(much.contains("too much") && much.contains("(15"), qPrintable(much));
    const QString below = missed(5.0, 20.0, 80.0); // a band, from below and from above
    QVERIFY2(below.contains("too little") && below.contains("(15"), qPrintable(below));
    const QString above = missed(85.0, 20.0, 80.0);
    QVERIFY2(above.contains("too much") && above.contains("(5"), qPrintable(above));
    report::MetricRow share = row(71.0, 85.0, {}); // a difference of shares is in percentage points
    share.unit = "%";
    QVERIFY2(desktop::missedGateText(share, QLocale(QLocale::English, QLocale::UnitedKingdom))
                 .endsWith("(14.0 percentage points too little)"),
             qPrintable(desktop::missedGateText(share, QLocale(QLocale::English, QLocale::UnitedKingdom))));
    report::MetricRow counted = row(3.0, {}, 0.0);
    counted.id = "apex_misses";
    counted.unit = "count";
    const QLocale english(QLocale::English, QLocale::UnitedKingdom);
    const QString many =
        desktop::missedGateText(counted, english); // things are many, not much, and a limit of none is 0
    QVERIFY2(many.endsWith("3, but the pass mark is 0 (3 too many)"), qPrintable(many));
    counted.gateMaximum.reset();
    counted.gateMinimum = 5.0;
    const QString few = desktop::missedGateText(counted, english);
    QVERIFY2(few.contains("(2 too few)"), qPrintable(few));
    const QString none = missed({}, 20.0, {});
    QVERIFY2(!none.contains("too") && none.contains("20"), qPrintable(none));
}

void TestGateWords::markInWords() {
    const QLocale locale(QLocale::English, QLocale::UnitedKingdom);
    const auto words = [&](std::optional<double> minimum, std::optional<double> maximum) {
        scoring::Gate gate;
        gate.metric = "coverage";
        gate.minimum = minimum;
        gate.maximum = maximum;
        return desktop::gateInWords(gate, locale);
    };
    QVERIFY2(words(80.0, {}).contains("at least 80"), qPrintable(words(80.0, {})));
    QVERIFY2(words({}, 80.0).contains("at most 80"), qPrintable(words({}, 80.0)));
    // Nothing is below 0 or above 100 %, so that these limits are said as they are.
    QVERIFY2(words({}, 0.0).endsWith(QStringLiteral(": 0 %")), qPrintable(words({}, 0.0)));
    QVERIFY2(words(100.0, {}).endsWith(QStringLiteral(": 100 %")), qPrintable(words(100.0, {})));
    const scoring::Gate done{"procedure_completed", 100.0, {}};
    QCOMPARE(desktop::gateInWords(done, locale), QStringLiteral("The procedure is completed"));
    QCOMPARE(desktop::gateInWords(done, locale, 5),
             QStringLiteral("The procedure is completed, in every trial"));
    const scoring::Gate most{"procedure_completed", 80.0, {}};
    QVERIFY2(desktop::gateInWords(most, locale).endsWith(": at least 80 %"),
             qPrintable(desktop::gateInWords(most, locale)));
    scoring::Gate misses;
    misses.metric = "apex_misses";
    misses.maximum = 0.0;
    QVERIFY2(desktop::gateInWords(misses, locale).endsWith(": none"),
             qPrintable(desktop::gateInWords(misses, locale)));
    misses.maximum = 1.0;
    QVERIFY2(desktop::gateInWords(misses, locale).endsWith(": at most 1"),
             qPrintable(desktop::gateInWords(misses, locale)));
    const QString band = words(20.0, 80.0);
    QVERIFY2(band.contains("from 20") && band.indexOf("20") < band.indexOf("to 80"), qPrintable(band));
}

QTEST_MAIN(TestGateWords)
#include "test_gate_words.moc"
