// SPDX-License-Identifier: GPL-3.0-or-later
// What an exercise names itself, through a trace file and back: quantities of the scene, truths of a trial,
// how it ended.
#include "scoring/trace_builder.h"
#include "scoring/trace_columns.h"
#include "scoring/trace_csv.h"
#include "scoring/trace_grid.h"
#include "traces.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <set>

using namespace chiron;
using namespace chiron::scoring;
using core::Vec3;

namespace {

/// Two trials of two tools with numbers that no short decimal holds; the second trial knows one truth less.
SessionTrace busy() {
    SessionTrace session;
    session.exercise = "elastic_tube";
    for (int t = 0; t < 2; ++t) {
        TrialTrace trial;
        trial.tools.push_back(
            traces::sampled(0.2, 0.001, [t](double s) { return Vec3(s / 3.0 + t, s * s, -s); }));
        trial.trial = t;
        for (double& s : trial.tools[0].t_s)
            s += t; // trials follow one another
        trial.tools.push_back(trial.tools[0]);
        trial.quantities = {{"tension_N", {}}, {"grip_0", {}}};
        for (std::size_t i = 0; i < trial.tools[0].t_s.size(); ++i) {
            trial.quantities[0].values.push_back(1.0 / 3.0 + 1e-17 * static_cast<double>(i) +
                                                 0.1 * static_cast<double>(i));
            trial.quantities[1].values.push_back(static_cast<double>(i % 4));
        }
        trial.truth = {{"target_N", 0.1 + 0.2}, {"hold_s", 3.0}};
        trial.completed = t == 0;
        trial.failed = t == 1;
        session.trials.push_back(trial);
    }
    session.trials[1].truth.pop_back();
    return session;
}

SessionTrace again(const SessionTrace& session) {
    const auto rows = readTraceCsv(writeTraceCsv(rowsOf(session)), "again.csv");
    if (!rows)
        qFatal("%s", rows.error().message.c_str());
    auto trace = buildSessionTrace(*rows, session.exercise);
    if (!trace)
        qFatal("%s", trace.error().message.c_str());
    return *trace;
}

std::string refusalOf(const std::string& text) {
    const auto rows = readTraceCsv(text, "r.csv");
    if (!rows)
        return rows.error().message;
    const auto trace = buildSessionTrace(*rows, "elastic_tube");
    return trace ? std::string() : trace.error().message;
}

} // namespace

class TestNamedColumns : public QObject {
    Q_OBJECT
private slots:
    void everyBitComesBack() {
        const auto before = onStoredGrids(busy());
        QVERIFY(before);
        const auto after = onStoredGrids(again(*before));
        QVERIFY(after);
        QCOMPARE(after->trials.size(), std::size_t{2});
        for (std::size_t t = 0; t < 2; ++t) {
            const TrialTrace& a = before->trials[t];
            const TrialTrace& b = after->trials[t];
            QCOMPARE(b.completed, a.completed);
            QCOMPARE(b.failed, a.failed);
            QCOMPARE(b.tools.size(), std::size_t{2});
            QCOMPARE(b.quantities.size(), std::size_t{2});
            for (std::size_t q = 0; q < 2; ++q) {
                QCOMPARE(b.quantities[q].id, a.quantities[q].id);
                QVERIFY(b.quantities[q].values == a.quantities[q].values);
            }
            QCOMPARE(b.truth.size(), t == 0 ? std::size_t{2} : std::size_t{1});
            QCOMPARE(b.truth[0].id, std::string("target_N"));
            QCOMPARE(b.truth[0].value, 0.1 + 0.2);
        }
    }

    void columnsAreNamed() {
        const std::string header = traceCsvHeader(rowsOf(busy()).columns);
        for (const char* column : {"completed", "failed", "quantity_tension_N", "quantity_grip_0",
                                   "truth_target_N", "truth_hold_s"})
            QVERIFY2(header.find(column) != std::string::npos, column);
    }

