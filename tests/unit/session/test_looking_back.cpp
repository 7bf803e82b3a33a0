// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording is said to tell: stops, limits, misses, the worst moment, what was felt.
#include "app/exercises/palpation/session/palpation_marks.h"
#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "core/contact_bits.h"
#include "core/random.h"
#include "cues/laparoscopy_cues.h"
#include "frames.h"
#include "scoring/force_facts.h"
#include "session/exercise_kind.h"
#include "session/playback_mark.h"
#include "session/session_setup.h"
#include "session/worst_moment.h"
#include "session/yield_cause.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::session;

namespace {

std::vector<PlaybackMark> marksOf(const std::vector<core::HapticFrame>& frames, bool felt = false) {
    MarkExtractor extractor(4.0, 1, felt);
    for (const core::HapticFrame& frame : frames)
        extractor.add(frame, 1e-3 * static_cast<double>(frame.header.index));
    return extractor.take(1e-3 * static_cast<double>(frames.size() - 1));
}

std::vector<PlaybackMark> ofKind(const std::vector<PlaybackMark>& marks, const PlaybackMarkKind& kind) {
    std::vector<PlaybackMark> found;
    for (const PlaybackMark& mark : marks)
        if (mark.kind == kind)
            found.push_back(mark);
    return found;
}

PlaybackMark markAt(double t_s, const PlaybackMarkKind& kind, std::optional<double> value = {}) {
    PlaybackMark mark;
    mark.t_s = mark.end_s = t_s;
    mark.kind = kind;
    mark.value = value;
    return mark;
}

/// Ten seconds of one trial that touches with 3 N at 2 s and with next to nothing at its end.
PlaybackTrack quietEnd() {
    PlaybackTrack track;
    track.toolCount = 1;
    for (int i = 0; i <= 1000; ++i) {
        PlaybackMoment moment;
        moment.t_s = 0.01 * i;
        moment.phase = core::TrialPhase::running;
        track.moments.push_back(moment);
        PlaybackTool tool;
        tool.tissue_N = core::Vec3(0.0, 0.0, i == 200 ? 3.0 : 0.02);
        track.tools.push_back(tool);
    }
    PlaybackTrial trial;
    trial.end_s = 10.0;
    track.trials.push_back(trial);
    return track;
}

scoring::ScoreCard failed(std::initializer_list<std::pair<const char*, double>> metrics) {
    scoring::ScoreCard card;
    card.trials.emplace_back();
    for (const auto& [id, value] : metrics) {
        card.metrics.push_back({id, 1, "count", value, "", false});
        card.trials[0].push_back({id, 1, "count", value, "", {}});
    }
    return card;
}

} // namespace

class TestLookingBack : public QObject {
    Q_OBJECT
private slots:
    void aStopIsNoPause() {
        auto frames = tests::someFrames(1000);
        for (std::size_t i = 300; i < 500; ++i) { // stopped, then armed again
            frames[i].header.paused = 1;
            frames[i].header.force = core::ForceState::stopped;
        }
        for (std::size_t i = 700; i < 800; ++i) {
            frames[i].header.paused = 1;
            frames[i].header.force = core::ForceState::paused;
        }
        const auto marks = marksOf(frames);
        const auto stops = ofKind(marks, mark_kinds::kForceStopped);
        QCOMPARE(stops.size(), std::size_t(1));
        QCOMPARE(stops[0].t_s, 0.3);
        QCOMPARE(stops[0].end_s, 0.499);
        const auto pauses = ofKind(marks, mark_kinds::kPaused);
        QCOMPARE(pauses.size(), std::size_t(1));
        QCOMPARE(pauses[0].t_s, 0.7);
    }

    /// A guard that acts for many ticks is one event, and again one when it acts anew.
    void aGuardIsMarkedWhereItBegins() {
        auto frames = tests::someFrames(600);
        for (std::size_t i = 0; i < frames.size(); ++i)
            frames[i].header.guards = (i >= 100 && i < 200) || i >= 400 ? core::guard_bits::kOverVelocity : 0;
        const auto guards = ofKind(marksOf(frames), mark_kinds::kGuard);
        QCOMPARE(guards.size(), std::size_t(2));
        QCOMPARE(guards[0].t_s, 0.1);
        QCOMPARE(guards[1].t_s, 0.4);
        QCOMPARE(guards[0].detail, std::string("over_velocity"));
    }

