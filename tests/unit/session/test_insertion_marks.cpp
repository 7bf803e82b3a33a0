// SPDX-License-Identifier: GPL-3.0-or-later
// Every penalty of an insertion's scores is a mark in playback, with its beginning, end and size.
#include "frames.h"

#include "core/endoscope_cues.h"
#include "scoring/score_calculator.h"
#include "session/insertion_marks.h"
#include "session/worst_moment.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using core::ProcedureStage;
using session::PlaybackMark;
using session::PlaybackMarkKind;
namespace bits = core::event_bits;

namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

/// 2 s at 1 kHz: in, back by 5 mm from 0.5 to 0.6 s, on, over the limit for 50 ms and for 30 ms, inspection from 1.2 s,
/// withdrawal from 1.6 s.
scoring::SessionTrace trace() {
    scoring::TrialTrace trial;
    scoring::ToolTrace tool;
    scoring::InsertionSeries series;
    for (int i = 0; i <= 2000; ++i) {
        const double t = 1e-3 * i;
        const double s_mm = t < 0.5 ? 100.0 * t : t < 0.6 ? 50.0 - 50.0 * (t - 0.5) : 45.0 + 100.0 * (t - 0.6);
        tool.t_s.push_back(t);
        tool.p_WT_m.push_back(core::Vec3(1e-3 * s_mm, 0.0, 0.0));
        tool.tissue_N.push_back(core::Vec3::Zero());
        tool.paused.push_back(0);
        series.s_m.push_back(1e-3 * s_mm);
        series.offset_m.push_back(0.0);
        series.alignment_rad.push_back(0.0);
        series.lateral_N.push_back(i >= 800 && i < 850 ? 2.5 : i >= 900 && i < 930 ? 3.25 : 0.0);
        series.axialTorque_Nm.push_back(0.0);
        series.stage.push_back(static_cast<std::uint8_t>(t < 0.1   ? ProcedureStage::outside
                                                         : t < 1.2 ? ProcedureStage::insertion
                                                         : t < 1.6 ? ProcedureStage::inspection
                                                         : i < 2000 ? ProcedureStage::withdrawal
                                                                    : ProcedureStage::completed));
    }
    series.length_m = 0.11;
    series.bend_m = 0.04;
    series.goal_m = 0.12;
    series.landmarkSeen_s = {1.5, kNever, 1.3, 1.5};
    trial.tools.push_back(std::move(tool));
    trial.insertion = std::move(series);
    scoring::SessionTrace session;
    session.exercise = "urethra_insertion";
    session.trials.push_back(std::move(trial));
    return session;
}

/// The same session's frames, through the extractor.
session::PlaybackTrack track(std::uint32_t lastEvent = bits::kCompleted | bits::kStageChanged) {
    auto frames = tests::someFrames(2001);
    frames[0].header.events = bits::kTrialStarted;
    for (const std::size_t at : {std::size_t{100}, std::size_t{1200}, std::size_t{1600}})
        frames[at].header.events |= bits::kStageChanged;
    frames[1300].header.events |= bits::kLandmarkSeen;
    frames[1500].header.events |= bits::kLandmarkSeen;
    frames[2000].header.events |= lastEvent;
    session::MarkExtractor marks(4.0, 1);
    session::PlaybackTrack track;
    track.toolCount = 1;
    for (const core::HapticFrame& frame : frames) {
        const double t_s = 1e-3 * static_cast<double>(frame.header.index);
        marks.add(frame, t_s);
        if (frame.header.index % 4 == 0) {
            track.moments.push_back({t_s, frame.header.index, 0, frame.header.phase, frame.header.force, false});
            track.tools.emplace_back();
        }
    }
    track.marks = marks.take(2.0);
    session::PlaybackTrial trial;
    trial.end_s = 2.0;
    track.trials.push_back(trial);
    return track;
}

std::vector<PlaybackMark> ofKind(const session::PlaybackTrack& track, PlaybackMarkKind kind) {
    std::vector<PlaybackMark> found;
    for (const PlaybackMark& mark : track.marks)
        if (mark.kind == kind)
            found.push_back(mark);
    return found;
}

} // namespace

class TestInsertionMarks : public QObject {
    Q_OBJECT
private slots:
    void procedureEventsAreMarks();
    void penaltiesAreWhatIsCounted();
    void stagesAndLandmarksAreTold();
    void stagesThatDoNotFitStayUntold();
    void timeUpOfAProcedure();
    void otherTracksStayAsTheyAre();
    void penaltiesArePenalties();
    void worstMomentIsTheWorstEvent();
};

void TestInsertionMarks::procedureEventsAreMarks() {
    const auto made = track();
    QCOMPARE(ofKind(made, PlaybackMarkKind::stageChanged).size(), std::size_t{3}); // the last one is the completion
    QCOMPARE(ofKind(made, PlaybackMarkKind::landmarkSeen).size(), std::size_t{2});
    QCOMPARE(ofKind(made, PlaybackMarkKind::completed).size(), std::size_t{1});
    QCOMPARE(ofKind(made, PlaybackMarkKind::completed)[0].t_s, 2.0);
    QVERIFY(ofKind(made, PlaybackMarkKind::marked).empty() && ofKind(made, PlaybackMarkKind::timedOut).empty());
}

