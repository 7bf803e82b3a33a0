// SPDX-License-Identifier: GPL-3.0-or-later
// Jaws that close on nothing are told of, with the reason where somebody learns.
#include "app/exercises/elastic_tube/desktop/tube_grasping.h"
#include "app/exercises/object_handling/desktop/handling_grasping.h"
#include "catalogue/catalogue.h"
#include "desktop/training/grasp_note.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <QtTest>

using namespace chiron;
using desktop::GraspNote;

namespace {

constexpr double kOpen_rad = 1.5;
constexpr double kClosed_rad = 0.0;

haptics::DisplayState stateAt(double t_s, double jaw_rad, double x_m) {
    haptics::DisplayState state;
    state.now_ns = static_cast<std::int64_t>(1e9 * t_s);
    state.phase = core::TrialPhase::running;
    state.tools = 1;
    state.tool[0].jaw_rad = jaw_rad;
    state.tool[0].p_WT_m = {x_m, 0.0, 0.0};
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    cues.present = cues.objectShown = true;
    return state;
}
/// The free end lies in the origin; the other one is fixed, nearer to who comes from the right.
haptics::DisplayState atTube(double t_s, double jaw_rad, double away_m) {
    haptics::DisplayState state = stateAt(t_s, jaw_rad, away_m);
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    cues.tube = true;
    cues.grips = 2;
    cues.p_WGrip[0] = {away_m, 0.001, 0.0};
    cues.gripAnchored[0] = true;
    cues.p_WGrip[1] = {0.0, 0.0, 0.0};
    return state;
}

desktop::Grasping graspingOf(const catalogue::ExerciseLevel& level) {
    if (const auto* tube = level.parameters.find<simulation::ElasticTubeParameters>())
        return desktop::tubeGrasping(*tube, session::levelLimits(level));
    return desktop::handlingGrasping(level.parameters.as<simulation::ObjectHandlingParameters>(),
                                     session::levelLimits(level));
}

class Closing {
public:
    explicit Closing(const catalogue::ExerciseLevel& level, bool practises = false)
        : m_note(graspingOf(level), QLocale(QLocale::English), level.feedback || practises) {}
    QString after(std::initializer_list<haptics::DisplayState> states) {
        std::int64_t now_ns = 0;
        for (const haptics::DisplayState& state : states) {
            m_note.take(state);
            now_ns = state.now_ns;
        }
        return m_note.note(now_ns).title;
    }
    QString at(double t_s) const { return m_note.note(static_cast<std::int64_t>(1e9 * t_s)).title; }

private:
    GraspNote m_note;
};

} // namespace