    void aStopFromAPauseEndsThePause() {
        auto frames = tests::someFrames(600);
        for (std::size_t i = 100; i < 500; ++i) {
            frames[i].header.paused = 1;
            frames[i].header.force = i < 300 ? core::ForceState::paused : core::ForceState::stopped;
        }
        const auto marks = marksOf(frames);
        const auto pauses = ofKind(marks, mark_kinds::kPaused);
        QCOMPARE(pauses.size(), std::size_t(1));
        QVERIFY(pauses[0].end_s <= 0.3);
        QCOMPARE(ofKind(marks, mark_kinds::kForceStopped).front().end_s, 0.499);
    }

    void whatWasFeltIsToldWhereItWasLess() {
        auto frames = tests::someFrames(1000);
        for (core::HapticFrame& frame : frames) {
            frame.header.phase = core::TrialPhase::running;
            frame.tool[0].tissue = {};
            frame.tool[0].commanded = {};
        }
        for (std::size_t i = 200; i < 400; ++i) {
            frames[i].tool[0].tissue[2] = 6.0;
            frames[i].tool[0].commanded[2] = 4.0;
        }
        frames[800].tool[0].tissue[2] = 6.0; // one tick of the slew: nobody feels it
        const auto limited = ofKind(marksOf(frames, true), mark_kinds::kLimited);
        QCOMPARE(limited.size(), std::size_t(1));
        QCOMPARE(limited[0].t_s, 0.2);
        QCOMPARE(limited[0].value, std::optional(6.0));
        QVERIFY(!isPenalty(mark_kinds::kLimited)); // the safety did that, not the person
        QVERIFY(ofKind(marksOf(frames, false), mark_kinds::kLimited).empty());
    }

    void forceFactsLeaveOutPausesAndCountSharedTimeOnce() {
        scoring::SessionTrace trace;
        scoring::ToolTrace tool;
        for (int i = 0; i < 1000; ++i) {
            tool.t_s.push_back(1e-3 * i);
            tool.p_WT_m.push_back(core::Vec3::Zero());
            const bool paused = i >= 900;
            tool.tissue_N.push_back(core::Vec3(0.0, 0.0, paused ? 50.0 : i >= 200 && i < 300 ? 6.0 : 1.0));
            tool.commanded_N.push_back(core::Vec3(0.0, 0.0, i >= 200 && i < 300 ? 4.0 : 1.0));
            tool.paused.push_back(paused ? 1 : 0);
            tool.contact.push_back(i < 18 ? core::contact_bits::kBeyondChecked : 0);
        }
        scoring::TrialTrace trial;
        trial.tools = {tool, tool};
        trace.trials.push_back(trial);
        const scoring::ForceFacts facts = scoring::forceFactsOf(trace);
        QCOMPARE(facts.tissue_N, 6.0);
        QCOMPARE(facts.commanded_N, 4.0);
        QVERIFY(std::abs(facts.limited_s - 0.1) < 1e-9);
        QCOMPARE(facts.firstLimited_s, std::optional(0.2));
        QVERIFY(std::abs(facts.beyondCheckedShare() - 0.02) < 1e-12);
        QVERIFY(!scoring::forceFactsOf({}).firstLimited_s &&
                scoring::forceFactsOf({}).beyondCheckedShare() == 0.0);
    }

