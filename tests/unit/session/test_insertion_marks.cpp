// SPDX-License-Identifier: GPL-3.0-or-later
// Every penalty of an insertion's scores is a mark in playback, with its beginning, end and size.
#include "insertion_session.h"

#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"
#include "scoring/score_calculator.h"
#include "session/worst_moment.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <tuple>

using namespace chiron;
using session::PlaybackMark;
using simulation::ProcedureStage;
namespace mark_kinds = session::mark_kinds;
using tests::ofKind;
using tests::trace;
using tests::track;
namespace bits = core::event_bits;

class TestInsertionMarks : public QObject {
    Q_OBJECT
private slots:
    void procedureEventsAreMarks();
    void penaltiesAreWhatIsCounted();
    void stagesAndLandmarksAreTold();
    void trialThatBeginsInsideTellsItsStages();
    void stagesThatDoNotFitStayUntold();
    void trialsKeepTheirMarks();
    void otherTracksStayAsTheyAre();
    void longOrHardTraumaIsACriticalError();
    void penaltiesArePenalties();
    void worstMomentIsTheWorstEvent();
};

void TestInsertionMarks::procedureEventsAreMarks() {
    const auto made = track();
    QCOMPARE(ofKind(made, mark_kinds::kStageChanged).size(),
             std::size_t{3}); // the last one is the completion
    QCOMPARE(ofKind(made, mark_kinds::kLandmarkSeen).size(), std::size_t{2});
    QCOMPARE(ofKind(made, mark_kinds::kCompleted).size(), std::size_t{1});
    QCOMPARE(ofKind(made, mark_kinds::kCompleted)[0].t_s, 2.0);
    QVERIFY(ofKind(made, mark_kinds::kMarked).empty() && ofKind(made, mark_kinds::kTimedOut).empty());
}

void TestInsertionMarks::penaltiesAreWhatIsCounted() {
    auto made = track();
    QVERIFY(session::addInsertionMarks(made, trace(), {}));
    const auto trauma = ofKind(made, mark_kinds::kTrauma);
    const auto reversals = ofKind(made, mark_kinds::kReversal);
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
    QVERIFY(session::addInsertionMarks(made, trace(), {}));
    const auto stages = ofKind(made, mark_kinds::kStageChanged);
    QCOMPARE(stages[0].detail, std::string("insertion"));
    QCOMPARE(stages[1].detail, std::string("inspection"));
    QCOMPARE(stages[2].detail, std::string("withdrawal"));
    const auto seen = ofKind(made, mark_kinds::kLandmarkSeen);
    QCOMPARE(*seen[0].value, 1.0);
    QCOMPARE(*seen[1].value, 3.0); // two at once
}

// The first change then falls on the tick that starts the trial.
void TestInsertionMarks::trialThatBeginsInsideTellsItsStages() {
    auto made = track();
    auto begun = trace();
    auto& stage = insertionIn(begun.trials[0]).stage;
    std::replace(stage.begin(), stage.end(), static_cast<std::uint8_t>(ProcedureStage::outside),
                 static_cast<std::uint8_t>(ProcedureStage::insertion));
    PlaybackMark& first = *std::find_if(made.marks.begin(), made.marks.end(), [](const PlaybackMark& mark) {
        return mark.kind == mark_kinds::kStageChanged;
    });
    first.t_s = first.end_s = 0.0;
    QVERIFY(session::addInsertionMarks(made, begun, {}));
    const auto stages = ofKind(made, mark_kinds::kStageChanged);
    QCOMPARE(stages.size(), std::size_t{3});
    QCOMPARE(stages[0].t_s, 0.0);
    QCOMPARE(stages[0].detail, std::string("insertion"));
    QCOMPARE(stages[1].detail, std::string("inspection"));
    QCOMPARE(stages[2].detail, std::string("withdrawal"));
}

void TestInsertionMarks::stagesThatDoNotFitStayUntold() {
    auto made = track();
    auto cut = trace();
    std::fill(insertionIn(cut.trials[0]).stage.begin(), insertionIn(cut.trials[0]).stage.end(),
              static_cast<std::uint8_t>(ProcedureStage::insertion));
    QVERIFY(session::addInsertionMarks(made, cut, {}));
    for (const PlaybackMark& mark : ofKind(made, mark_kinds::kStageChanged))
        QVERIFY(mark.detail.empty());
}

