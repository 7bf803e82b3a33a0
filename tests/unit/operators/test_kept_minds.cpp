// SPDX-License-Identifier: GPL-3.0-or-later
// What every scripted operator does in small worlds that are made up here (a ball on a table, a canal, a
// tube, objects, tissue), with slips, blows, blind moments and pauses in between, against what was kept.
// Sessions of whole levels (replay/test_operators_are_kept) show that levels and operators go together as
// they did; these, that no habit changes that those seldom come by.
#include "support/kept_figures.h"

#include "core/random.h"
#include "core/tool_state.h"
#include "core/units.h"
#include "cues/laparoscopy_cues.h"
#include "modules/exercises/elastic_tube/operators/elastic_tube_operator.h"
#include "modules/exercises/object_handling/operators/object_handling_operator.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/operators/palpation_operator.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "modules/exercises/urethra_insertion/cues/procedure_stage.h"
#include "modules/exercises/urethra_insertion/operators/urethra_insertion_operator.h"
#include "simulation/palpation/tissue_surface.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

using namespace chiron;
using namespace chiron::operators;
using core::Vec3;
using tests::Figures;

namespace {

constexpr double kTick_s = core::kTickSeconds;

/// A hand and its instrument come after what is wanted, and yield to force.
struct Hand {
    Vec3 p = Vec3::Zero(), v = Vec3::Zero(), force = Vec3::Zero();
    core::Quat q = core::Quat::Identity();
    double jaw_rad = 0.8;
    double pressed = 0.0; ///< of all buttons so far: which, and how long
    mechanisms::HandIntention wanted;

    void follow(const mechanisms::HandIntention& intention) {
        wanted = intention;
        v += 0.08 * ((intention.p_DDesired + force / 1500.0 - p) * 40.0 + intention.v_DDesired - v);
        p += v * kTick_s;
        q = q.slerp(0.05, intention.q_DDesired);
        jaw_rad += 0.05 * (intention.jaw_rad - jaw_rad);
        pressed += 1e-3 * intention.buttons;
    }
    mechanisms::HandPerception seen(double time_s, const core::VisibleCues& cues) const {
        mechanisms::HandPerception real;
        real.time_s = time_s;
        real.p_DT = p;
        real.v_DT = v;
        real.q_DT = q;
        real.f_T_D = force;
        real.cues = cues;
        return real;
    }
};

/// Once a second, where each hand wants to be and what it has pressed until then.
void note(Figures& out, const char* name, int tick, const std::vector<Hand>& hands) {
    if (tick % 1000 != 0)
        return;
    for (const Hand& hand : hands)
        out.add(QStringLiteral("%1 %2").arg(QLatin1String(name)).arg(tick), 1e3 * hand.wanted.p_DDesired.x(),
                1e3 * hand.wanted.p_DDesired.y(), 1e3 * hand.wanted.p_DDesired.z(),
                1e3 * hand.wanted.v_DDesired.norm(), hand.wanted.q_DDesired.x(), hand.wanted.q_DDesired.z(),
                hand.wanted.jaw_rad, hand.pressed);
}

/// Trials of some seconds with pauses between, and force that goes off once in the second trial.
struct Programme {
    double trial_s = 30.0, pause_s = 2.0;
    int trials = 3;
    int trialAt(double time_s) const { return static_cast<int>(time_s / (trial_s + pause_s)); }
    bool over(double time_s) const { return trialAt(time_s) >= trials; }
    void tell(double time_s, core::VisibleCues& cues) const {
        const int trial = trialAt(time_s);
        const double into_s = time_s - trial * (trial_s + pause_s) - pause_s;
        cues.trial = static_cast<std::uint16_t>(trial);
        cues.phase = into_s < 0.0 ? core::TrialPhase::between : core::TrialPhase::running;
        cues.force =
            trial == 1 && into_s > 6.0 && into_s < 6.8 ? core::ForceState::paused : core::ForceState::on;
        cues.timeLeft_s = into_s < 0.0 ? 0.0 : trial_s - into_s;
    }
};

/// Below the range of everything that an operator may be told.
constexpr double kFar = -1000.0;

template <class Told, class Number> std::function<void(Told&)> spoilt(Number Told::*setting) {
    return [setting](Told& told) { told.*setting = static_cast<Number>(kFar); };
}

/// What is said of each setting alone that is far from its range: the words name it and both ends of its
/// range.
template <class Told, class Make>
void refuseEach(Figures& out, const char* name, const Told& usual,
                const std::type_identity_t<std::vector<std::function<void(Told&)>>>& spoil, Make make) {
    for (const auto& one : spoil) {
        Told told = usual;
        one(told);
        const auto made = make(told);
        out.say(QString::fromLatin1(name), made ? std::string("made") : made.error().message);
    }
}

} // namespace

