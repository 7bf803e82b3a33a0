// SPDX-License-Identifier: GPL-3.0-or-later
// Every metric in every version of trials that were drawn so that much happens in them, often just at a
// limit, and of the same trials with something lacking, against what was kept. Hand-made cases show that
// metrics are right; stored scores stay comparable only where none of them changes.
#include "support/kept_figures.h"

#include "drawn_traces.h"
#include "insertion_traces.h"
#include "palpation_traces.h"

#include "core/contact_bits.h"
#include "curriculum/exercises/palpation/scoring/finding_errors.h"
#include "curriculum/exercises/palpation/scoring/palpation_answer.h"
#include "curriculum/exercises/palpation/scoring/roc_curve.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_moments.h"
#include "scoring/force_facts.h"
#include "scoring/metric_catalogue.h"
#include "scoring/score_calculator.h"
#include "scoring/smoothness.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_columns.h"
#include "scoring/trace_csv.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::scoring;
using core::Vec3;
using tests::changes;
using tests::drawn;
using tests::Figures;
using tests::palpated;

namespace {

const QString kFile = QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/scoring/kept_scores.txt");

void tell(Figures& out, const QString& of, const MetricValue& value) {
    if (value.value)
        out.add(of, *value.value);
    else
        out.say(of, value.reason);
}

} // namespace

