// SPDX-License-Identifier: GPL-3.0-or-later
// What the station says of its loop: what was measured, beside its limit.
#include "desktop/station/station_words.h"

#include <QtTest>

using namespace chiron;
using desktop::StationWords;

namespace {

session::LoopReport loop(std::uint64_t late, std::uint64_t skipped) {
    session::LoopReport report;
    report.ticks = 100000;
    report.late = late;
    report.skipped = skipped;
    report.realtime = true;
    return report;
}

} // namespace

class TestStationWords : public QObject {
    Q_OBJECT
private slots:
    void theMeasuredShareIsToldBesideTheLimit() {
        const QString good = StationWords::verdict(loop(120, 0), QLocale::c());
        QCOMPARE(QString::fromLatin1(StationWords::verdictKind(loop(120, 0))), QStringLiteral("good"));
        QVERIFY2(good.contains(QStringLiteral("0.1 %")) && good.contains(QStringLiteral("limit 0.3 %")),
                 qPrintable(good));
        const QString bad = StationWords::verdict(loop(2500, 0), QLocale::c());
        QCOMPARE(QString::fromLatin1(StationWords::verdictKind(loop(2500, 0))), QStringLiteral("warning"));
        QVERIFY2(bad.contains(QStringLiteral("2.5 %")) && bad.contains(QStringLiteral("limit 0.3 %")),
                 qPrintable(bad));
    }

    void aLoopThatLeftTicksOutIsNotPunctual() {
        for (const std::uint64_t skipped : {1U, 204U}) {
            QCOMPARE(QString::fromLatin1(StationWords::verdictKind(loop(0, skipped))),
                     QStringLiteral("warning"));
            const QString words = StationWords::verdict(loop(0, skipped), QLocale::c());
            QVERIFY2(words.contains(QStringLiteral("not run on time")) &&
                         words.contains(QString::number(skipped)),
                     qPrintable(words));
        }
    }
};

QTEST_MAIN(TestStationWords)
#include "test_station_words.moc"