    void theWorstMomentIsWhereItHappenedNotWhereTheTrialEnded() {
        PlaybackTrack track = quietEnd();
        track.exercise = "elastic_tube";
        track.marks = {markAt(4.0, mark_kinds::kSlipped), markAt(6.0, mark_kinds::kYielded, 9.0),
                       markAt(5.0, mark_kinds::kYielded, 8.0)};
        const std::vector<scoring::Gate> gates{
            {"procedure_completed", 100.0, {}}, {"drops", {}, 0.0}, {"critical_errors", {}, 0.0}};
        const auto broken = worstMoment(
            track, failed({{"procedure_completed", 0.0}, {"drops", 1.0}, {"critical_errors", 2.0}}), gates);
        QCOMPARE(broken->reason, std::string("critical_errors"));
        QCOMPARE(broken->t_s, 6.0); // the larger of two, and not the first gate's
        const auto dropped =
            worstMoment(track, failed({{"procedure_completed", 0.0}, {"drops", 1.0}}), gates);
        QCOMPARE(dropped->reason, std::string("drops"));
        QCOMPARE(dropped->t_s, 4.0);
        // What is spread over a trial gives way to any other gate, though its tube tore; alone it leads
        // there.
        PlaybackTrack torn = quietEnd();
        torn.exercise = "elastic_tube";
        torn.marks = {markAt(3.0, mark_kinds::kFailed), markAt(4.0, mark_kinds::kSlipped)};
        QCOMPARE(worstMoment(torn, failed({{"procedure_completed", 0.0}, {"drops", 1.0}}), gates)->t_s, 4.0);
        QCOMPARE(worstMoment(torn, failed({{"procedure_completed", 0.0}}), gates)->t_s, 3.0);
        const auto none = worstMoment(track, {}, gates);
        QCOMPARE(none->t_s, 2.0);
        QCOMPARE(none->value, 3.0);
        for (PlaybackTool& tool : track.tools)
            tool.tissue_N *= 0.005; // noise of a force that was never felt
        QVERIFY(!worstMoment(track, {}, gates));
    }

    /// A light touch is no worst moment; a force near the limit is, and so is a trial that would have failed.
    void withoutAFailedGateOnlyWhatMattersStandsOut() {
        PlaybackTrack track = quietEnd(); // its largest force is 3 N
        track.exercise = "elastic_tube";
        PlaybackTrial second = track.trials[0];
        track.trials[0].end_s = 5.0;
        second.index = 1;
        second.start_s = 5.5;
        track.trials.push_back(second);
        const std::vector<scoring::Gate> gates{
            {"over_stretches", {}, 3.0}, {"tension_error_rms", {}, 0.1}, {"time_in_band", 2.0, {}}};
        scoring::ScoreCard card;
        card.metrics = {{"over_stretches", 1, "count", 2.0, "", true},
                        {"tension_error_rms", 1, "N", 0.08, "", true},
                        {"time_in_band", 1, "s", 2.5, "", true}};
        const auto trial = [](double error_N, double held_s) {
            return std::vector<scoring::MetricValue>{{"over_stretches", 1, "count", 2.0, "", {}},
                                                     {"tension_error_rms", 1, "N", error_N, "", {}},
                                                     {"time_in_band", 1, "s", held_s, "", {}}};
        };
        card.trials = {trial(0.09, 2.4), trial(0.07, 2.6)};
        track.forceLimit_N = 4.0;
        QVERIFY(!worstMoment(track, card, gates)); // 75 % of the limit, and every trial by itself is good
        track.forceLimit_N = 3.5;
        const auto near = worstMoment(track, card, gates);
        QVERIFY(near && !near->gateFailed);
        QCOMPARE(near->reason, std::string("force_max"));
        QCOMPARE(near->value, 3.0);
        track.forceLimit_N = 4.0;
        card.trials = {trial(0.05, 2.4), trial(0.11, 1.0)}; // the first gate of the two comes first
        const auto wide = worstMoment(track, card, gates);
        QVERIFY(wide && !wide->gateFailed);
        QCOMPARE(wide->reason, std::string("tension_error_rms"));
        QCOMPARE(wide->trial, 1);
        QCOMPARE(wide->value, 0.11);
        card.trials = {trial(0.05, 1.0), trial(0.09, 4.0)};
        const auto brief = worstMoment(track, card, gates);
        QVERIFY(brief && brief->reason == "time_in_band" && brief->trial == 0);
        card.trials = {trial(0.05, 4.0), trial(0.09, 4.0)};
        card.trials[0][0].value = 4.0; // a count is the session's
        QVERIFY(!worstMoment(track, card, gates));
    }

