// SPDX-License-Identifier: GPL-3.0-or-later
// Where offset, alignment and torque were largest, and where they went beyond the level's gates.
#include "insertion_session.h"

#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "scoring/score_calculator.h"
#include "session/worst_moment.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
namespace mark_kinds = session::mark_kinds;
using tests::ofKind;
using tests::trace;
using tests::track;

namespace {

/// Offset, tilt and torque with peaks inside; the largest offset of all in the bladder, and one more in a
/// pause.
scoring::SessionTrace unsteady() {
    auto session = trace();
    auto& trial = session.trials[0];
    scoring::ToolTrace& tool = trial.tools[0];
    scoring::InsertionSeries& series = insertionIn(trial);
    tool.q_WT.assign(tool.t_s.size(), core::Quat::Identity());
    tool.tissueTorque_Nm.assign(tool.t_s.size(), core::Vec3::Zero());
    const auto from = [](int first, int end, auto&& set) {
        for (int i = first; i < end; ++i)
            set(static_cast<std::size_t>(i));
    };
    from(300, 340, [&](std::size_t i) { series.offset_m[i] = 0.004; });
    from(320, 321, [&](std::size_t i) { series.offset_m[i] = 0.005; });
    from(700, 701, [&](std::size_t i) { series.offset_m[i] = 0.0035; });
    from(750, 760, [&](std::size_t i) { series.offset_m[i] = 0.003; }); // at the gate: held
    from(780, 790, [&](std::size_t i) { series.offset_m[i] = 0.009, tool.paused[i] = 1; });
    from(1700, 1800,
         [&](std::size_t i) { series.offset_m[i] = 0.030; }); // in the bladder, where it is no matter
    from(450, 451, [&](std::size_t i) { series.alignment_rad[i] = 0.3; }); // s = 45 mm: at the bend
    from(1000, 1001, [&](std::size_t i) { series.alignment_rad[i] = 0.5; });
    from(1400, 1420, [&](std::size_t i) { tool.tissueTorque_Nm[i] = core::Vec3(0.0, 0.06, 0.08); });
    return session;
}

} // namespace

class TestInsertionPeaks : public QObject {
    Q_OBJECT
private slots:
    void gatesOnPeaksAreMarks();
    void worstMomentOfAPeak();
};

void TestInsertionPeaks::gatesOnPeaksAreMarks() {
    const std::vector<scoring::Gate> gates{{"offset_max", std::nullopt, 3.0},
                                           {"torque_max", std::nullopt, 90.0}};
    auto made = track();
    QVERIFY(session::addInsertionMarks(made, unsteady(), gates));
    const auto off = ofKind(made, mark_kinds::kOffCentre);
    QCOMPARE(off.size(), std::size_t{2});
    QCOMPARE(off[0].t_s, 0.3);
    QCOMPARE(off[0].end_s, 0.34);
    QCOMPARE(*off[0].value, 0.005);
    QCOMPARE(off[0].tick, std::uint64_t{300});
    QCOMPARE(off[1].t_s, 0.7);
    QCOMPARE(off[1].end_s, 0.701);
    const auto torque = ofKind(made, mark_kinds::kOverTorque);
    QCOMPARE(torque.size(), std::size_t{1});
    QCOMPARE(torque[0].t_s, 1.4);
    QCOMPARE(torque[0].end_s, 1.42);
    QVERIFY(std::abs(*torque[0].value - 0.1) < 1e-12);
    QVERIFY(session::isPenalty(mark_kinds::kOffCentre) && session::isPenalty(mark_kinds::kOverTorque));

    auto ungated = track();
    const std::vector<scoring::Gate> others{{"offset_rms", std::nullopt, 3.0},
                                            {"torque_max", 1.0, std::nullopt}};
    QVERIFY(session::addInsertionMarks(ungated, unsteady(), others));
    QVERIFY(ofKind(ungated, mark_kinds::kOffCentre).empty() &&
            ofKind(ungated, mark_kinds::kOverTorque).empty());
}

void TestInsertionPeaks::worstMomentOfAPeak() {
    auto made = track();
    QVERIFY(session::addInsertionMarks(made, unsteady(), {}));
    const std::vector<scoring::MetricRequest> wanted{{"offset_max", 1}, {"torque_max", 1}};
    const auto card = scoring::calculateScore(unsteady(), wanted, {}, true);
    QVERIFY(card);
    const auto worstOf = [&](const std::string& metric) {
        scoring::ScoreCard failed;
        failed.metrics.push_back({metric, 1, "", 2.0, "", false});
        failed.trials.push_back({{metric, 1, "", 2.0, "", std::nullopt}});
        const scoring::Gate gate{metric, std::nullopt, 0.0};
        return *session::worstMoment(made, failed, {&gate, 1});
    };
    for (const char* metric : {"offset_max", "offset_rms"}) {
        QCOMPARE(worstOf(metric).t_s, 0.32);
        QCOMPARE(worstOf(metric).value, *card->metrics[0].value); // what the metric itself says
        QCOMPARE(worstOf(metric).unit, std::string("mm"));
    }
    QCOMPARE(worstOf("alignment_rms").t_s, 1.0);
    QCOMPARE(worstOf("bend_alignment").t_s, 0.45);
    QCOMPARE(worstOf("bend_alignment").unit, std::string("°"));
    for (const char* metric : {"torque_max", "torque_rms"}) {
        QCOMPARE(worstOf(metric).t_s, 1.4);
        QCOMPARE(worstOf(metric).value, *card->metrics[1].value);
        QCOMPARE(worstOf(metric).unit, std::string("mN·m"));
    }
    QCOMPARE(worstOf("insertion_depth").t_s, 2.0); // of the trial as a whole: its end
    QVERIFY(worstOf("offset_max").gateFailed);
}

QTEST_APPLESS_MAIN(TestInsertionPeaks)
#include "test_insertion_peaks.moc"