class TestKeptScores : public QObject {
    Q_OBJECT
private slots:
    void everyMetric();
    void palpations();
    void events();
    void truths();
    void files();
    void cells();
    void headers();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const Figures& figures) {
        const QString differs = m_kept.differs(name, figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    static std::vector<MetricRequest> all() {
        std::vector<MetricRequest> requests;
        for (const MetricDefinition& metric : metricCatalogue())
            requests.push_back({std::string(metric.id), metric.version});
        return requests;
    }
    tests::KeptText m_kept{kFile, tests::sameFigures};
};

void TestKeptScores::everyMetric() {
    const SessionTrace trace = drawn();
    QSet<QString> before;
    for (const auto& [name, change] : changes()) {
        SessionTrace changed = trace;
        change(changed);
        Figures out;
        const auto card = calculateScore(changed, all(), {}, true);
        QVERIFY2(card, card ? "" : card.error().message.c_str());
        for (std::size_t i = 0; i < card->metrics.size(); ++i) {
            const QString id = QStringLiteral("%1@%2")
                                   .arg(QString::fromStdString(card->metrics[i].id))
                                   .arg(card->metrics[i].version);
            tell(out, id, card->metrics[i]);
            for (std::size_t trial = 0; trial < card->trials.size(); ++trial)
                tell(out, QStringLiteral("%1 of %2").arg(id).arg(trial), card->trials[trial][i]);
        }
        const ForceFacts facts = forceFactsOf(changed);
        out.add(QStringLiteral("forces"), facts.tissue_N, facts.commanded_N, facts.limited_s,
                facts.firstLimited_s.value_or(-1.0), facts.samples, facts.beyondChecked,
                facts.beyondCheckedShare());
        // Of a change only what it changes.
        Figures changedOnly;
        for (qsizetype i = 0; i < out.lines.size(); ++i)
            if (before.isEmpty() || !before.contains(out.lines[i]))
                changedOnly.lines << out.lines[i];
        if (changedOnly.lines.isEmpty())
            changedOnly.say(QStringLiteral("changes"), "nothing");
        if (before.isEmpty())
            before = QSet<QString>(out.lines.begin(), out.lines.end());
        hold(QStringLiteral("metrics, %1").arg(QLatin1String(name)), changedOnly);
        if (QTest::currentTestFailed())
            return;
    }
}

void TestKeptScores::palpations() {
    Figures out;
    const std::vector<TrialTrace> trials = palpated();
    for (std::size_t count = 0; count <= trials.size(); ++count) {
        SessionTrace trace =
            tests::palpationSession({trials.begin(), trials.begin() + static_cast<std::ptrdiff_t>(count)});
        for (const double limit_N : {4.0, 2.0}) {
            trace.forceLimit_N = limit_N;
            const auto card = calculateScore(trace, all(), {}, true);
            for (std::size_t i = 0; i < card->metrics.size(); ++i)
                if (const std::string& id = card->metrics[i].id;
                    id.starts_with("palpation") || id.starts_with("loc") || id.starts_with("size") ||
                    id.starts_with("hard") || id == "coverage" || id.starts_with("force_band") ||
                    id == "pressing_time" || id == "searching_time") {
                    tell(out, QString::fromStdString(id), card->metrics[i]);
                    for (const auto& trial : card->trials)
                        tell(out, QStringLiteral("- of one"), trial[i]);
                }
        }
    }
    RatingCounts ratings;
    for (const TrialTrace& trial : trials) {
        const JudgedTrial judged = judgePalpation(trial);
        QVERIFY(judged.answer);
        const PalpationAnswer& answer = *judged.answer;
        out.add(QStringLiteral("judged"), answer.hits(), answer.misses(), answer.falseAlarms(),
                answer.reports.size());
        for (const TimedReport& report : answer.reports)
            out.add(QStringLiteral("report"), report.t_s, static_cast<int>(report.field), report.finding,
                    report.value, report.place_W.x(), report.place_W.y());
        for (const FindingMatch& match : answer.matches)
            out.add(QStringLiteral("match"), match.finding, match.lump, match.distance_m, match.region);
        for (const DetectionRegion& region : answer.regions)
            out.add(QStringLiteral("region"), region.signal, region.reported, region.confidence);
        const HardnessPairs pairs = hardnessPairs(answer.truth, answer.findings, answer.matches);
        out.add(QStringLiteral("pairs"), pairs.right, pairs.pairs, pairs.rated, pairs.rightByChance);
        ratings.add(answer.regions);
        if (const auto curve = rocOf(ratings)) {
            out.add(QStringLiteral("curve"), curve->area, curve->dA.value_or(-99.0),
                    curve->slope.value_or(-99.0));
            for (const RocPoint& point : curve->points)
                out.add(QStringLiteral("point"), point.falseAlarmRate, point.hitRate, point.confidence);
        }
        for (const double x : {-0.0301, -0.03, -0.01, 0.0, 0.01, 0.0299, 0.03, 0.0301})
            out.add(QStringLiteral("region at"), x, regionAt(answer.truth, Vec3(x, 0.0, 0.0)),
                    regionAt(answer.truth, Vec3(0.0, x, 0.0)), regionAt(answer.truth, Vec3(x, x, 0.0)));
    }
    for (const std::vector<std::pair<int, int>>& rated : std::vector<std::vector<std::pair<int, int>>>{
             {}, {{1, 1}}, {{1, 1}, {1, 2}}, {{1, 2}, {3, 3}, {5, 1}}, {{2, 2}, {4, 4}, {5, 4}, {1, 5}}}) {
        const HardnessPairs pairs = hardnessPairs(rated);
        out.add(QStringLiteral("of ratings"), pairs.right, pairs.pairs, pairs.rated, pairs.rightByChance);
    }
    hold(QStringLiteral("palpations"), out);
}

void TestKeptScores::events() {
    Figures out;
    const auto told = [&](const char* name, const std::vector<InsertionEvent>& events) {
        for (const InsertionEvent& event : events)
            out.add(QLatin1String(name), event.begin_s, event.end_s, event.value, isCritical(event));
    };
    SessionTrace trace = drawn();
    trace.trials[3].own.reset();
    for (TrialTrace& trial : trace.trials) {
        const InsertionEvents events = insertionEvents(traces::onGrids(trial));
        told("trauma", events.trauma);
        told("reversal", events.reversals);
        for (const InsertionQuantity quantity :
             {InsertionQuantity::offset, InsertionQuantity::alignment, InsertionQuantity::bendAlignment,
              InsertionQuantity::curveAlignment, InsertionQuantity::torque}) {
            const auto largest = largestOf(traces::onGrids(trial), quantity);
            out.add(QStringLiteral("largest"), largest ? largest->begin_s : -1.0,
                    largest ? largest->value : -1.0, inMetricUnit(quantity, 0.01));
            told("over",
                 stretchesOver(traces::onGrids(trial), quantity,
                               inMetricUnit(quantity, quantity == InsertionQuantity::torque   ? 0.001
                                                      : quantity == InsertionQuantity::offset ? 0.002
                                                                                              : 0.2)));
            out.say(QStringLiteral("unit"), metricUnitOf(quantity));
        }
    }
    for (const MetricDefinition& metric : metricCatalogue())
        if (const auto quantity = insertionQuantityOf(metric.id))
            out.add(QString::fromUtf8(metric.id.data(), static_cast<qsizetype>(metric.id.size())),
                    static_cast<int>(*quantity));
    hold(QStringLiteral("events"), out);
}

/// A truth that lacks something or cannot be.
void TestKeptScores::truths() {
    Figures out;
    const std::vector<NamedValue> good =
        tests::MadeTrial(std::vector<tests::MadeLump>{{0.01, 0.01, 0.0075, 1}}).trial().truth;
    const auto tried = [&](const QString& name, const std::vector<NamedValue>& truth) {
        const auto read = palpationTruthOf(truth);
        out.say(name, read ? "read" : "refused");
        if (read)
            out.add(QStringLiteral("truth"), read->lumps.size(), read->areaHalf_m.x(), read->areaHalf_m.y(),
                    read->regionColumns, read->regionRows, read->hitRadius_m, read->bandLow_N,
                    read->bandHigh_N, read->coverForce_N, read->asksSize, read->asksHardness);
    };
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::vector<NamedValue> less = good;
        less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
        tried(QString::fromStdString(good[i].id), less);
        for (const double value : {-1.0, -1e-9, 0.0,  1e-6, 0.49, 0.5,  1.0,  1.49, 5.0,  5.5,     6.0,
                                   8.0,  12.0,  16.0, 17.0, 32.0, 33.0, 64.0, 65.0, 1e12, HUGE_VAL}) {
            if (good[i].id == "lumps" && value > 1.4)
                continue; // then lumps lack
            std::vector<NamedValue> other = good;
            other[i].value = value;
            tried(QStringLiteral("%1 %2").arg(QString::fromStdString(good[i].id)).arg(value), other);
        }
    }
    for (const int lumps : {7, 8, 9, 12, 16, 17}) {
        const std::vector<tests::MadeLump> many(static_cast<std::size_t>(lumps));
        tried(QStringLiteral("%1 lumps").arg(lumps), tests::MadeTrial(many).trial().truth);
    }
    hold(QStringLiteral("truths"), out);
}