    // The recording keeps what the tissue answered, and that tells which of its two limits it met.
    void tissueTellsWhetherForceOrTorqueBrokeIt() {
        simulation::YieldLaw law;
        law.force_N = 8.0;
        law.torque_Nm = 0.213;
        core::Random random(20261125);
        int byTorque = 0;
        for (int i = 0; i < 2000; ++i) {
            const double wanted_N = random.uniform(0.0, 20.0), wanted_Nm = random.uniform(0.0, 0.6);
            simulation::TissueYield yield(law);
            yield.step(0.0, false, 1e-3);
            const double left = yield.step(wanted_N, false, 1e-3, wanted_Nm);
            if (!yield.yielded())
                continue;
            const bool torque = wanted_Nm / law.torque_Nm > wanted_N / law.force_N;
            QCOMPARE(gaveWayToTorque(law, left * wanted_N, left * wanted_Nm), torque);
            byTorque += torque ? 1 : 0;
        }
        QVERIFY(byTorque > 100);
        simulation::YieldLaw before; // content of before has no yield torque
        before.force_N = 8.0;
        QVERIFY(!gaveWayToTorque(before, 0.1, 5.0) && !gaveWayToTorque({}, 0.0, 5.0));
        const YieldCause stored = yieldCauseOf(law, "{\"trial\":0,\"force_mN\":2000,\"torque_mN_m\":213}");
        QVERIFY(stored.byTorque && stored.value == 213.0);
        const YieldCause old = yieldCauseOf(before, "{\"trial\":0,\"force_mN\":8000,\"torque_mN_m\":213}");
        QVERIFY(!old.byTorque && old.value == 8.0);
        QVERIFY(!yieldCauseOf(law, "damaged").byTorque);
    }

    void aYieldIsMarkedByWhatItGaveWayTo() {
        auto frames = tests::someFrames(12);
        for (core::HapticFrame& frame : frames)
            frame.header.phase = core::TrialPhase::running;
        frames[5].tool[0].tissue = {0.0, 2.0, 0.0, 0.0, 0.0, 0.213};
        frames[5].tool[0].status |=
            core::contactStatus(core::contact_bits::kYielded | core::contact_bits::kThrough);
        const auto marked = [&](const simulation::YieldLaw& law, bool countsErrors = true) {
            MarkExtractor extractor(4.0, 1, false, law, nullptr, {}, countsErrors);
            for (const core::HapticFrame& frame : frames)
                extractor.add(frame, 1e-3 * static_cast<double>(frame.header.index));
            return ofKind(extractor.take(0.011), mark_kinds::kYielded).at(0);
        };
        simulation::YieldLaw law;
        law.force_N = 8.0;
        const PlaybackMark byForce = marked(law);
        QVERIFY(byForce.critical && byForce.detail.empty());
        QVERIFY(!marked(law, false).critical); // a level without the metric, as in every study
        QCOMPARE(byForce.value, std::optional(2.0));
        law.torque_Nm = 0.213;
        const PlaybackMark byTorque = marked(law);
        QVERIFY(byTorque.critical);
        QCOMPARE(byTorque.detail, std::string(kByTorque));
        QCOMPARE(byTorque.value, std::optional(0.213));
        PlaybackTrack track = quietEnd();
        QVERIFY(!byTorque.p_W); // nobody said where the tools were
        const tests::MillimetreCounts positions{};
        MarkExtractor placed(4.0, 1, false, law, &positions);
        for (const core::HapticFrame& frame : frames)
            placed.add(frame, 1e-3 * static_cast<double>(frame.header.index));
        const PlaybackMark there = ofKind(placed.take(0.011), mark_kinds::kYielded).at(0);
        QVERIFY(there.p_W && (*there.p_W - core::Vec3(0.005, 0.0, 0.0)).norm() < 1e-12);
        track.marks = {byTorque};
        const std::vector<scoring::Gate> gates{{"critical_errors", {}, 0.0}};
        const auto worst = worstMoment(track, failed({{"critical_errors", 1.0}}), gates);
        QCOMPARE(worst->unit, std::string("mN·m"));
        QCOMPARE(worst->value, 213.0);
    }

