// SPDX-License-Identifier: GPL-3.0-or-later
// Advice on a missed pass mark says what the recording shows: how much, and where. For each exercise on a
// made recording.
#include "app/exercises/palpation/session/palpation_marks.h"
#include "app/exercises/sphere_apex/session/apex_marks.h"
#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "catalogue/catalogue.h"
#include "core/languages.h"
#include "desktop/debrief/advice_words.h"
#include "desktop/debrief/practice_level.h"
#include "gui/review/made_insertion.h"
#include "session/worst_moment.h"

#include <QLocale>
#include <QtTest>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

using namespace chiron;
namespace mark_kinds = session::mark_kinds;

namespace {

constexpr double kTrial_s = 10.0;

const catalogue::Catalogue& shipped() {
    static const auto loaded = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!loaded)
        qFatal("%s", loaded.error().message.c_str());
    return *loaded;
}

/// Two trials of ten seconds, 100 samples a second, the tool at rest and without force.
session::PlaybackTrack twoTrials(const char* exercise) {
    session::PlaybackTrack track;
    track.exercise = exercise;
    track.toolCount = 1;
    for (int i = 0; i < 2000; ++i) {
        session::PlaybackMoment moment;
        moment.t_s = 0.01 * i;
        moment.trial = static_cast<std::uint16_t>(i / 1000);
        moment.phase = core::TrialPhase::running;
        track.moments.push_back(moment);
        track.tools.emplace_back();
    }
    for (int i = 0; i < 2; ++i) {
        session::PlaybackTrial trial;
        trial.index = i;
        trial.start_s = kTrial_s * i;
        trial.end_s = kTrial_s * (i + 1);
        track.trials.push_back(trial);
    }
    track.duration_s = 2.0 * kTrial_s;
    return track;
}

session::PlaybackMark markAt(double t_s, int trial, const session::PlaybackMarkKind& kind,
                             std::optional<double> value = {}) {
    session::PlaybackMark mark;
    mark.t_s = mark.end_s = t_s;
    mark.trial = trial;
    mark.kind = kind;
    mark.value = value;
    return mark;
}

/// A session that missed the pass mark of a metric, with the metric's value in each trial.
scoring::ScoreCard missed(const std::string& metric, const char* unit, std::vector<double> ofTrials = {}) {
    scoring::ScoreCard card;
    card.metrics.push_back({metric, 1, unit, 2.0, "", false});
    for (const double value : ofTrials)
        card.trials.push_back({{metric, 1, unit, value, "", {}}});
    return card;
}

/// What a debrief says first of a missed pass mark; with ordinary spaces.
QString told(const session::PlaybackTrack& track, const std::string& metric, const scoring::ScoreCard& card,
             bool several = true, const std::string& language = "en") {
    scoring::Gate gate;
    gate.metric = metric;
    gate.maximum = 0.0;
    const auto moments = session::momentsOfFailedGates(track, card, {&gate, 1});
    if (moments.size() != 1 || moments.front().reason != metric)
        return QStringLiteral("no moment");
    const auto& advice = shipped().find(track.exercise)->advice;
    const auto found = std::find_if(advice.begin(), advice.end(),
                                    [&](const catalogue::Advice& one) { return one.metric == metric; });
    const QString text = found == advice.end()
                             ? QString()
                             : QString::fromStdString(catalogue::textIn(found->moment, language));
    const QLocale locale = language == "de" ? QLocale(QLocale::German) : QLocale(QLocale::English);
    return desktop::momentSentence(text, moments.front(), track.exercise, several, locale)
        .replace(QChar(0x00a0), QLatin1Char(' '));
}

} // namespace