    /// A sample whose quantity is no number is left out, of the quantities and of the tool alike.
    void whatIsNoNumberIsLeftOut() {
        SessionTrace session = busy();
        session.trials[0].quantities[0].values[5] = std::numeric_limits<double>::quiet_NaN();
        const auto clean = onStoredGrids(session);
        QVERIFY(clean);
        QCOMPARE(clean->trials[0].tools[0].t_s.size(), session.trials[0].tools[0].t_s.size() - 1);
        QCOMPARE(clean->trials[0].quantities[1].values.size(), clean->trials[0].tools[0].t_s.size());
        QCOMPARE(clean->trials[0].tools[1].t_s.size(),
                 session.trials[0].tools[1].t_s.size()); // another tool's is another sample
        session.trials[0].quantities[0].values.pop_back();
        QVERIFY(!onStoredGrids(session)); // not one a sample
    }

    void refusals_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("misspelt") << QByteArray("t_s,x_mm,y_mm,z_mm,quantity\n0,0,0,0,1\n")
                                  << QByteArray("r.csv:1:5: \"quantity\"");
        QTest::newRow("no id") << QByteArray("t_s,x_mm,y_mm,z_mm,truth_\n0,0,0,0,1\n")
                               << QByteArray("\"truth_\"");
        QTest::newRow("odd id") << QByteArray("t_s,x_mm,y_mm,z_mm,truth_a-b\n0,0,0,0,1\n")
                                << QByteArray("\"truth_a-b\"");
        QTest::newRow("twice") << QByteArray("t_s,x_mm,y_mm,z_mm,truth_a,truth_a\n0,0,0,0,1,1\n")
                               << QByteArray("each column once");
        QTest::newRow("no number") << QByteArray("t_s,x_mm,y_mm,z_mm,quantity_a\n0,0,0,0,x\n")
                                   << QByteArray("r.csv:2:5: \"x\": expected a finite number, or nothing");
        QTest::newRow("infinite") << QByteArray("t_s,x_mm,y_mm,z_mm,quantity_a\n0,0,0,0,inf\n")
                                  << QByteArray("a finite number");
        QTest::newRow("truth changes") << QByteArray("t_s,x_mm,y_mm,z_mm,truth_a\n0,0,0,0,1\n0.1,0,0,0,2\n")
                                       << QByteArray("trial 1: truth_a changes at t_s 0.1");
        QTest::newRow("failed changes") << QByteArray("t_s,x_mm,y_mm,z_mm,failed\n0,0,0,0,0\n0.1,0,0,0,1\n")
                                        << QByteArray("trial 1: failed changes");
        QByteArray many("t_s,x_mm,y_mm,z_mm");
        for (int i = 0; i < 65; ++i)
            many += ",quantity_q" + QByteArray::number(i);
        QTest::newRow("too many") << many + "\n" << QByteArray("at most 64");
    }
    /// The columns of exercises are in the table once, each after the shared column that it names, and a file
    /// without them is written as if there were none.
    void columnsOfExercisesFollowSharedOnes() {
        const auto all = traceColumns();
        std::set<std::string_view> names;
        for (const TraceColumn& column : all)
            QVERIFY2(names.insert(column.name).second, std::string(column.name).c_str());
        std::size_t own = 0;
        for (const OwnColumns* owner : ownColumns())
            for (std::size_t place = 0; place < owner->columns.size(); ++place, ++own) {
                const OwnColumn& column = owner->columns[place];
                const std::string name(column.name);
                const int at = findTraceColumn(column.name), before = findTraceColumn(column.after);
                QVERIFY2(at >= 0 && before >= 0 && before < at, name.c_str());
                const TraceColumn& found = all[static_cast<std::size_t>(at)];
                QVERIFY2(found.owner == owner && found.place == place, name.c_str());
                QVERIFY2(all[static_cast<std::size_t>(before)].owner == nullptr, name.c_str());
                QCOMPARE(column.kind == ColumnKind::word, !column.words.empty());
                for (int between = before + 1; between < at; ++between)
                    QVERIFY2(all[static_cast<std::size_t>(between)].owner != nullptr, name.c_str());
            }
        QVERIFY(own > 0);
        const std::string header = traceCsvHeader(rowsOf(busy()).columns);
        for (const TraceColumn& column : all)
            if (column.owner != nullptr)
                QVERIFY2(header.find("," + std::string(column.name) + ",") == std::string::npos,
                         header.c_str());
    }

    void refusals() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, says);
        const std::string message = refusalOf(text.toStdString());
        QVERIFY2(message.find(says.toStdString()) != std::string::npos, message.c_str());
    }
};

QTEST_APPLESS_MAIN(TestNamedColumns)
#include "test_named_columns.moc"
