// SPDX-License-Identifier: GPL-3.0-or-later
// The same trace gives the same scores to the last bit: again, from its exported file, with packets read
// twice.
#include "busy_session.h"

#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"

#include <QtTest>
#include <bit>

using namespace chiron;
using namespace chiron::scoring;
using traces::busySession;
using traces::everyMetric;
using traces::Vec3;

namespace {

bool sameBits(const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() == b.has_value() &&
           (!a || std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(*b));
}

bool sameScores(const ScoreCard& a, const ScoreCard& b) {
    if (a.metrics.size() != b.metrics.size() || a.trials.size() != b.trials.size() || a.passed != b.passed)
        return false;
    for (std::size_t i = 0; i < a.metrics.size(); ++i)
        if (!sameBits(a.metrics[i].value, b.metrics[i].value))
            return false;
    for (std::size_t k = 0; k < a.trials.size(); ++k)
        for (std::size_t i = 0; i < a.trials[k].size(); ++i)
            if (!sameBits(a.trials[k][i].value, b.trials[k][i].value))
                return false;
    return true;
}

} // namespace

class TestScoresAreReproducible : public QObject {
    Q_OBJECT
private slots:
    void sameTraceSameBits();
    void exportedTraceScoresTheSame();
    void storedGridsAreIdempotent();
    void repeatedPacketsChangeNothing();
};

void TestScoresAreReproducible::sameTraceSameBits() {
    const auto all = everyMetric();
    QVERIFY(sameScores(*calculateScore(busySession(), all, {}, true),
                       *calculateScore(busySession(), all, {}, true)));
}

// cli.md: the same score live and from the exported trace.
void TestScoresAreReproducible::exportedTraceScoresTheSame() {
    const auto all = everyMetric();
    const auto trace = busySession();
    const auto live = calculateScore(trace, all, {}, true);
    const std::string csv = writeTraceCsv(rowsOf(trace));
    const auto rows = readTraceCsv(csv, "exported.csv");
    QVERIFY2(rows.has_value(), rows ? "" : rows.error().message.c_str());
    const auto again = buildSessionTrace(*rows, "sphere_apex");
    QVERIFY(again.has_value());
    QCOMPARE(again->forceLimit_N, 1.5);
    const auto fromFile = calculateScore(*again, all, {}, true);
    QVERIFY(fromFile.has_value());
    QVERIFY(sameScores(*live, *fromFile));
    QVERIFY(writeTraceCsv(*rows) == csv);
    for (const auto& metric : live->metrics) { // the comparison above was about numbers
        const bool ofOthers =
            metric.reason.starts_with("the trace has no ") || metric.reason == "no weighing was asked for";
        QVERIFY2(metric.value.has_value() != ofOthers, metric.id.c_str());
    }
}

void TestScoresAreReproducible::storedGridsAreIdempotent() {
    core::Random random(3);
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-9.0, 2.0));
        for (const auto& grid : {onMicroseconds, onNanometres, onMillinewtons}) {
            const double once = grid(x);
            QCOMPARE(std::bit_cast<std::uint64_t>(grid(once)), std::bit_cast<std::uint64_t>(once));
        }
        QVERIFY(std::abs(onNanometres(x) - x) <= 0.5e-9 * (1.0 + 1e-6));
    }
    QVERIFY(!std::signbit(onNanometres(-1e-12)));
}

void TestScoresAreReproducible::repeatedPacketsChangeNothing() {
    const auto all = everyMetric();
    auto trace = busySession();
    const auto before = calculateScore(trace, all, {}, true);
    for (auto& trial : trace.trials)
        for (auto& tool : trial.tools)
            for (std::size_t at : {std::size_t{100}, std::size_t{2000}}) {
                const auto i = static_cast<std::ptrdiff_t>(at);
                tool.t_s.insert(tool.t_s.begin() + i, tool.t_s[at - 1]);
                tool.p_WT_m.insert(tool.p_WT_m.begin() + i, Vec3(tool.p_WT_m[at - 1]));
                tool.tissue_N.insert(tool.tissue_N.begin() + i, Vec3(9.0, 9.0, 9.0));
                tool.commanded_N.insert(tool.commanded_N.begin() + i, Vec3::Zero().eval());
                tool.paused.insert(tool.paused.begin() + i, std::uint8_t{0});
            }
    QVERIFY(sameScores(*before, *calculateScore(trace, all, {}, true)));
}

QTEST_APPLESS_MAIN(TestScoresAreReproducible)
#include "test_scores_are_reproducible.moc"