class TestAdvice : public QObject {
    Q_OBJECT
private slots:
    void apex() {
        session::PlaybackTrack track = twoTrials("sphere_apex");
        for (session::PlaybackTrial& trial : track.trials) {
            trial.object.emplace();
            trial.object->radius_m = 0.02;
        }
        track.trials[1].p_WEnd = core::Vec3(0.0074, 0.0, 0.02);
        QCOMPARE(told(track, "apex_error_mean", missed("apex_error_mean", "% of R")),
                 QStringLiteral("You were farthest from the highest point in trial 2, 0:10.0 after it began: "
                                "37.0 % of the radius."));
        track.marks = {markAt(19.0, 1, mark_kinds::kMissed), markAt(9.5, 0, mark_kinds::kTimedOut)};
        QCOMPARE(told(track, "apex_misses", missed("apex_misses", "count")),
                 QStringLiteral("Your first miss was in trial 1, 0:09.5 after it began."));
        track.marks = {markAt(13.0, 1, mark_kinds::kYielded, 6.0)};
        QCOMPARE(told(track, "critical_errors", missed("critical_errors", "count")),
                 QStringLiteral("The tissue gave way at 6.00 N, in trial 2, 0:03.0 after it began."));
        track.tools[1250].tissue_N = core::Vec3(0.0, 0.0, 3.2);
        QCOMPARE(told(track, "force_time_over_limit", missed("force_time_over_limit", "s")),
                 QStringLiteral("You pressed hardest in trial 2, 0:02.5 after it began: 3.20 N."));
    }

    void palpation() {
        session::PlaybackTrack track = twoTrials("palpation");
        track.marks = {markAt(12.0, 1, mark_kinds::kFalseAlarm, 1.0),
                       markAt(20.0, 1, mark_kinds::kLumpMissed)};
        QCOMPARE(told(track, "palpation_misses", missed("palpation_misses", "count")),
                 QStringLiteral("The first lump that you missed was in trial 2."));
        QCOMPARE(told(track, "palpation_false_alarms", missed("palpation_false_alarms", "count")),
                 QStringLiteral("You first marked a spot without a lump in trial 2, 0:02.0 after it began."));
        scoring::ScoreCard searched = missed("localisation_error", "mm", {3.0, 7.5});
        QCOMPARE(told(track, "localisation_error", searched),
                 QStringLiteral("Your mark was farthest from the lump in trial 2: 7.50 mm."));
    }

    void tube() {
        session::PlaybackTrack track = twoTrials("elastic_tube");
        track.quantities.push_back({"retraction_N", "N", std::vector<double>(track.moments.size(), 0.5)});
        track.quantities.front().values[700] = 2.5;
        QCOMPARE(told(track, "retraction_max", missed("retraction_max", "N")),
                 QStringLiteral("You pulled hardest on the fold in trial 1, 0:07.0 after it began: 2.50 N."));
        track.marks = {markAt(14.0, 1, mark_kinds::kSlipped), markAt(15.0, 1, mark_kinds::kFailed)};
        QCOMPARE(told(track, "drops", missed("drops", "count")),
                 QStringLiteral("You first lost your hold in trial 2, 0:04.0 after it began."));
        QCOMPARE(told(track, "procedure_completed", missed("procedure_completed", "%")), // where it tore
                 QStringLiteral("You did not finish, for example in trial 2, 0:05.0 after it began."));
        QCOMPARE(
            told(track, "tension_error_rms", missed("tension_error_rms", "N", {0.31, 0.2})),
            QStringLiteral("The pull was farthest from its target in trial 1: 0.310 N (root mean square)."));
        track.marks.clear(); // counted, but not marked: the trial with the most of them
        QCOMPARE(told(track, "drops", missed("drops", "count", {1.0, 3.0})),
                 QStringLiteral("It was worst in trial 2: 3."));
    }

    void object() {
        session::PlaybackTrack track = twoTrials("object_handling");
        track.quantities.push_back({"squeeze_N", "N", std::vector<double>(track.moments.size(), 0.5)});
        track.quantities.front().values[1300] = 2.5;
        QCOMPARE(told(track, "squeeze_max", missed("squeeze_max", "N")),
                 QStringLiteral("You squeezed hardest in trial 2, 0:03.0 after it began: 2.50 N."));
        QCOMPARE(told(track, "placement_error", missed("placement_error", "mm", {12.0, 4.0})),
                 QStringLiteral("The ovary lay farthest from the middle of the ring in trial 1: 12.0 mm."));
    }

