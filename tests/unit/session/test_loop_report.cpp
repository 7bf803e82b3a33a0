// SPDX-License-Identifier: GPL-3.0-or-later
// How punctual a session's ticks were, as it is stored and read again.
#include "session/loop_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace chiron;

class TestLoopReport : public QObject {
    Q_OBJECT
private slots:
    void binsHoldWhatLiesInThem();
    void punctualityIsTheStatistics();
    void everyFieldIsItsOwn();
    void absentStaysAbsent();
    void binsOfAnotherVersionAreLeft();
    void damageIsNamed();
};

namespace {

QJsonObject objectOf(const std::string& text) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}
std::string textOf(const QJsonObject& json) {
    return QJsonDocument(json).toJson().toStdString();
}

/// One value within the first bin, two within the second, and so on, the last beyond all edges.
session::LatenessBins oneMoreEach(haptics::LoopStatistics& statistics) {
    constexpr std::array<std::int64_t, 11> within_us{1, 3, 7, 15, 30, 70, 150, 300, 700, 3000, 9000};
    session::LatenessBins bins;
    for (std::size_t bin = 0; bin < within_us.size(); ++bin)
        for (std::size_t i = 0; i <= bin; ++i) {
            statistics.add({.lateness_ns = within_us[bin] * 1000, .skipped = 1});
            ++bins.counts[bin];
        }
    return bins;
}

} // namespace

void TestLoopReport::binsHoldWhatLiesInThem() {
    haptics::LoopStatistics statistics;
    QVERIFY(session::latenessBinsOf(statistics.lateness()) == session::LatenessBins{});
    const session::LatenessBins expected = oneMoreEach(statistics);
    QVERIFY(session::latenessBinsOf(statistics.lateness()) == expected);
}

void TestLoopReport::punctualityIsTheStatistics() {
    haptics::LoopStatistics statistics;
    const session::LatenessBins expected = oneMoreEach(statistics);
    session::LoopReport report;
    session::setPunctuality(report, statistics);
    QVERIFY(report.realtime && report.lateness == expected);
    QCOMPARE(report.late, std::uint64_t{7 + 8 + 9 + 10 + 11}); // over 100 µs
    QCOMPARE(report.max_us, 9000.0);
    QCOMPARE(report.p50_us, statistics.lateness().percentile_us(0.5));
    QCOMPARE(report.p99_us, statistics.lateness().percentile_us(0.99));
    QVERIFY(*report.p50_us < *report.p99_us);
}

void TestLoopReport::everyFieldIsItsOwn() {
    session::LoopReport report{11,
                               22,
                               33,
                               0.5,
                               0.25,
                               0.125,
                               true,
                               true,
                               "round robin, \"90\"",
                               1.0 / 3.0,
                               session::LatenessBins{},
                               2.0 / 3.0};
    for (std::size_t i = 0; i < report.lateness->counts.size(); ++i)
        report.lateness->counts[i] = 100 + i;
    const auto back = session::loopReportFrom(session::loopJson(report));
    QVERIFY(back.has_value());
    QVERIFY(back->ticks == 11 && back->late == 22 && back->skipped == 33);
    QVERIFY(back->p50_us == 0.5 && back->p99_us == 0.25 && back->max_us == 0.125 &&
            back->passivity_J == 1.0 / 3.0 && back->passivityWithheld_J == 2.0 / 3.0);
    QVERIFY(back->realtime && back->priorityGranted && back->priorityDetail == report.priorityDetail);
    QVERIFY(back->lateness == report.lateness);
    report.priorityGranted = false;
    QVERIFY(!session::loopReportFrom(session::loopJson(report))->priorityGranted);
    report.realtime = false;
    QVERIFY(!session::loopReportFrom(session::loopJson(report))->realtime);
}

void TestLoopReport::absentStaysAbsent() {
    for (const std::string& text :
         {session::loopJson({}), std::string("{}")}) { // also of a session stored before there was any of it
        const auto back = session::loopReportFrom(text);
        QVERIFY(back.has_value());
        QVERIFY(back->ticks == 0 && back->late == 0 && back->skipped == 0 && !back->realtime &&
                !back->priorityGranted && back->priorityDetail.empty());
        QVERIFY(!back->p50_us && !back->p99_us && !back->max_us && !back->passivity_J &&
                !back->passivityWithheld_J && !back->lateness);
    }
}

void TestLoopReport::binsOfAnotherVersionAreLeft() {
    session::LoopReport report;
    report.lateness.emplace();
    const QJsonObject whole = objectOf(session::loopJson(report));
    QVERIFY(session::loopReportFrom(textOf(whole))->lateness.has_value());
    const auto without = [&](const char* key, auto change) {
        QJsonObject json = whole;
        QJsonArray list = json[QLatin1String(key)].toArray();
        change(list);
        json[QLatin1String(key)] = list;
        return session::loopReportFrom(textOf(json))->lateness.has_value();
    };
    for (int i = 0; i < 10; ++i)
        QVERIFY(!without("lateness_edges_us", [i](QJsonArray& edges) { edges[i] = edges[i].toInt() + 1; }));
    QVERIFY(!without("lateness_edges_us", [](QJsonArray& edges) { edges.removeLast(); }));
    QVERIFY(!without("lateness_edges_us", [](QJsonArray& edges) { edges.append(9000); }));
    QVERIFY(!without("lateness_counts", [](QJsonArray& counts) { counts.removeLast(); }));
    QVERIFY(!without("lateness_counts", [](QJsonArray& counts) { counts.append(1); }));
}

void TestLoopReport::damageIsNamed() {
    for (const char* wrong : {"", "[]", "{", "7"}) {
        const auto read = session::loopReportFrom(wrong);
        QVERIFY(!read && read.error().code == core::ErrorCode::badInput &&
                read.error().message == "loop statistics: expected a JSON object");
    }
}

QTEST_GUILESS_MAIN(TestLoopReport)
#include "test_loop_report.moc"