    void eachCountedEventOfATaskHasItsMoment_data() {
        QTest::addColumn<QString>("exercise");
        QTest::addColumn<QString>("metric");
        QTest::addColumn<PlaybackMarkKind>("kind");
        QTest::newRow("over-stretches") << "elastic_tube"
                                        << "over_stretches" << mark_kinds::kDamaged;
        QTest::newRow("drops") << "elastic_tube"
                               << "drops" << mark_kinds::kSlipped;
        QTest::newRow("lumps missed") << "palpation"
                                      << "palpation_misses" << mark_kinds::kLumpMissed;
        QTest::newRow("false alarms") << "palpation"
                                      << "palpation_false_alarms" << mark_kinds::kFalseAlarm;
        QTest::newRow("torn") << "elastic_tube"
                              << "procedure_completed" << mark_kinds::kFailed;
    }
    void eachCountedEventOfATaskHasItsMoment() {
        QFETCH(QString, exercise);
        QFETCH(QString, metric);
        QFETCH(chiron::session::PlaybackMarkKind, kind);
        PlaybackTrack track = quietEnd();
        track.exercise = exercise.toStdString();
        track.marks = {markAt(3.5, kind)};
        const std::string id = metric.toStdString();
        const scoring::Gate gate{id, {}, 0.0};
        const auto worst = worstMoment(track, failed({{id.c_str(), 1.0}}), {&gate, 1});
        QVERIFY(worst && worst->gateFailed);
        QCOMPARE(worst->t_s, 3.5);
    }

    /// How far into its trial it was, however soon after its beginning.
    void theWorstMomentKnowsItsTrialsTime() {
        PlaybackTrack track = quietEnd();
        track.exercise = "elastic_tube";
        for (const double start_s : {0.0, 1.75, 2.0}) {
            track.trials[0].start_s = start_s;
            const auto worst = worstMoment(track, {}, {});
            QVERIFY(worst && worst->t_s == 2.0 && !worst->depth_m);
            QCOMPARE(worst->intoTrial_s, 2.0 - start_s);
        }
    }

    /// Of a packet that was refused nobody knows where the tool was; nor where nobody reads packets.
    void aRefusedPacketHasNoPlace() {
        const tests::MillimetreCounts positions{};
        core::ToolFrame frame = tests::someFrames(6)[5].tool[0];
        const auto place = yieldPlaceOf(&positions, 0, frame);
        QVERIFY(place && (*place - core::Vec3(0.005, 0.0, 0.0)).norm() < 1e-12);
        QVERIFY(!yieldPlaceOf(nullptr, 0, frame));
        frame.status |= core::sample_status::kRefused;
        QVERIFY(!yieldPlaceOf(&positions, 0, frame));
        QVERIFY(!yieldPlaceOf(nullptr, 0, frame));
    }

    /// A change of stage is called after the step that began with it, in the exercises that record steps.
    void theStepsOfATaskNameItsStages() {
        for (const char* id : {"elastic_tube", "object_handling"}) {
            PlaybackTrack track = quietEnd();
            PlaybackQuantity step{"step", "1", {}};
            for (std::size_t i = 0; i < track.moments.size(); ++i) {
                track.moments[i].tick = 10 * i;
                step.values.push_back(static_cast<double>(i < 500 ? core::LaparoscopyStep::grasp
                                                                  : core::LaparoscopyStep::hold));
            }
            track.marks = {markAt(4.995, mark_kinds::kStageChanged), markAt(6.0, mark_kinds::kGrasped)};
            track.marks[0].tick = 4995; // between two samples: the next one has the new step
            track.marks[1].tick = 6000;
            PlaybackTrack unrecorded = track;
            track.quantities.push_back(step);
            const ExerciseKind& kind = **exerciseKind(id);
            QVERIFY(kind.addMarks({}, nullptr, track) && kind.addMarks({}, nullptr, unrecorded));
            QCOMPARE(track.marks[0].detail, std::string("hold"));
            QVERIFY(track.marks[1].detail.empty() && unrecorded.marks[0].detail.empty());
        }
    }