class TestGraspNote : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        auto loaded = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY(loaded.has_value());
        m_catalogue.emplace(std::move(*loaded));
    }

    void besideTheTube() {
        Closing closing(level("elastic_tube", true));
        const QString said = closing.after({atTube(1.0, kOpen_rad, 0.012), atTube(1.1, kClosed_rad, 0.012)});
        QVERIFY2(said.contains(QStringLiteral("Nothing was grasped")) &&
                     said.contains(QStringLiteral("12 mm")),
                 qPrintable(said)); // from the free end
    }

    void besideAnObject() {
        const auto& of = level("object_handling", true);
        haptics::DisplayState open = stateAt(1.0, kOpen_rad, 0.031),
                              closed = stateAt(1.1, kClosed_rad, 0.031);
        for (haptics::DisplayState* state : {&open, &closed}) {
            state->exercise.own<core::LaparoscopyCues>().bodies = 1;
            state->exercise.own<core::LaparoscopyCues>().body[0].radius_m = 0.011;
        }
        const QString said = Closing(of).after({open, closed});
        QVERIFY2(said.contains(QStringLiteral("the object was 20 mm away")),
                 qPrintable(said)); // from its surface
    }

    void whoHoldsIsToldNothing() {
        Closing closing(level("elastic_tube", true));
        haptics::DisplayState held = atTube(1.1, kClosed_rad, 0.003);
        held.exercise.own<core::LaparoscopyCues>().gripHeldBy[1] = 1;
        QVERIFY(closing.after({atTube(1.0, kOpen_rad, 0.003), held}).isEmpty());
        haptics::DisplayState slipped =
            atTube(1.2, kClosed_rad, 0.020); // out of closed jaws: that is told of elsewhere
        QVERIFY(closing.after({slipped}).isEmpty());
    }

    /// Half-closed jaws are on their way, and jaws that were never open have missed nothing.
    void onlyWhatClosesIsMissed() {
        Closing closing(level("elastic_tube", true));
        QVERIFY(closing.after({atTube(1.0, kClosed_rad, 0.020), atTube(1.1, kClosed_rad, 0.020)}).isEmpty());
        QVERIFY(closing.after({atTube(1.2, kOpen_rad, 0.020), atTube(1.3, 0.28, 0.020)}).isEmpty());
        QVERIFY(!closing.after({atTube(1.4, 0.19, 0.020)}).isEmpty());
    }

    void closedJawsAtTheTubeHaveToOpen() {
        Closing closing(level("elastic_tube", true));
        QVERIFY(closing.after({atTube(1.0, kClosed_rad, 0.002), atTube(1.3, kClosed_rad, 0.002)})
                    .isEmpty()); // on the way elsewhere, perhaps
        const QString said = closing.after({atTube(2.0, kClosed_rad, 0.002)});
        QVERIFY2(said.contains(QStringLiteral("jaws are closed")), qPrintable(said));
        // To the tick: after its patience, from the first moment on, and as long as something is said.
        const haptics::DisplayState begins = atTube(0.0, kClosed_rad, 0.002);
        haptics::DisplayState waits = begins;
        waits.now_ns = GraspNote::kPatience_ns - 1;
        QVERIFY(Closing(level("elastic_tube", true)).after({begins, waits}).isEmpty());
        waits.now_ns = GraspNote::kPatience_ns;
        QVERIFY(!Closing(level("elastic_tube", true)).after({begins, waits}).isEmpty());
        haptics::DisplayState away = atTube(0.0, kClosed_rad, 0.020); // who left it comes to it anew
        away.now_ns = GraspNote::kPatience_ns / 2;
        QVERIFY(Closing(level("elastic_tube", true)).after({begins, away, waits}).isEmpty());
        Closing last(level("elastic_tube", true));
        (void)last.after({atTube(1.0, kOpen_rad, 0.012), atTube(2.0, kClosed_rad, 0.012)});
        QVERIFY(!last.at(2.0 + 1e-9 * GraspNote::kSaid_ns).isEmpty());
        QVERIFY(last.at(2.001 + 1e-9 * GraspNote::kSaid_ns).isEmpty());
    }

    void whatTheFoldCoversCannotBeGrasped() {
        for (const catalogue::ExerciseLevel& each : m_catalogue->find("elastic_tube")->levels) {
            if (!each.parameters.as<simulation::ElasticTubeParameters>().hasFold())
                continue;
            haptics::DisplayState open = atTube(1.0, kOpen_rad, 0.002),
                                  closed = atTube(1.1, kClosed_rad, 0.002);
            open.exercise.own<core::LaparoscopyCues>().fold =
                closed.exercise.own<core::LaparoscopyCues>().fold = true;
            QVERIFY(Closing(each, true).after({open, closed}).contains(QStringLiteral("fold")));
            return;
        }
        QFAIL("no level with a fold");
    }

    /// An assessment tells no more than the eyes see; a practice of it tells all.
    void onlyWhereSomebodyLearnsTheReasonIsTold() {
        const auto& assessed = level("elastic_tube", false);
        const auto missed = {atTube(1.0, kOpen_rad, 0.012), atTube(1.1, kClosed_rad, 0.012)};
        QCOMPARE(Closing(assessed).after(missed), QStringLiteral("Nothing was grasped"));
        QVERIFY(Closing(assessed, true).after(missed).contains(QStringLiteral("12 mm")));
        QVERIFY(Closing(assessed)
                    .after({atTube(1.0, kClosed_rad, 0.002), atTube(4.0, kClosed_rad, 0.002)})
                    .isEmpty());
        haptics::DisplayState blind = atTube(1.1, kClosed_rad, 0.012); // nothing is told of what is hidden
        blind.exercise.own<core::LaparoscopyCues>().objectShown = false;
        QVERIFY(Closing(assessed, true).after({atTube(1.0, kOpen_rad, 0.012), blind}).isEmpty());
    }

    /// Not with every movement: the words stay for their time, and then there is quiet.
    void itIsNotSaidAllTheTime() {
        Closing closing(level("elastic_tube", true));
        QVERIFY(closing.after({atTube(1.0, kOpen_rad, 0.012), atTube(1.1, kClosed_rad, 0.012)})
                    .contains(QStringLiteral("12 mm")));
        QVERIFY(closing.after({atTube(1.5, kOpen_rad, 0.030), atTube(1.6, kClosed_rad, 0.030)})
                    .contains(QStringLiteral("12 mm")));
        QVERIFY(closing.at(1.1 + 1e-9 * GraspNote::kSaid_ns + 0.01).isEmpty());
        QVERIFY(closing.after({atTube(5.0, kOpen_rad, 0.030), atTube(5.1, kClosed_rad, 0.030)}).isEmpty());
        QVERIFY(closing.after({atTube(8.0, kOpen_rad, 0.030), atTube(8.1, kClosed_rad, 0.030)})
                    .contains(QStringLiteral("30 mm")));
        haptics::DisplayState between = atTube(8.2, kClosed_rad, 0.030);
        between.phase = core::TrialPhase::between;
        QVERIFY(closing.after({between}).isEmpty());
    }

private:
    /// One without a fold whose one instrument takes hold of what lies there.
    const catalogue::ExerciseLevel& level(const char* exercise, bool feedback) {
        for (const catalogue::ExerciseLevel& each : m_catalogue->find(exercise)->levels) {
            const auto* tube = each.parameters.find<simulation::ElasticTubeParameters>();
            if (each.feedback == feedback && !(tube && tube->hasFold()))
                return each;
        }
        qFatal("no such level");
    }

    std::optional<catalogue::Catalogue> m_catalogue;
};

QTEST_MAIN(TestGraspNote)
#include "test_grasp_note.moc"