class TestKeptMinds : public QObject {
    Q_OBJECT
private slots:
    void apex_data() { everybody(sphereApexOperatorNames()); }
    void apex();
    void canal_data() { everybody(urethraInsertionOperatorNames()); }
    void canal();
    void tube_data() { everybody(elasticTubeOperatorNames()); }
    void tube();
    void objects_data() { everybody(objectHandlingOperatorNames()); }
    void objects();
    void tissue_data() { everybody(palpationOperatorNames()); }
    void tissue();
    void settingsOutOfTheirRange();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    static void everybody(std::span<const std::string_view> names) {
        QTest::addColumn<QString>("who");
        for (const std::string_view name : names) {
            const QString who = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
            QTest::newRow(qPrintable(who)) << who;
        }
    }
    void hold(const char* world, const Figures& figures) {
        const QString differs = m_kept.differs(
            QStringLiteral("%1, %2").arg(QLatin1String(world), QLatin1String(QTest::currentDataTag())),
            figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/operators/kept_minds.txt"),
                           tests::sameFigures};
};

/// A half ball of 20 mm on a table: felt; then seen; then nothing there but the table; at last not even that.
void TestKeptMinds::apex() {
    QFETCH(QString, who);
    Figures out;
    auto mind = makeSphereApexOperator(who.toStdString(), 5);
    QVERIFY(mind);
    const Programme programme{.trial_s = 34.0, .trials = 4};
    std::vector<Hand> hands(1);
    hands[0].p = Vec3(0.002, -0.001, 0.05);
    core::VisibleCues cues;
    for (int tick = 0; !programme.over(tick * kTick_s); ++tick) {
        const double time_s = tick * kTick_s;
        programme.tell(time_s, cues);
        Hand& hand = hands[0];
        const Vec3 centre(0.014, -0.009, 0.0), from = hand.p - centre;
        cues.objectShown = cues.trial == 1;
        mechanisms::HandPerception seen = hand.seen(time_s, cues);
        seen.p_DObject = cues.objectShown ? centre : Vec3::Zero();
        hand.follow((*mind)->decide(seen));
        hand.force = Vec3::Zero();
        if (const double in_m = 0.02 - from.norm(); cues.trial < 2 && in_m > 0.0)
            hand.force = 500.0 * in_m * from.normalized() - 0.2 * Vec3(hand.v.x(), hand.v.y(), 0.0);
        else if (cues.trial < 3 && hand.p.z() < 0.0)
            hand.force = Vec3(0.0, 0.0, -900.0 * hand.p.z());
        if (tick % 9000 > 8930) // a blow
            hand.force += Vec3(1.5, 0.5, -0.5);
        note(out, "apex", tick, hands);
    }
    hold("apex", out);
}

/// Along y, bending upwards from 40 mm on; wall alone is seen now and then, and something holds it up.
void TestKeptMinds::canal() {
    QFETCH(QString, who);
    Figures out;
    auto mind = makeUrethraInsertionOperator(who.toStdString(), 6);
    QVERIFY(mind);
    const Programme programme{.trial_s = 55.0, .trials = 2};
    std::vector<Hand> hands(1);
    Hand& hand = hands[0];
    core::Random random(8);
    core::VisibleCues cues;
    simulation::EndoscopeCues& scope = cues.exercise.own<simulation::EndoscopeCues>();
    scope.present = true;
    scope.landmarks = 2;
    double dwell_s = 0.0, held_s = 0.0;
    for (int tick = 0; !programme.over(tick * kTick_s); ++tick) {
        const double time_s = tick * kTick_s;
        programme.tell(time_s, cues);
        const double depth_m = hand.p.y() - 0.01;
        const double into_s = std::fmod(time_s, 57.0) - 2.0;
        if (into_s < 0.0) {
            scope.stage = simulation::ProcedureStage::outside;
            scope.landmarksSeen = 0;
            dwell_s = held_s = 0.0;
            hand.p = Vec3(0.0, 0.004, 0.0);
            hand.v.setZero();
        } else if (scope.stage == simulation::ProcedureStage::outside && depth_m > 0.0) {
            scope.stage = simulation::ProcedureStage::insertion;
        } else if (scope.stage == simulation::ProcedureStage::insertion &&
                   (depth_m > 0.06 || into_s > 24.0)) {
            scope.stage = simulation::ProcedureStage::inspection;
        } else if (scope.stage == simulation::ProcedureStage::inspection &&
                   (scope.landmarksSeen == 3 || into_s > 42.0)) {
            scope.stage = simulation::ProcedureStage::withdrawal;
        } else if (scope.stage == simulation::ProcedureStage::withdrawal && depth_m < 0.0) {
            scope.stage = simulation::ProcedureStage::completed;
        }
        scope.pictureShown = cues.trial == 0 || std::fmod(into_s, 7.0) > 0.5;
        scope.guided = cues.trial == 0;
        scope.depth_m = depth_m;
        const Vec3 view = hand.q * -Vec3::UnitZ();
        const double bend = depth_m > 0.03 ? 9.0 * (depth_m - 0.03) : 0.0;
        const Vec3 ahead_D =
            Vec3(0.1 * std::sin(40.0 * depth_m), std::cos(bend), std::sin(bend)).normalized();
        const Vec3 lumen_T = hand.q.conjugate() * ahead_D;
        const bool blind = std::fmod(into_s, 11.0) > 10.2;
        scope.toLumen_T =
            blind ? std::array<double, 3>{} : std::array<double, 3>{lumen_T.x(), lumen_T.y(), lumen_T.z()};
        scope.lumenDistance_m = 0.02 + 0.01 * std::sin(time_s);
        scope.landmarkShown = false;
        scope.toLandmark_T = {};
        if (scope.stage == simulation::ProcedureStage::inspection) {
            const Vec3 at_D = scope.landmarksSeen == 0 ? Vec3(0.01, 0.04, 0.015) : Vec3(-0.018, 0.035, -0.01);
            const Vec3 at_T = hand.q.conjugate() * at_D;
            const double off_rad = std::acos(std::clamp(view.dot(at_D.normalized()), -1.0, 1.0));
            scope.landmarkShown = off_rad < 0.5 && !blind;
            if (scope.landmarkShown)
                scope.toLandmark_T = {at_T.x(), at_T.y(), at_T.z()};
            dwell_s = scope.landmarkShown && off_rad < 0.22 ? dwell_s + kTick_s : 0.0;
            if (dwell_s > 1.0) {
                scope.landmarksSeen |= scope.landmarksSeen == 0 ? 1U : 2U;
                dwell_s = 0.0;
            }
        }
        scope.dwell = std::min(1.0, dwell_s);
        mechanisms::HandPerception seen = hand.seen(time_s, cues);
        seen.t_T_D = Vec3(0.012 * std::sin(2.0 * time_s), 0.0, 0.01 * std::cos(1.3 * time_s));
        const Vec3 before = hand.p;
        hand.follow((*mind)->decide(seen));
        held_s = std::fmod(into_s, 17.0) > 11.0 && scope.stage == simulation::ProcedureStage::insertion
                     ? held_s + kTick_s
                     : 0.0;
        if (held_s > 0.0) // stuck
            hand.p.y() = std::min(hand.p.y(), before.y());
        hand.force = Vec3(0.1 * random.normal(), held_s > 0.0 ? -2.2 : -0.4,
                          0.6 * std::sin(0.7 * time_s) + (std::fmod(into_s, 13.0) > 12.0 ? 1.6 : 0.0));
        note(out, "canal", tick, hands);
    }
    hold("canal", out);
}

/// A tube of 60 mm: to be kept at a tension with one hand or two, with its bar shown or not, stretched to a
/// mark, handed over, and under a fold.
void TestKeptMinds::tube() {
    QFETCH(QString, who);
    Figures out;
    struct Task {
        const char* name;
        TubeGoal goal;
        int hands; ///< at the tube
        bool retracts, barShown, targetShown;
    };
    for (const Task& task : {Task{"one hand", TubeGoal::tension, 1, false, true, false},
                             Task{"by feel", TubeGoal::tension, 1, false, false, false},
                             Task{"two hands", TubeGoal::tension, 2, false, true, false},
                             Task{"to a mark", TubeGoal::mark, 1, false, true, true},
                             Task{"to a mark unseen", TubeGoal::mark, 1, false, false, false},
                             Task{"handed over", TubeGoal::bring, 2, false, true, true},
                             Task{"under a fold", TubeGoal::tension, 1, true, true, false}}) {
        ElasticTubeBriefing briefing;
        briefing.goal = task.goal;
        briefing.markRatio = 1.25;
        briefing.retracts = task.retracts;
        briefing.places.assign(static_cast<std::size_t>(task.hands + (task.retracts ? 1 : 0)), {});
        for (std::size_t i = 0; i < briefing.places.size(); ++i)
            briefing.places[i].origin_m = {0.03 - 0.06 * static_cast<double>(i), 0.0, 0.0};
        auto minds = makeElasticTubeOperator(*elasticTubeOperatorSettings(who.toStdString()), briefing, 9);
        QVERIFY2(minds, minds ? "" : minds.error().message.c_str());
        std::vector<Hand> hands(minds->size());
        for (std::size_t i = 0; i < hands.size(); ++i)
            hands[i].p = Vec3(0.01, 0.015 * static_cast<double>(i) - 0.01, 0.06);
        const auto inW = [&](std::size_t i) {
            return Vec3(hands[i].p + Vec3(briefing.places[i].origin_m[0], 0.0, 0.0));
        };
        const Programme programme{.trial_s = 14.0, .trials = 2};
        core::VisibleCues cues;
        core::LaparoscopyCues& screen = cues.exercise.own<core::LaparoscopyCues>();
        screen.present = screen.objectShown = screen.tube = true;
        screen.restLength_m = 0.06;
        std::array<Vec3, 3> grips{Vec3(-0.03, 0.0, 0.005), Vec3(0.0, 0.0, 0.01), Vec3(0.03, 0.0, 0.008)};
        const bool anchored = task.hands == 1 || task.goal == TubeGoal::bring;
        screen.grips = task.goal == TubeGoal::bring ? 3 : 2;
        Vec3 edge(0.0, 0.02, 0.012);
        double dwell_s = 0.0;
        for (int tick = 0; !programme.over(tick * kTick_s); ++tick) {
            const double time_s = tick * kTick_s;
            programme.tell(time_s, cues);
            const bool slips = tick % 6100 > 6040;
            std::array<int, 3> order{0, 2, 1}; // grips shown: base, free end, between
            for (int g = 0; g < screen.grips; ++g) {
                const auto at = static_cast<std::size_t>(order[static_cast<std::size_t>(g)]),
                           place = static_cast<std::size_t>(g);
                screen.gripAt[place] = 0.5 * static_cast<double>(at);
                screen.gripAnchored[place] = at == 0 && anchored;
                std::uint8_t held = 0;
                for (std::size_t i = 0; i < static_cast<std::size_t>(task.hands); ++i) {
                    const bool near = (inW(i) - grips[at]).norm() <
                                      ((screen.gripHeldBy[place] >> i & 1U) != 0 ? 0.03 : 0.006);
                    if (near && hands[i].jaw_rad < 0.3 && !slips && !screen.gripAnchored[place] &&
                        cues.phase == core::TrialPhase::running) {
                        held = static_cast<std::uint8_t>(held | (1U << i));
                        grips[at] = inW(i);
                    }
                }
                screen.gripHeldBy[place] = held;
                if (held == 0 && cues.phase != core::TrialPhase::running)
                    grips[at] +=
                        0.01 * (Vec3(-0.03 + 0.03 * static_cast<double>(at), 0.0, 0.008) - grips[at]);
                screen.p_WGrip[place] = {grips[at].x(), grips[at].y(), grips[at].z()};
            }
            const Vec3 span = grips[2] - grips[0];
            screen.stretch_m = std::max(0.0, span.norm() - screen.restLength_m);
            const double tension_N = 55.0 * screen.stretch_m + 400.0 * screen.stretch_m * screen.stretch_m;
            screen.tensionShown = task.barShown;
            screen.tension_N = task.barShown ? tension_N : 0.0;
            screen.bandLow_N = task.goal == TubeGoal::tension && task.barShown ? 0.8 : 0.0;
            screen.bandHigh_N = task.goal == TubeGoal::tension && task.barShown ? 1.1 : 0.0;
            const bool right = task.goal == TubeGoal::mark ? std::abs(screen.stretch_m - 0.015) < 0.0024
                                                           : tension_N > 0.8 && tension_N < 1.1;
            dwell_s = right ? std::min(3.0, dwell_s + kTick_s) : 0.0;
            screen.dwell = dwell_s / 3.0;
            screen.targetShown = task.targetShown;
            screen.p_WTarget = task.goal == TubeGoal::mark ? std::array<double, 3>{-0.03, 0.0, 0.08}
                                                           : std::array<double, 3>{-0.01, 0.03, 0.03};
            screen.targetRadius_m = 0.0024;
            screen.step =
                task.goal == TubeGoal::bring && std::fmod(time_s, 16.0) > 8.0 && screen.gripHeldBy[2] == 0
                    ? core::LaparoscopyStep::handOver
                    : core::LaparoscopyStep::carry;
            if (task.retracts) {
                const auto last = hands.size() - 1;
                const bool held = hands[last].jaw_rad < 0.3 &&
                                  (inW(last) - edge).norm() < (screen.foldHeldBy != 0 ? 0.05 : 0.006);
                screen.fold = true;
                screen.foldHeldBy = held ? static_cast<std::uint8_t>(1U << last) : std::uint8_t{0};
                edge = held ? inW(last) : Vec3(0.0, 0.02, 0.012);
                const Vec3 base(0.0, 0.045, 0.0);
                screen.p_WFoldEdge = {edge.x(), edge.y(), edge.z()};
                screen.p_WFoldBase = {base.x(), base.y(), base.z()};
                screen.retractionShown = true;
                screen.retraction_N = held ? 30.0 * std::max(0.0, (edge - base).norm() - 0.02) : 0.0;
                screen.retractionLow_N = 0.3;
                screen.retractionHigh_N = 0.7;
                screen.foldOpen = screen.retraction_N > 0.3;
                hands[last].force =
                    held ? Vec3(-screen.retraction_N * (edge - base).normalized()) : Vec3::Zero().eval();
            }
            for (std::size_t i = 0; i < static_cast<std::size_t>(task.hands); ++i) {
                hands[i].force = Vec3(0.0, 0.0, -0.05);
                for (int g = 0; g < screen.grips; ++g)
                    if ((screen.gripHeldBy[static_cast<std::size_t>(g)] >> i & 1U) != 0)
                        hands[i].force -= tension_N * span.normalized() *
                                          (screen.gripAt[static_cast<std::size_t>(g)] < 0.3 ? -1.0 : 1.0);
            }
            for (std::size_t i = 0; i < hands.size(); ++i)
                hands[i].follow((*minds)[i]->decide(hands[i].seen(time_s, cues)));
            note(out, task.name, tick, hands);
        }
    }
    hold("tube", out);
}

/// One object to be placed, with its squeeze shown or not; three to be weighed. Some slip.
void TestKeptMinds::objects() {
    QFETCH(QString, who);
    Figures out;
    struct Task {
        const char* name;
        bool weigh, barShown;
        int bodies;
        double trial_s;
    };
    for (const Task& task :
         {Task{"place", false, true, 1, 24.0}, Task{"place, no bar", false, false, 1, 24.0},
          Task{"weigh", true, true, 3, 90.0}}) {
        ObjectHandlingBriefing briefing;
        briefing.weigh = task.weigh;
        briefing.place.origin_m = {0.0, 0.01, 0.0};
        auto minds =
            makeObjectHandlingOperator(*objectHandlingOperatorSettings(who.toStdString()), briefing, 10);
        QVERIFY2(minds, minds ? "" : minds.error().message.c_str());
        std::vector<Hand> hands(1);
        Hand& hand = hands[0];
        hand.p = Vec3(0.0, 0.0, 0.06);
        const Programme programme{.trial_s = task.trial_s, .trials = 2};
        core::VisibleCues cues;
        core::LaparoscopyCues& screen = cues.exercise.own<core::LaparoscopyCues>();
        screen.present = screen.objectShown = screen.targetShown = true;
        screen.bodies = task.bodies;
        screen.p_WTarget = {0.01, 0.035, 0.0};
        screen.targetRadius_m = 0.012;
        screen.squeezeShown = task.barShown;
        screen.squeezeLimit_N = task.barShown ? 2.0 : 0.0;
        const std::array<double, 3> mass_kg{0.02, 0.026, 0.024};
        std::array<Vec3, 3> lies{Vec3(0.02, 0.0, 0.006), Vec3(-0.02, 0.01, 0.006), Vec3(0.0, -0.02, 0.006)},
            place = lies;
        for (int tick = 0; !programme.over(tick * kTick_s); ++tick) {
            const double time_s = tick * kTick_s;
            programme.tell(time_s, cues);
            if (cues.phase != core::TrialPhase::running)
                place = lies;
            const Vec3 tip = hand.p + Vec3(0.0, 0.01, 0.0);
            hand.force = Vec3(0.02 * std::sin(9.0 * time_s), 0.0, -0.1);
            const bool slips = tick % 15'300 > 15'240;
            screen.squeeze_N[0] = 0.0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(task.bodies); ++i) {
                core::BodyCue& body = screen.body[i];
                body.radius_m = 0.006;
                const double gap_m = 2.0 * 0.020 * std::sin(0.5 * hand.jaw_rad),
                             flat_m = std::max(0.0, 0.012 - gap_m);
                const bool held =
                    (tip - place[i]).norm() < (body.heldBy != 0 ? 0.02 : 0.008) && flat_m > 0.0 && !slips;
                body.heldBy = held ? 1 : 0;
                body.squeeze_m = held ? flat_m : 0.0;
                if (held) {
                    place[i] += 0.3 * (tip - place[i]);
                    screen.squeeze_N[0] = 500.0 * flat_m;
                    if (place[i].z() > 0.0065)
                        hand.force.z() -= mass_kg[i] * core::kStandardGravity;
                } else {
                    place[i].z() = std::max(0.006, place[i].z() - 0.0002);
                }
                body.p_W = {place[i].x(), place[i].y(), place[i].z()};
            }
            if (!task.barShown)
                screen.squeeze_N[0] = 0.0;
            if (tip.z() < 0.006)
                hand.force.z() += 300.0 * (0.006 - tip.z());
            hand.follow((*minds)[0]->decide(hand.seen(time_s, cues)));
            note(out, task.name, tick, hands);
        }
    }
    hold("objects", out);
}