    /// Only of the exercise whose metric counts it, and only where no tissue gave way.
    void aCriticalTraumaIsTheMomentOfAnInsertion() {
        PlaybackTrack track = quietEnd();
        track.marks = {markAt(2.5, mark_kinds::kTrauma, 9.0), markAt(3.5, mark_kinds::kTrauma, 5.0)};
        track.marks[1].critical = true; // the other one was harder, but slipped off at once
        const std::vector<scoring::Gate> gates{{"critical_errors", {}, 0.0}};
        const scoring::ScoreCard card = failed({{"critical_errors", 1.0}});
        track.exercise = "urethra_insertion";
        const auto worst = worstMoment(track, card, gates);
        QVERIFY(worst && worst->gateFailed);
        QCOMPARE(worst->t_s, 3.5);
        QCOMPARE(worst->unit, std::string("N"));
        track.exercise = "object_handling";
        const auto other = worstMoment(track, card, gates);
        QVERIFY(!other || other->t_s != 3.5);
        track.exercise = "urethra_insertion";
        track.marks.push_back(markAt(3.8, mark_kinds::kYielded, 8.0));
        QCOMPARE(worstMoment(track, card, gates)->t_s, 3.8);
    }

    void theLargestSqueezeIsInTheRunningTimeOfATrial() {
        PlaybackTrack track = quietEnd();
        track.exercise = "object_handling";
        PlaybackQuantity squeeze{"squeeze_N", "N", std::vector<double>(track.moments.size(), 0.5)};
        squeeze.values[700] = 2.5;
        squeeze.values[800] = 9.0;
        track.moments[800].paused = true;
        track.quantities.push_back(squeeze);
        const scoring::Gate gate{"squeeze_max", {}, 1.0};
        const auto worst = worstMoment(track, failed({{"squeeze_max", 2.5}}), {&gate, 1});
        QCOMPARE(worst->value, 2.5);
        QCOMPARE(worst->t_s, 7.0);
    }

    void findingsThatFoundNothingAndLumpsThatNobodyFoundAreEvents() {
        PlaybackTrack track = quietEnd();
        PalpationOutcome record{0, true, false, {}};
        record.answer.truth.lumps.resize(2);
        const auto report = [](double t_s, simulation::ReportField field, int finding) {
            scoring::TimedReport made;
            made.t_s = t_s;
            made.field = field;
            made.finding = finding;
            return made;
        };
        record.answer.reports = {
            report(1.0, simulation::ReportField::found, 0), report(2.0, simulation::ReportField::found, 1),
            report(3.0, simulation::ReportField::remove, 1), report(4.0, simulation::ReportField::found, 1)};
        scoring::FindingMatch hit;
        hit.finding = 0;
        hit.lump = 1;
        scoring::FindingMatch wrong;
        wrong.finding = 1;
        wrong.lump = -1;
        record.answer.matches = {hit, wrong};
        addPalpationMarks(track, {&record, 1});
        QVERIFY(std::is_sorted(track.marks.begin(), track.marks.end(),
                               [](const auto& a, const auto& b) { return a.t_s < b.t_s; }));
        QCOMPARE(ofKind(track.marks, mark_kinds::kFound).size(),
                 std::size_t(2)); // the first, and the one that was taken back
        const auto alarms = ofKind(track.marks, mark_kinds::kFalseAlarm);
        QCOMPARE(alarms.size(), std::size_t(1));
        QCOMPARE(alarms[0].t_s, 4.0);
        const auto missed = ofKind(track.marks, mark_kinds::kLumpMissed);
        QCOMPARE(missed.size(), std::size_t(1));
        QCOMPARE(missed[0].t_s, 10.0);
        // A search that was broken off missed nothing yet.
        record.completed = false;
        PlaybackTrack stopped = quietEnd();
        addPalpationMarks(stopped, {&record, 1});
        QVERIFY(ofKind(stopped.marks, mark_kinds::kLumpMissed).empty());
    }
};

QTEST_GUILESS_MAIN(TestLookingBack)
#include "test_looking_back.moc"