// A second trial that ends within the inspection and sees one landmark: neither tells the other its stages,
// landmarks or end.
void TestInsertionMarks::trialsKeepTheirMarks() {
    constexpr double kLater_s = 3.0;
    auto made = track();
    const std::vector<PlaybackMark> first = made.marks;
    for (PlaybackMark mark : first) {
        const bool withdrawn = mark.kind == mark_kinds::kStageChanged && mark.t_s > 1.5;
        if (withdrawn || mark.kind == mark_kinds::kCompleted)
            continue;
        mark.t_s += kLater_s;
        mark.trial = 1;
        made.marks.push_back(mark);
    }
    PlaybackMark end;
    end.t_s = kLater_s + 2.0;
    end.trial = 1;
    end.kind = mark_kinds::kTimedOut;
    made.marks.push_back(end);
    scoring::SessionTrace both = trace();
    scoring::TrialTrace second = both.trials.front();
    second.trial = 1;
    for (double& t_s : second.tools.front().t_s)
        t_s += kLater_s;
    for (std::uint8_t& stage : insertionIn(second).stage)
        if (stage > static_cast<std::uint8_t>(ProcedureStage::inspection))
            stage = static_cast<std::uint8_t>(ProcedureStage::inspection);
    insertionIn(second).landmarkSeen_s = {kLater_s + 1.5, kLater_s + 1.3};
    both.trials.push_back(second);
    QVERIFY(session::addInsertionMarks(made, both, {}));
    std::array<std::vector<std::string>, 2> stages;
    for (const PlaybackMark& mark : ofKind(made, mark_kinds::kStageChanged))
        stages[static_cast<std::size_t>(mark.trial)].push_back(mark.detail);
    QVERIFY((stages[0] == std::vector<std::string>{"insertion", "inspection", "withdrawal"}));
    QVERIFY((stages[1] == std::vector<std::string>{"insertion", "inspection"}));
    std::array<std::vector<double>, 2> seen;
    for (const PlaybackMark& mark : ofKind(made, mark_kinds::kLandmarkSeen))
        seen[static_cast<std::size_t>(mark.trial)].push_back(mark.value.value_or(-1.0));
    QVERIFY((seen[0] == std::vector<double>{1.0, 3.0}));
    QVERIFY((seen[1] == std::vector<double>{1.0, 2.0}));
}

void TestInsertionMarks::otherTracksStayAsTheyAre() {
    auto made = track();
    const auto before = made.marks.size();
    auto other = trace();
    other.trials[0].own.reset();
    QVERIFY(session::addInsertionMarks(made, other, {}));
    QCOMPARE(made.marks.size(), before);
    auto bad = trace();
    insertionIn(bad.trials[0]).s_m.pop_back();
    QVERIFY(!session::addInsertionMarks(made, bad, {}));
}

// What the score counts as a critical error, playback marks as one; by a session's own version of the metric.
void TestInsertionMarks::longOrHardTraumaIsACriticalError() {
    const auto pressed = [](int ticks, double force_N) {
        auto made = trace();
        for (int i = 0; i < ticks; ++i)
            insertionIn(made.trials[0]).lateral_N[static_cast<std::size_t>(300 + i)] = force_N;
        return made;
    };
    for (const auto& [ticks, force_N, critical] :
         {std::tuple{1100, 2.5, 1}, {400, 4.1, 1}, {400, 3.9, 0}, {990, 2.5, 0}})
        for (const int version : {1, 2}) {
            const auto session = pressed(ticks, force_N);
            const std::vector<scoring::MetricRequest> wanted{{"critical_errors", version}};
            const auto card = scoring::calculateScore(session, wanted, {}, true);
            QVERIFY(card);
            auto made = track();
            QVERIFY(
                session::addInsertionMarks(made, session, {}, version >= scoring::kCriticalSpansCountFrom));
            const auto marked = std::count_if(made.marks.begin(), made.marks.end(),
                                              [](const PlaybackMark& mark) { return mark.critical; });
            QCOMPARE(static_cast<double>(marked), *card->metrics[0].value);
            QCOMPARE(int(marked), version == 1 ? 0 : critical);
        }
    auto made = track(); // the score's worst moment is that mark, though a shorter one was harder
    auto session = pressed(450, 2.5);
    insertionIn(session.trials[0]).lateral_N.assign(2001, 0.0);
    for (int i = 100; i < 1300; ++i)
        insertionIn(session.trials[0]).lateral_N[static_cast<std::size_t>(i)] = 2.5;
    for (int i = 1500; i < 1600; ++i)
        insertionIn(session.trials[0]).lateral_N[static_cast<std::size_t>(i)] = 3.5;
    QVERIFY(session::addInsertionMarks(made, session, {}, true));
    const std::vector<scoring::MetricRequest> wanted{{"critical_errors", 2}};
    const std::vector<scoring::Gate> gates{{"critical_errors", std::nullopt, 0.0}};
    const auto card = scoring::calculateScore(session, wanted, gates, true);
    QVERIFY(card);
    const auto worst = session::worstMoment(made, *card, gates);
    QVERIFY(worst && worst->reason == "critical_errors" && worst->t_s == 0.1);
}

void TestInsertionMarks::penaltiesArePenalties() {
    QVERIFY(session::isPenalty(mark_kinds::kTrauma));
    QVERIFY(session::isPenalty(mark_kinds::kReversal));
    for (const auto kind : {mark_kinds::kCompleted, mark_kinds::kStageChanged, mark_kinds::kLandmarkSeen,
                            mark_kinds::kContact, mark_kinds::kMarked})
        QVERIFY(!session::isPenalty(kind));
}

void TestInsertionMarks::worstMomentIsTheWorstEvent() {
    auto made = track();
    QVERIFY(session::addInsertionMarks(made, trace(), {}));
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
