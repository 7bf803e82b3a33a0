// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session_output.h"

#include <QtTest>

using namespace chiron;

// What `session show` says of tissue that gave way: by force or by torque, with its unit.
class TestYieldOutput : public QObject {
    Q_OBJECT
private slots:
    void forceAndTorqueHaveTheirUnits() {
        const auto yielded = [](int trial, int tool, double time_s, const QJsonObject& cause,
                                const QJsonArray& place_m = {}) {
            QJsonObject detail{{"trial", trial}};
            if (!place_m.isEmpty())
                detail.insert("position_m", place_m);
            QJsonObject event{
                {"kind", "tissue_yielded"}, {"tool", tool}, {"time_s", time_s}, {"detail", detail}};
            if (!cause.isEmpty())
                event.insert("gave_way_to", cause);
            return event;
        };
        const QJsonArray events{
            QJsonObject{{"kind", "trial_started"}, {"tool", 0}},
            yielded(0, 0, 12.3456, {{"quantity", "torque"}, {"value", 213.0}, {"unit", "mN·m"}}),
            yielded(1, 2, 20.0, {{"quantity", "force"}, {"value", 8.0}, {"unit", "N"}},
                    {0.0123, -0.004, 0.0207}),
            yielded(1, 0, 21.0, {}), yielded(1, 0, 22.0, {}, {-0.00004, 0.00004, -0.00006})};
        const QJsonArray yields = cli::yieldsOf(events);
        QCOMPARE(yields.size(), 4);
        QCOMPARE(yields[0]["trial"].toInt(), 1); // people count from one
        QCOMPARE(yields[0]["gave_way_to"]["unit"].toString(), QStringLiteral("mN·m"));
        QCOMPARE(yields[1]["position_m"].toArray(), (QJsonArray{0.0123, -0.004, 0.0207}));
        QVERIFY(!yields[0].toObject().contains("position_m")); // a session of an earlier version
        const QStringList lines = cli::yieldsText(yields, "palpation").trimmed().split(QLatin1Char('\n'));
        QCOMPARE(lines, (QStringList{
                            QStringLiteral("tissue gave way: trial 1, tool 1, at 12.346 s, torque 213 mN·m"),
                            QStringLiteral("tissue gave way: trial 2, tool 3, at 20.000 s, force 8.00 N, "
                                           "tip at x 12.3, y -4.0, z 20.7 mm"),
                            QStringLiteral("tissue gave way: trial 2, tool 1, at 21.000 s"),
                            QStringLiteral("tissue gave way: trial 2, tool 1, at 22.000 s, "
                                           "tip at x 0.0, y 0.0, z -0.1 mm")})); // no negative nothing
        QCOMPARE(cli::yieldsText(cli::yieldsOf({}), "palpation"), QString());
        const QString lifted =
            cli::yieldsText(QJsonArray{yields[1]}, "comparison").trimmed(); // no tissue: an object of a study
        QVERIFY2(
            lifted.startsWith(QStringLiteral("object came off the tool: trial 2, tool 3, at 20.000 s, ")),
            qPrintable(lifted));
    }
};

QTEST_GUILESS_MAIN(TestYieldOutput)
#include "test_yield_output.moc"