    /// One trial, which no sentence numbers; the place is the depth in the canal.
    void urethra() {
        session::PlaybackTrack track = tests::madeTrack();
        for (session::PlaybackMoment& moment : track.moments)
            moment.phase = core::TrialPhase::running;
        session::PlaybackPeak peak;
        peak.metrics = {"curve_alignment"};
        peak.t_s = track.moments[875].t_s; // 3.5 s
        peak.value = 27.0;
        peak.unit = "°";
        track.peaks.push_back(peak);
        QCOMPARE(told(track, "curve_alignment", missed("curve_alignment", "°"), false),
                 QStringLiteral("In the bend, the endoscope was farthest out of line with the canal at a "
                                "depth of 30.0 mm, 0:01.5 after the start: 27.0 °."));
        track.marks = {markAt(track.moments[1000].t_s, 0, mark_kinds::kTrauma, 1.8)}; // 4 s
        QCOMPARE(
            told(track, "trauma_events", missed("trauma_events", "count"), false),
            QStringLiteral("You pressed hardest against the wall at a depth of 40.0 mm, 0:02.0 after the "
                           "start: 1.80 N."));
        const QString deepest = told(track, "insertion_depth", missed("insertion_depth", "mm"), false);
        QVERIFY2(deepest.startsWith(QStringLiteral("You stopped advancing at a depth of 60.0 mm, 0:03.0")),
                 qPrintable(deepest));
        // The time of the only trial is the session's: the missed pass mark itself says it.
        QCOMPARE(told(track, "time", missed("time", "s", {90.0}), false), QString());
    }

    void everySentenceIsFilledInInEveryLanguage() {
        session::PlaybackMark event = markAt(3.0, 0, mark_kinds::kYielded, 6.0);
        session::WorstMoment moment;
        moment.t_s = moment.intoTrial_s = 3.0;
        moment.value = 37.0;
        moment.unit = "N";
        moment.event = event;
        for (const catalogue::Exercise& exercise : shipped().exercises()) {
            int sentences = 0;
            for (const catalogue::Advice& advice : exercise.advice)
                for (const std::string& language : core::languageIds()) {
                    if (advice.moment.empty())
                        continue;
                    ++sentences;
                    QVERIFY2(advice.moment.count(language) == 1, advice.metric.c_str());
                    const QString text = QString::fromStdString(advice.moment.at(language));
                    const QString told =
                        desktop::momentSentence(text, moment, exercise.id, true, QLocale(QLocale::German));
                    QVERIFY2(!told.contains(QLatin1Char('{')) && told.endsWith(QLatin1Char('.')),
                             qPrintable(told));
                    QCOMPARE(told.contains(QStringLiteral("37,0")), text.contains(QStringLiteral("{value}")));
                }
            QVERIFY2(sentences > 0, exercise.id.c_str());
        }
    }

    void aMetricIsPractisedWhereALowerLevelJudgesIt() {
        const auto numberOf = [](const char* exercise, int level, const char* metric) {
            const auto* found = desktop::practiceLevel(*shipped().find(exercise), level, metric);
            return found ? found->number : 0;
        };
        QCOMPARE(numberOf("sphere_apex", 1, "apex_error_mean"), 0);
        QCOMPARE(numberOf("sphere_apex", 2, "apex_error_mean"), 1);
        QCOMPARE(numberOf("sphere_apex", 6, "apex_error_mean"), 3); // the highest that gives feedback
        QCOMPARE(numberOf("palpation", 5, "coverage"), 2);
        QCOMPARE(numberOf("palpation", 2, "coverage"), 0); // the visible lump asks for no search
        QCOMPARE(numberOf("urethra_insertion", 5, "landmarks_seen"), 4); // no feedback anywhere: the highest
        QCOMPARE(numberOf("elastic_tube", 6, "retraction_max"), 0);
    }
};

QTEST_MAIN(TestAdvice)
#include "test_advice.moc"