/// What is written of trials, row by row, and that it says as much when it is read.
void TestKeptScores::files() {
    Figures out;
    SessionTrace trace = drawn();
    trace.trials.resize(2);
    trace.trials[1].unfinished = true;
    for (const bool plain : {false, true}) {
        if (plain)
            for (TrialTrace& trial : trace.trials) {
                trial.own.reset();
                trial.quantities.clear();
                trial.truth.clear();
                trial.target.reset();
                for (ToolTrace& one : trial.tools) {
                    one.commanded_N.clear();
                    one.measured_N.clear();
                    one.q_WT.clear();
                    one.tissueTorque_Nm.clear();
                    one.contact.clear();
                }
            }
        const TraceRows rows = rowsOf(trace);
        const std::string text = writeTraceCsv(rows);
        const QStringList lines = QString::fromStdString(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
        out.add(QStringLiteral("lines"), lines.size());
        for (qsizetype i = 0; i < lines.size(); i += i == 0 ? 1 : 611)
            out.lines << QString(lines[i]).replace(QLatin1Char(','), QLatin1Char(' '));
        const auto read = readTraceCsv(text, "drawn.csv");
        QVERIFY2(read, read ? "" : read.error().message.c_str());
        const auto built = buildSessionTrace(*read, "drawn", 3.0);
        QVERIFY2(built, built ? "" : built.error().message.c_str());
        const auto card = calculateScore(*built, all(), {}, true),
                   same = calculateScore(trace, all(), {}, true);
        for (std::size_t i = 0; i < card->metrics.size(); ++i) {
            QVERIFY2(plain || card->metrics[i].value == same->metrics[i].value, card->metrics[i].id.c_str());
            if (plain)
                tell(out, QString::fromStdString(card->metrics[i].id), card->metrics[i]);
        }
    }
    hold(QStringLiteral("files"), out);
}

/// Each cell of a row with every column, at the ends of what it may be and beyond, and how it is written
/// again.
void TestKeptScores::cells() {
    Figures out;
    SessionTrace trace = drawn();
    trace.trials.resize(1);
    trace.trials[0].unfinished = true;
    TraceRows all = rowsOf(trace);
    all.columns.jaw = all.columns.buttons = all.columns.phase = true;
    all.rows.resize(1);
    all.rows[0].quantities[1] = -0.0;
    all.rows[0].quantities[2] = std::nan("");
    const QStringList lines = QString::fromStdString(writeTraceCsv(all)).split(QLatin1Char('\n'));
    const QStringList names = lines[0].split(QLatin1Char(',')), usual = lines[1].split(QLatin1Char(','));
    for (qsizetype i = 0; i < names.size(); ++i)
        out.say(names[i], usual[i].toStdString());
    for (qsizetype i = 0; i < names.size(); ++i) {
        const int known = findTraceColumn(names[i].toStdString());
        QStringList values{QString(),
                           QStringLiteral("0"),
                           QStringLiteral("1"),
                           QStringLiteral("-1"),
                           QStringLiteral("2"),
                           QStringLiteral("0.5"),
                           QStringLiteral("-0"),
                           QStringLiteral("0.00000049"),
                           QStringLiteral("x"),
                           QStringLiteral("1e400"),
                           QStringLiteral("running"),
                           QStringLiteral("withdrawal")};
        if (known >= 0) {
            const TraceColumn& column = traceColumns()[static_cast<std::size_t>(known)];
            for (const double end : {column.least, column.most})
                for (const double away : {-1.0, 0.0, 1.0})
                    values << QString::number(end + away * std::max(1.0, 1e-9 * std::abs(end)), 'g', 17);
        }
        values.removeDuplicates();
        for (const QString& value : values) {
            QStringList row = usual;
            row[i] = value;
            const auto read = readTraceCsv(
                (names.join(QLatin1Char(',')) + QLatin1Char('\n') + row.join(QLatin1Char(','))).toStdString(),
                "t");
            out.say(names[i] + QStringLiteral(" = ") + value,
                    read ? QString::fromStdString(writeTraceCsv(*read))
                               .section(QLatin1Char('\n'), 1, 1)
                               .section(QLatin1Char(','), i, i)
                               .toStdString()
                         : read.error().message.substr(0, 160));
        }
    }
    hold(QStringLiteral("cells"), out);
}

/// Columns that are missing, given twice, unknown or too many, and lines that are no rows.
void TestKeptScores::headers() {
    Figures out;
    const auto told = [&](const std::string& name, const std::string& text) {
        const auto read = readTraceCsv(text, "t");
        const auto built =
            read ? buildSessionTrace(*read, "drawn") : core::Result<SessionTrace>(SessionTrace{});
        out.say(QString::fromStdString(name), !read ? read.error().message.substr(0, 200)
                                              : !built
                                                  ? built.error().message
                                                  : "read, " + std::to_string(read->rows.size()) + " rows, " +
                                                        std::to_string(built->trials.size()) + " trials");
    };
    const std::string head = "t_s,x_mm,y_mm,z_mm", row = "\n0,1,2,3\n";
    for (const TraceColumn& column : traceColumns()) {
        told("with " + std::string(column.name), head + "," + std::string(column.name) + "\n0,1,2,3,1\n");
        told("twice " + std::string(column.name),
             std::string(column.name) + "," + std::string(column.name) + row);
    }
    for (const char* name : {"", "x", "quantity_", "quantity_a", "quantity_A", "quantity_a b", "truth_",
                             "truth_a_1", "truth_1", "quantity_a,quantity_a", "quantity_a,truth_a"})
        told(std::string("named ") + name, head + "," + name + "\n0,1,2,3,1\n");
    for (const int count : {64, 65})
        for (const char* prefix : {"quantity_a", "truth_a"}) {
            std::string names = head, cells = "\n0,1,2,3";
            for (int i = 0; i < count; ++i) {
                names += "," + std::string(prefix) + std::to_string(i);
                cells += ",1";
            }
            told(std::to_string(count) + prefix, names + cells);
        }
    for (const char* text : {"",
                             "\n",
                             "\xef\xbb\xbf",
                             "\xef\xbb\xbft_s,x_mm,y_mm,z_mm\n0,1,2,3",
                             "t_s,x_mm,y_mm,z_mm",
                             "t_s,x_mm,y_mm,z_mm\r\n0,1,2,3\r\n",
                             "t_s,x_mm,y_mm,z_mm\n0,1,2,3\n\n\n",
                             "t_s,x_mm,y_mm,z_mm\n0,1,2,3\n\n1,1,2,3",
                             "t_s,x_mm,y_mm,z_mm\n\n0,1,2,3",
                             "t_s,x_mm,y_mm,z_mm\n0,1,2\n",
                             "t_s,x_mm,y_mm,z_mm\n0,1,2,3,\n",
                             "t_s,x_mm,y_mm,z_mm\n0,\x1f\x20\x7e\x7f\x80,2,3\n",
                             "t_s,x_mm,y_mm,z_mm\n0,1234567890123456789012345678901234567890,2,x\n",
                             "t_s,x_mm,y_mm,z_mm\n0,12345678901234567890123456789012345678901x,2,3\n",
                             "t_s,x_mm,y_mm,z_mm,tool\n0,1,2,3,0\n0,1,2,3,1\n0,1,2,3,1\n",
                             "t_s,x_mm,y_mm,z_mm,trial\n0,1,2,3,1\n1,1,2,3,2\n2,1,2,3,1\n",
                             "t_s,x_mm,y_mm,z_mm,phase\n0,1,2,3,ready\n",
                             "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n0,1,2,3,1.0009,0,0,0\n1,1,2,3,1.0011,0,0,0\n",
                             "t_s,x_mm,y_mm,z_mm,force_limit_N\n0,1,2,3,2\n1,1,2,3,3\n",
                             "t_s,x_mm,y_mm,z_mm,trials_planned\n0,1,2,3,2\n1,1,2,3,3\n",
                             "t_s,x_mm,y_mm,z_mm,failed\n0,1,2,3,0\n1,1,2,3,1\n",
                             "t_s,x_mm,y_mm,z_mm,unfinished\n0,1,2,3,1\n1,1,2,3,0\n",
                             "t_s,x_mm,y_mm,z_mm,truth_a\n0,1,2,3,1\n1,1,2,3,2\n"})
        told(text, text);
    hold(QStringLiteral("headers"), out);
}

QTEST_APPLESS_MAIN(TestKeptScores)
#include "test_kept_scores.moc"