void TestInsertionMarks::penaltiesAreWhatIsCounted() {
    auto made = track();
    QVERIFY(session::addInsertionMarks(made, trace()));
    const auto trauma = ofKind(made, PlaybackMarkKind::trauma);
    const auto reversals = ofKind(made, PlaybackMarkKind::reversal);
    const std::vector<scoring::MetricRequest> wanted{{"trauma_events", 1}, {"reversals", 1}};
    const auto card = scoring::calculateScore(trace(), wanted, {}, true);
    QVERIFY(card);
    QCOMPARE(static_cast<double>(trauma.size()), *card->metrics[0].value);
    QCOMPARE(static_cast<double>(reversals.size()), *card->metrics[1].value);
    QCOMPARE(trauma.size(), std::size_t{2});
    QCOMPARE(trauma[1].t_s, 0.9);
    QCOMPARE(trauma[1].end_s, 0.93);
    QCOMPARE(*trauma[1].value, 3.25);
    QCOMPARE(trauma[1].tick, std::uint64_t{900});
    QCOMPARE(reversals.size(), std::size_t{1});
    QCOMPARE(reversals[0].t_s, 0.5);
    QCOMPARE(reversals[0].end_s, 0.6);
    QVERIFY(std::abs(*reversals[0].value - 0.005) < 1e-12);
    QVERIFY(std::is_sorted(made.marks.begin(), made.marks.end(),
                           [](const PlaybackMark& a, const PlaybackMark& b) { return a.t_s < b.t_s; }));
}

void TestInsertionMarks::stagesAndLandmarksAreTold() {
    auto made = track();
    QVERIFY(session::addInsertionMarks(made, trace()));
    const auto stages = ofKind(made, PlaybackMarkKind::stageChanged);
    QCOMPARE(stages[0].detail, std::string("insertion"));
    QCOMPARE(stages[1].detail, std::string("inspection"));
    QCOMPARE(stages[2].detail, std::string("withdrawal"));
    const auto seen = ofKind(made, PlaybackMarkKind::landmarkSeen);
    QCOMPARE(*seen[0].value, 1.0);
    QCOMPARE(*seen[1].value, 3.0); // two at once
}

void TestInsertionMarks::stagesThatDoNotFitStayUntold() {
    auto made = track();
    auto cut = trace();
    std::fill(cut.trials[0].insertion->stage.begin(), cut.trials[0].insertion->stage.end(),
              static_cast<std::uint8_t>(ProcedureStage::insertion));
    QVERIFY(session::addInsertionMarks(made, cut));
    for (const PlaybackMark& mark : ofKind(made, PlaybackMarkKind::stageChanged))
        QVERIFY(mark.detail.empty());
}

void TestInsertionMarks::timeUpOfAProcedure() {
    auto made = track(bits::kTimedOut);
    QVERIFY(ofKind(made, PlaybackMarkKind::timedOut).at(0).detail.empty());
    QVERIFY(session::addInsertionMarks(made, trace()));
    QCOMPARE(ofKind(made, PlaybackMarkKind::timedOut).at(0).detail, std::string(session::kProcedure));
}

void TestInsertionMarks::otherTracksStayAsTheyAre() {
    auto made = track();
    const auto before = made.marks.size();
    auto other = trace();
    other.trials[0].insertion.reset();
    QVERIFY(session::addInsertionMarks(made, other));
    QCOMPARE(made.marks.size(), before);
    auto bad = trace();
    bad.trials[0].insertion->s_m.pop_back();
    QVERIFY(!session::addInsertionMarks(made, bad));
}

void TestInsertionMarks::penaltiesArePenalties() {
    QVERIFY(session::isPenalty(PlaybackMarkKind::trauma));
    QVERIFY(session::isPenalty(PlaybackMarkKind::reversal));
    for (const auto kind : {PlaybackMarkKind::completed, PlaybackMarkKind::stageChanged, PlaybackMarkKind::landmarkSeen,
                            PlaybackMarkKind::contact, PlaybackMarkKind::marked})
        QVERIFY(!session::isPenalty(kind));
}

void TestInsertionMarks::worstMomentIsTheWorstEvent() {
    auto made = track();
    QVERIFY(session::addInsertionMarks(made, trace()));
    const auto worstOf = [&](const std::string& metric) {
        scoring::ScoreCard card;
        card.metrics.push_back({metric, 1, "count", 2.0, "", false});
        const scoring::Gate gate{metric, std::nullopt, 0.0};
        return session::worstMoment(made, card, {&gate, 1});
    };
    const auto trauma = worstOf("trauma_events");
    QVERIFY(trauma && trauma->gateFailed);
    QCOMPARE(trauma->t_s, 0.9);
    QCOMPARE(trauma->value, 3.25);
    QCOMPARE(trauma->unit, std::string("N"));
    const auto reversal = worstOf("reversals");
    QVERIFY(reversal);
    QCOMPARE(reversal->t_s, 0.5);
    QVERIFY(std::abs(reversal->value - 5.0) < 1e-9);
    QCOMPARE(reversal->unit, std::string("mm"));
}

QTEST_APPLESS_MAIN(TestInsertionMarks)
#include "test_insertion_marks.moc"