/// A square of 60 mm with two lumps, flat or bent, felt through an instrument or on the pad, by one finger,
/// two, or two hands.
void TestKeptMinds::tissue() {
    QFETCH(QString, who);
    Figures out;
    struct Task {
        const char* name;
        int hands, fingers;
        bool bent, pad, shown;
    };
    for (const Task& task :
         {Task{"one finger", 1, 1, false, false, false}, Task{"on the pad", 1, 1, false, true, false},
          Task{"two fingers", 1, 2, true, false, false}, Task{"two hands", 2, 1, true, true, false},
          Task{"shown", 1, 1, true, false, true}}) {
        PalpationBriefing briefing;
        briefing.areaHalf_m = {0.03, 0.03};
        briefing.hands = task.hands;
        briefing.fingers = task.fingers;
        briefing.asksSize = briefing.asksHardness = true;
        briefing.asksConfidence = !task.shown;
        if (task.bent)
            briefing.surface.bumps.push_back(
                {.centre_m = {0.0, 0.0}, .radii_m = {0.05, 0.06}, .turn_rad = 0.0, .height_m = 0.01});
        simulation::StiffRegion normal;
        normal.centre_m = {-0.02, 0.0};
        normal.radii_m = {0.008, 0.006};
        normal.turn_rad = 0.4;
        briefing.normal.push_back(normal);
        auto minds = makePalpationOperator(*palpationOperatorSettings(who.toStdString()), briefing, 12);
        QVERIFY2(minds, minds ? "" : minds.error().message.c_str());
        const simulation::TissueSurface surface(briefing.surface);
        std::vector<Hand> hands(minds->size());
        for (std::size_t i = 0; i < hands.size(); ++i)
            hands[i].p = Vec3(0.018 * static_cast<double>(i), 0.0, 0.04);
        const Programme programme{.trial_s = 45.0, .trials = 2};
        core::VisibleCues cues;
        simulation::PalpationCues& screen = cues.exercise.own<simulation::PalpationCues>();
        screen.present = true;
        screen.asksSize = screen.asksHardness = true;
        screen.bandShown = true;
        screen.bandLow_N = 0.8;
        screen.bandHigh_N = 2.5;
        const std::array<core::Vec2, 3> lumps{core::Vec2(0.012, 0.01), core::Vec2(-0.01, -0.014),
                                              core::Vec2(-0.02, 0.0)};
        screen.lumps = task.shown ? 2 : 0;
        for (std::size_t i = 0; i < 2; ++i)
            screen.lump[i] = {{lumps[i].x(), lumps[i].y(), -0.01}, 0.007};
        std::vector<double> firm(hands.size());
        for (int tick = 0; !programme.over(tick * kTick_s); ++tick) {
            const double time_s = tick * kTick_s;
            programme.tell(time_s, cues);
            if (cues.trial == 1)
                cues.timeLeft_s = 0.0; // no limit is shown
            for (std::size_t i = 0; i < hands.size(); ++i) {
                Hand& hand = hands[i];
                const core::Vec2 at = hand.p.head<2>();
                const double in_m = surface.pointAt(at).z() - hand.p.z();
                const Vec3 normalThere = surface.normalAt(at);
                double k = 320.0;
                core::Vec2 lean = core::Vec2::Zero();
                for (std::size_t lump = 0; lump < lumps.size(); ++lump) {
                    const core::Vec2 away = at - lumps[lump];
                    const double g = 1.0 / (1.0 + away.squaredNorm() / (0.013 * 0.013)),
                                 gain = (lump == 1 ? 0.5 : 0.9) * g * g * g;
                    k += 320.0 * gain;
                    lean += 3.0 * 0.004 / (0.013 * 0.013) * gain * g * away;
                }
                const double force_N = in_m > 0.0 ? k * in_m : 0.0;
                mechanisms::HandPerception seen = hand.seen(time_s, cues);
                if (task.pad) {
                    seen.fingertip = true;
                    seen.f_T_D = Vec3::Zero();
                    seen.pad = {force_N, in_m > 0.0 ? -lean.y() : 0.0, in_m > 0.0 ? lean.x() : 0.0};
                    hand.force = Vec3::Zero();
                } else {
                    hand.force =
                        force_N * normalThere + force_N * Vec3(lean.x(), lean.y(), 0.0) - 0.1 * hand.v;
                    seen.f_T_D = hand.force;
                }
                hand.follow((*minds)[i]->decide(seen));
                firm[i] = force_N;
            }
            note(out, task.name, tick, hands);
            if (tick % 1000 == 0)
                out.each(QStringLiteral("pressed"), firm);
        }
    }
    hold("tissue", out);
}

/// Each setting of every kind of operator, and each number that it is told, far from its range.
void TestKeptMinds::settingsOutOfTheirRange() {
    const auto keep = [this](const char* world, const Figures& figures) {
        const QString differs =
            m_kept.differs(QStringLiteral("settings, %1").arg(QLatin1String(world)), figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    };
    {
        using S = SphereApexOperatorSettings;
        Figures out;
        refuseEach(out, "setting", S{},
                   {spoilt(&S::reachSpeed_m_per_s),
                    spoilt(&S::lowerSpeed_m_per_s),
                    spoilt(&S::scanSpeed_m_per_s),
                    spoilt(&S::climbSpeed_m_per_s),
                    spoilt(&S::sweepSpeed_m_per_s),
                    spoilt(&S::startHeight_m),
                    spoilt(&S::scanRadius_m),
                    spoilt(&S::scanHeight_m),
                    spoilt(&S::scanSpacing_m),
                    spoilt(&S::force_N),
                    spoilt(&S::pressDepth_m),
                    spoilt(&S::forceGain_m_per_Ns),
                    spoilt(&S::topSlope),
                    spoilt(&S::edgeSlope),
                    spoilt(&S::sweepHalfWidth_m),
                    spoilt(&S::crosses),
                    spoilt(&S::wanderRadius_m),
                    spoilt(&S::wanderTime_s),
                    spoilt(&S::settle_s),
                    spoilt(&S::patience_s),
                    [](S& s) { s.hand.reactionDelay_s = kFar; }},
                   [](const S& s) { return makeSphereApexOperator(s, 1); });
        keep("apex", out);
    }
    {
        using S = UrethraInsertionOperatorSettings;
        Figures out;
        refuseEach(out, "setting", S{},
                   {spoilt(&S::insertSpeed_m_per_s), spoilt(&S::withdrawSpeed_m_per_s), spoilt(&S::curveGain),
                    spoilt(&S::turnGain_per_s), spoilt(&S::turnRate_rad_per_s), spoilt(&S::deadZone_rad),
                    spoilt(&S::overshoot_rad), spoilt(&S::stopAngle_rad), spoilt(&S::pushLimit_N),
                    spoilt(&S::acrossLimit_N), spoilt(&S::reliefGain_m_per_Ns),
                    spoilt(&S::reliefTurn_rad_per_Nms), spoilt(&S::lookRate_rad_per_s),
                    spoilt(&S::lookWithin_rad), spoilt(&S::searchAngle_rad), spoilt(&S::anticipation_s),
                    spoilt(&S::centringGain_per_s), spoilt(&S::drawsBackAt_N),
                    [](S& s) { s.hand.reactionDelay_s = kFar; }},
                   [](const S& s) { return makeUrethraInsertionOperator(s, 1); });
        keep("canal", out);
    }
    {
        using S = ObjectHandlingOperatorSettings;
        using B = ObjectHandlingBriefing;
        Figures out;
        refuseEach(out, "setting", S{},
                   {spoilt(&S::attention_s),
                    spoilt(&S::reachSpeed_m_per_s),
                    spoilt(&S::carrySpeed_m_per_s),
                    spoilt(&S::lowerSpeed_m_per_s),
                    spoilt(&S::moveGain_per_s),
                    spoilt(&S::aim_m),
                    spoilt(&S::placeAim_m),
                    spoilt(&S::settle_s),
                    spoilt(&S::jawSpeed_rad_per_s),
                    spoilt(&S::squeezeShare),
                    spoilt(&S::squeezeGain_rad_per_Ns),
                    spoilt(&S::squeezeSpeed_rad_per_s),
                    spoilt(&S::squeezeTolerance),
                    spoilt(&S::flatteningShare),
                    spoilt(&S::regripFactor),
                    spoilt(&S::clearance_m),
                    spoilt(&S::setDownSpeed_m_per_s),
                    spoilt(&S::releaseHeight_m),
                    spoilt(&S::openSpeed_rad_per_s),
                    spoilt(&S::weighTime_s),
                    spoilt(&S::heft_m),
                    spoilt(&S::weighAgain),
                    [](S& s) { s.reach.acceleration_m_per_s2 = kFar; },
                    [](S& s) { s.reach.smoothing_s = kFar; },
                    [](S& s) { s.hand.reactionDelay_s = kFar; }},
                   [](const S& s) { return makeObjectHandlingOperator(s, {}, 1); });
        refuseEach(out, "told", B{},
                   {spoilt(&B::liftHeight_m), spoilt(&B::jawLength_m), [](B& b) { b.place.scale = kFar; }},
                   [](const B& b) { return makeObjectHandlingOperator({}, b, 1); });
        keep("objects", out);
    }
    {
        using S = PalpationOperatorSettings;
        using B = PalpationBriefing;
        Figures out;
        refuseEach(out, "setting", S{},
                   {spoilt(&S::spacing_m), spoilt(&S::reach), spoilt(&S::searchShare),
                    spoilt(&S::pressTime_s), spoilt(&S::aimSd_m), spoilt(&S::forceShare), spoilt(&S::pressSd),
                    spoilt(&S::pressures), spoilt(&S::reachSpeed_m_per_s), spoilt(&S::pressSpeed_m_per_s),
                    spoilt(&S::hover_m), spoilt(&S::hold_s), spoilt(&S::revisits),
                    spoilt(&S::revisitRadius_m), spoilt(&S::revisitAbove), spoilt(&S::criterion),
                    [](S& s) { s.perception.touch_N = kFar; }, [](S& s) { s.hand.reactionDelay_s = kFar; }},
                   [](const S& s) { return makePalpationOperator(s, {}, 1); });
        refuseEach(out, "told", B{},
                   {[](B& b) { b.areaHalf_m.x() = kFar; }, [](B& b) { b.areaHalf_m.y() = kFar; },
                    spoilt(&B::hands), spoilt(&B::fingers), spoilt(&B::fingerSpacing_m),
                    spoilt(&B::bandLow_N), spoilt(&B::bandHigh_N)},
                   [](const B& b) { return makePalpationOperator({}, b, 1); });
        keep("tissue", out);
    }
    {
        using S = ElasticTubeOperatorSettings;
        ElasticTubeBriefing briefing;
        briefing.places.resize(1);
        Figures out;
        refuseEach(out, "setting", S{},
                   {spoilt(&S::attention_s),
                    spoilt(&S::reachSpeed_m_per_s),
                    spoilt(&S::moveGain_per_s),
                    spoilt(&S::aim_m),
                    spoilt(&S::settle_s),
                    spoilt(&S::jawSpeed_rad_per_s),
                    spoilt(&S::openJaw_rad),
                    spoilt(&S::heldJaw_rad),
                    spoilt(&S::jawUnsteadySd_rad),
                    spoilt(&S::pullSpeed_m_per_s),
                    spoilt(&S::correctionRate_per_s),
                    spoilt(&S::assumedStiffness_N_per_m),
                    spoilt(&S::deadZone),
                    spoilt(&S::searchSpeed_m_per_s),
                    spoilt(&S::longestRatio),
                    spoilt(&S::bringSpeed_m_per_s),
                    spoilt(&S::retractShare),
                    [](S& s) { s.reach.acceleration_m_per_s2 = kFar; },
                    [](S& s) { s.reach.smoothing_s = kFar; },
                    [](S& s) { s.hand.reactionDelay_s = kFar; }},
                   [&](const S& s) { return makeElasticTubeOperator(s, briefing, 1); });
        for (const std::size_t instruments : {0U, 1U, 2U, 3U, 4U})
            for (const bool fold : {false, true}) {
                briefing.places.resize(instruments);
                briefing.retracts = fold;
                const auto made = makeElasticTubeOperator(S{}, briefing, 1);
                out.say(QStringLiteral("%1 instruments, %2")
                            .arg(instruments)
                            .arg(QLatin1String(fold ? "a fold" : "no fold")),
                        made ? std::string("made") : made.error().message);
            }
        keep("tube", out);
    }
}

QTEST_APPLESS_MAIN(TestKeptMinds)
#include "test_kept_minds.moc"
