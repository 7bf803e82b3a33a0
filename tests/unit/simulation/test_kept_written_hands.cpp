// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that scenes answer to written hands, for parameters as they are made and for what no level of
// the content asks for: other laws, tasks, yields, decoys. And what is planned for a session, trial by trial.
// Levels are held by tests/replay/test_scene_answers; here is what a new level or a change of one would meet.
// Against what was looked at and kept; a change that is meant is kept anew, and its difference is read in
// review: CHIRON_STORE_OUTLINES=1 ctest --test-dir build/release -R "^test_kept_written_hands$"
#include "core/fp_environment.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"
#include "modules/exercises/object_handling/simulation/object_handling_plan.h"
#include "modules/exercises/object_handling/simulation/object_handling_scene.h"
#include "modules/exercises/palpation/simulation/palpation_plan.h"
#include "modules/exercises/palpation/simulation/palpation_scene.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_scene.h"
#include "support/answer_numbers.h"
#include "support/kept_numbers.h"

#include <QtTest>
#include <cmath>
#include <functional>
#include <memory>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;
using tests::NumberLines;

namespace {

constexpr std::uint64_t kSeed = 9;
constexpr int kBlock_ticks = 400, kPhase_ticks = 500, kPhases = 9, kRounds = 3;
const std::vector<std::string> kAllCues{"object", "tool",  "arrow",    "bars",    "numbers",
                                        "plots",  "sound", "coverage", "guidance"};

/// A scene by name, its tools, and where a tool's work is at a tick (W): what it goes to, and where it brings
/// it.
struct Case {
    QString name;
    std::function<std::unique_ptr<IScene>()> make;
    int tools = 1;
    std::function<Vec3(int trial)> where = [](int) { return Vec3(Vec3::Zero()); };
    std::function<Vec3(double share)> along = nullptr; ///< of an endoscope: the way in, 0..1 and beyond
};

double jerkless(double x) {
    return x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
}

/// Over it, down, taken hold of, lifted, brought away, let go, pressed and rubbed, up, and rest: by turns
/// with marks, reports and a pause.
QStringList told(const Case& c) {
    NumberLines lines;
    const std::unique_ptr<IScene> scene = c.make();
    tests::AnswerBlocks blocks(kBlock_ticks);
    realtime::TickSource source;
    SceneInput in;
    SceneOutput out;
    in.tools.count = c.tools;
    std::array<Vec3, core::kMaxTools> from, to;
    for (int i = 0; i < c.tools; ++i) {
        core::ToolState& tool = in.tools.tools[static_cast<std::size_t>(i)];
        tool.p_WT = Vec3(0.03 * i - 0.02, 0.05, 0.08);
        tool.jaw_rad = 1.0;
        from[static_cast<std::size_t>(i)] = to[static_cast<std::size_t>(i)] = tool.p_WT;
        in.dampingBudget_Ns_per_m[static_cast<std::size_t>(i)] = 12.0 + 4.0 * i;
    }
    for (int tick = 0; tick < kRounds * kPhases * kPhase_ticks; ++tick) {
        const int phase = tick / kPhase_ticks % kPhases, round = tick / kPhase_ticks / kPhases;
        const double share = static_cast<double>(tick % kPhase_ticks) / kPhase_ticks;
        in.started = tick >= 50;
        in.forceReady = tick >= 100 && tick % 3000 > 10;
        in.paused = tick % 5000 >= 4600 && tick % 5000 < 4700;
        in.mark = (tick == 4100 || tick == 8300) && !c.along;
        in.reports = tick % 2500 >= 1200 && tick % 2500 < 1206 ? 1 : 0;
        using R = simulation::ReportField;
        const std::uint16_t words[] = {
            simulation::reportWord(R::found, 0),    simulation::reportWord(R::size, 70),
            simulation::reportWord(R::hardness, 4), simulation::reportWord(R::confidence, 3),
            simulation::reportWord(R::select, 0),   simulation::reportWord(R::remove, 1)};
        in.report[0] = words[static_cast<std::size_t>(tick % 2500 - 1200) % 6];
        if (tick == 9000) {
            in.reports = 1;
            in.report[0] = simulation::reportWord(R::done, 0);
        }
        for (int t = 0; t < c.tools; ++t) {
            const auto i = static_cast<std::size_t>(t);
            core::ToolState& tool = in.tools.tools[i];
            const Vec3 before = tool.p_WT;
            const core::Quat turnedBefore = tool.q_WT;
            if (c.along) { // in, somewhat beside the way, and out again
                const double way =
                    -0.1 +
                    1.25 * std::sin(0.5 * 3.14159265358979 * std::min(1.0, tick / 9000.0) *
                                    (tick < 11000 ? 1.0 : std::max(0.0, 1.0 - (tick - 11000) / 2000.0)));
                const Vec3 p = c.along(way), ahead = c.along(way + 0.01);
                tool.p_WT =
                    p + 0.002 * Vec3(std::sin(0.002 * tick), std::cos(0.003 * tick), std::sin(0.0013 * tick));
                const Vec3 axis = (ahead - p).normalized() +
                                  0.06 * Vec3(std::sin(0.0017 * tick), 0.5 * std::cos(0.0023 * tick), 0.0);
                tool.q_WT = core::Quat::FromTwoVectors(-Vec3::UnitZ(), axis.normalized()) *
                            core::Quat(Eigen::AngleAxisd(0.3 * std::sin(0.001 * tick), Vec3::UnitZ()));
                tool.buttons = 0;
            } else {
                const core::LaparoscopyCues& l = out.cues.exercise.of<core::LaparoscopyCues>();
                if (tick % kPhase_ticks == 0) {
                    Vec3 at = c.where(out.trial) + Vec3(0.004 * round, -0.003 * round, 0.0);
                    if (l.bodies > 0)
                        at = Vec3(l.body[0].p_W[0], l.body[0].p_W[1], l.body[0].p_W[2]);
                    if (l.grips > 0) {
                        const std::size_t grip = t == 0 ? static_cast<std::size_t>(l.grips) - 1 : 0;
                        at = Vec3(l.p_WGrip[grip][0], l.p_WGrip[grip][1], l.p_WGrip[grip][2]);
                    }
                    if (l.fold && t + 1 == c.tools)
                        at = Vec3(l.p_WFoldEdge[0], l.p_WFoldEdge[1], l.p_WFoldEdge[2]);
                    const Vec3 target = l.targetShown ? Vec3(l.p_WTarget[0], l.p_WTarget[1], l.p_WTarget[2])
                                                      : Vec3(at + Vec3(0.012 - 0.03 * t, 0.01, 0.02));
                    const Vec3 ways[kPhases] = {at + Vec3(0.0, 0.0, 0.03),
                                                at,
                                                at,
                                                at + Vec3(0.004 - 0.02 * t, 0.0, 0.035),
                                                target + Vec3(0.0, 0.0, 0.004),
                                                target + Vec3(0.0, 0.0, 0.002),
                                                at + Vec3(-0.004, 0.002, -0.004),
                                                at + Vec3(0.007, -0.005, -0.003),
                                                at + Vec3(0.0, 0.0, 0.04)};
                    from[i] = tool.p_WT;
                    to[i] = ways[phase];
                }
                tool.p_WT = from[i] + jerkless(share) * (to[i] - from[i]);
                tool.q_WT =
                    core::Quat(Eigen::AngleAxisd(0.2 * std::sin(0.002 * tick + t), Vec3(0.6, 0.0, 0.8)));
                const double wanted = phase >= 2 && phase <= 4 ? 0.05 * (round + 1) : 1.1;
                tool.jaw_rad += std::clamp(wanted - tool.jaw_rad, -0.004, 0.004);
                tool.buttons = tick % 6000 >= 5200 && tick % 6000 < 5220 ? core::kButtonMark : 0u;
                if (t == 0 && tick % 4000 >= 3100 && tick % 4000 < 3110)
                    tool.buttons |= core::reportButtons(simulation::reportWord(R::hardness, 2));
            }
            tool.v_WT = tick == 0 ? Vec3(Vec3::Zero()) : Vec3((tool.p_WT - before) / 0.001);
            const Eigen::AngleAxisd turn(tool.q_WT * turnedBefore.conjugate());
            tool.w_WT = tick == 0 ? Vec3(Vec3::Zero()) : Vec3(turn.angle() / 0.001 * turn.axis());
        }
        if (tick == 7777) { // a pose that is none
            const Vec3 p = in.tools.tools[0].p_WT;
            in.tools.tools[0].p_WT.y() = std::nan("");
            scene->respond(source.next(0), in, out);
            in.tools.tools[0].p_WT = p;
        } else {
            scene->respond(source.next(0), in, out);
        }
        if (blocks.add(out))
            lines.add(blocks.line());
    }
    return lines.lines();
}

std::vector<Case> apexes() {
    const auto make = [](const char* name, auto change) {
        SphereApexParameters p;
        p.cues = kAllCues;
        p.trials = 3;
        p.trialLimit_s = 6.0;
        change(p);
        const auto plan = std::make_shared<std::vector<SphereApexTrial>>(planSphereApexTrials(p, kSeed));
        return Case{QStringLiteral("apex, %1").arg(QLatin1String(name)),
                    [p] { return std::make_unique<SphereApexScene>(p, kSeed); }, 1,
                    [plan, p](int trial) {
                        const core::Vec2& at =
                            (*plan)[static_cast<std::size_t>(trial) % plan->size()].centre_m;
                        return Vec3(at.x(), at.y(), p.planeHeight_m + p.radius_m);
                    }};
    };
    return {make("as it is made", [](SphereApexParameters&) {}),
            make("everything",
                 [](SphereApexParameters& p) {
                     p.planeHeight_m = 0.005;
                     p.stiffnessLow_N_per_m = 200.0;
                     p.stiffnessVariation = 0.3;
                     p.frictionHigh = 0.4;
                     p.dimpleDepth_m = 0.0006;
                     p.yield.force_N = 1.6;
                 }),
            make("mesh",
                 [](SphereApexParameters& p) {
                     p.surface = ApexSurface::mesh;
                     p.meshEdge_m = 0.003;
                     p.bumpHeight_m = 0.0004;
                     p.roughness_m = 3e-5;
                     p.frictionLow = p.frictionHigh = 0.2;
                 }),
            make("organ", [](SphereApexParameters& p) {
                p.surface = ApexSurface::organ;
                p.meshEdge_m = 0.004;
                p.slowPeriod_ms = 25;
                p.slowLatency_ms = 22;
            })};
}

std::vector<Case> tubes() {
    const auto make = [](const char* name, auto change) {
        ElasticTubeParameters p;
        p.cues = kAllCues;
        p.trials = 3;
        p.trialLimit_s = 7.0;
        p.hold_s = 0.4;
        change(p);
        return Case{QStringLiteral("tube, %1").arg(QLatin1String(name)),
                    [p] { return std::make_unique<ElasticTubeScene>(p, kSeed); }, p.tools()};
    };
    return {make("as it is made", [](ElasticTubeParameters&) {}),
            make("to the mark, stiffening",
                 [](ElasticTubeParameters& p) {
                     p.task = TubeTask::stretch;
                     p.tube.stiffness_N_per_m = 40.0;
                     p.tube.stiffening_per_m = 30.0;
                     p.tube.viscosity_Ns_per_m = 2.0;
                     p.overStretchRatio = 1.4;
                 }),
            make("two-handed, under a fold",
                 [](ElasticTubeParameters& p) {
                     p.task = TubeTask::twoHanded;
                     p.stiffnessLow_N_per_m = 50.0;
                     p.stiffnessHigh_N_per_m = 90.0;
                     p.foldStiffness_N_per_m = 60.0;
                 }),
            make("handed over, tears, gives way", [](ElasticTubeParameters& p) {
                p.task = TubeTask::transfer;
                p.tube.stiffness_N_per_m = 60.0;
                p.tearRatio = 1.6;
                p.yield.force_N = 1.5;
            })};
}

std::vector<Case> objects() {
    const auto make = [](const char* name, auto change) {
        ObjectHandlingParameters p;
        p.cues = kAllCues;
        p.trials = 3;
        p.trialLimit_s = 7.0;
        p.hold_s = 0.3;
        p.object.mass_kg = 0.02;
        p.object.friction = 0.5;
        p.object.stiffness_N_per_m = 400.0;
        p.bed.stiffness_N_per_m = 300.0;
        change(p);
        return Case{QStringLiteral("object, %1").arg(QLatin1String(name)),
                    [p] { return std::make_unique<ObjectHandlingScene>(p, kSeed); }, p.tools()};
    };
    return {make("as it is made", [](ObjectHandlingParameters&) {}),
            make("slippery, soft and squeezed",
                 [](ObjectHandlingParameters& p) {
                     p.object.friction = 0.08;
                     p.object.recoveryTime_s = 0.2;
                     p.object.recoveryShare = 0.6;
                     p.object.roughness_m = 3e-5;
                     p.squeezeLimit_N = 0.5;
                     p.dropSpeed_m_per_s = 0.02;
                     p.liftHeight_m = 0.01;
                     p.yield.force_N = 2.0;
                 }),
            make("the heaviest of three",
                 [](ObjectHandlingParameters& p) {
                     p.task = HandlingTask::weigh;
                     p.objects = 3;
                     p.massLow_kg = 0.01;
                     p.massHigh_kg = 0.04;
                 }),
            make("on an organ", [](ObjectHandlingParameters& p) {
                p.organBed = true;
                p.bedMesh.shape = MeshSource::Shape::dome;
                p.bedMesh.halfAxisX_m = 0.03;
                p.bedMesh.edge_m = 0.008;
                p.bedRate_Hz = 40.0;
                p.bedLatency_ticks = 24;
            })};
}

std::vector<Case> palpations() {
    const auto make = [](const char* name, auto change) {
        PalpationParameters p;
        p.cues = kAllCues;
        p.trials = 3;
        p.trialLimit_s = 7.0;
        change(p);
        const auto plan = std::make_shared<std::vector<PalpationTrial>>(planPalpationTrials(p, kSeed));
        return Case{QStringLiteral("palpation, %1").arg(QLatin1String(name)),
                    [p] { return std::make_unique<PalpationScene>(p, kSeed); }, p.tools(),
                    [plan, p](int trial) {
                        const PalpationTrial& now = (*plan)[static_cast<std::size_t>(trial) % plan->size()];
                        const core::Vec2 at = now.lumps > 0 ? now.lump[0].place_m : core::Vec2(0.01, -0.01);
                        return Vec3(at.x() + 0.003, at.y() - 0.002, p.tissue.shape.planeHeight_m);
                    }};
    };
    const auto bumpy = [](PalpationParameters& p) {
        p.tissue.shape.planeHeight_m = -0.004;
        p.tissue.shape.bumps = {{{0.01, -0.01}, {0.03, 0.02}, 0.4, 0.006},
                                {{-0.02, 0.02}, {0.02, 0.03}, 0.0, -0.003}};
        p.tissue.layers = {{"skin", 0.002, 40e3}, {"fat", 0.01, 12e3}, {"muscle", 0.0, 60e3}};
        p.tissue.regions = {{"areola", {0.0, 0.0}, {0.012, 0.009}, 0.3, 0.4}};
        p.tissue.fibreDirection = {0.6, 0.8, 0.1};
        p.lumpsHigh = 3;
        p.depthSpread_m = 0.002;
        p.catchTrials = 1;
        p.kinds = {{}, {0.005, 0.010, 3.0, 2}};
    };
    return {make("as it is made", [](PalpationParameters&) {}),
            make("bumps, layers, regions, two fingers",
                 [&](PalpationParameters& p) {
                     bumpy(p);
                     p.fingers = 2;
                     p.asksSize = p.asksHardness = true;
                 }),
            make("cast anew each tick, a second surface",
                 [&](PalpationParameters& p) {
                     bumpy(p);
                     p.tissue.contact = TissueContactLaw::p3Recast;
                     p.tissue.lumps = LumpLaw::secondSurface;
                 }),
            make("stiffness times depth, gives way",
                 [&](PalpationParameters& p) {
                     bumpy(p);
                     p.tissue.lumps = LumpLaw::stiffnessTimesDepth;
                     p.tissue.stiffness_N_per_m = 500.0;
                     p.yield.force_N = 1.2;
                 }),
            make("pinched by two hands",
                 [](PalpationParameters& p) {
                     p.hands = 2;
                     p.pinch = PinchParameters{};
                 }),
            make("moved under the hand",
                 [](PalpationParameters& p) {
                     p.control.moveAfter_s = 1.5;
                     p.control.move_m = {0.01, -0.01};
                 }),
            make("without force", [](PalpationParameters& p) { p.control.forceOff = true; })};
}

std::vector<Case> urethras() {
    const auto make = [](const char* name, auto change) {
        UrethraInsertionParameters p;
        p.cues = kAllCues;
        p.trialLimit_s = 13.0;
        p.landmarkHold_s = 0.2;
        p.landmarkSpeed_m_per_s = 0.05;
        p.landmarks = {{"right", 1.0, 0.7}, {"left", 1.0, -0.7}, {"dome", 0.2, 0.0}};
        change(p);
        const UrethraCentreline line(p.anatomy);
        return Case{
            QStringLiteral("urethra, %1").arg(QLatin1String(name)),
            [p] { return std::make_unique<UrethraInsertionScene>(p); }, 1,
            [](int) { return Vec3(Vec3::Zero()); },
            [line, p](double share) { return p.pose.pointToW(line.at(share * line.length_m()).p_A); }};
    };
    return {make("as it is made", [](UrethraInsertionParameters&) {}),
            make("a stricture, straight at first, with a meatus",
                 [](UrethraInsertionParameters& p) {
                     p.anatomy.straight_m = 0.02;
                     p.anatomy.pivotSpan_m = 0.05;
                     p.anatomy.wallRetardation_s = 0.01;
                     p.anatomy.freeHold_N_per_m = 400.0;
                     p.anatomy.changeCount = 1;
                     p.anatomy.changes[0] = {0.06, 0.014, 0.004, 0.0017, 6.0, 2.0};
                     p.meatus_m = 0.006;
                     p.depthOfField = true;
                 }),
            make("P1's sections, gives way, to the goal alone", [](UrethraInsertionParameters& p) {
                p.forces.sections = ForceSections::p1Basic;
                p.forces.basicSections = 9;
                p.yield.force_N = 2.0;
                p.yield.torque_Nm = 0.08;
                p.goalDepth_m = 0.07;
                p.withdraws = false;
                p.landmarks.clear();
            })};
}

std::vector<Case> all() {
    std::vector<Case> cases;
    for (const auto& some : {apexes(), tubes(), objects(), palpations(), urethras()})
        cases.insert(cases.end(), some.begin(), some.end());
    return cases;
}

} // namespace

class TestKeptAnswers : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void scenesAnswerAsTheyWereKept_data();
    void scenesAnswerAsTheyWereKept();
    void plansAreAsTheyWereKept();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const QStringList& lines) {
        const QString differs = m_kept.differs(name, lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/simulation/kept_written_hands.txt"),
                           &tests::sameNumbers};
};

void TestKeptAnswers::scenesAnswerAsTheyWereKept_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Case& c : all())
        QTest::newRow(qPrintable(c.name)) << index++;
}

void TestKeptAnswers::scenesAnswerAsTheyWereKept() {
    QFETCH(int, index);
    const Case c = all()[static_cast<std::size_t>(index)];
    hold(c.name, told(c));
}

/// Narrow ones, too, where trials are drawn again and again, and where there is no room.
void TestKeptAnswers::plansAreAsTheyWereKept() {
    NumberLines lines;
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        SphereApexParameters apex;
        apex.trials = 4;
        apex.stiffnessHigh_N_per_m = 900.0;
        apex.frictionHigh = 0.5;
        apex.dimpleDepth_m = 0.001;
        apex.centreDiscRadius_m = seed == 3 ? 0.06 : 0.03;
        lines.add(QStringLiteral("apex"));
        for (const SphereApexTrial& t : planSphereApexTrials(apex, seed))
            lines.add(QStringLiteral("  trial"),
                      {t.centre_m.x(), t.centre_m.y(), t.stiffness_N_per_m, t.friction, t.phase_rad.x(),
                       t.phase_rad.y(), t.dimpleCentre_m.x(), t.dimpleCentre_m.y(), t.turn_rad,
                       static_cast<double>(t.roughnessSeed % 1'000'003)});
        ElasticTubeParameters tube;
        tube.stiffnessLow_N_per_m = seed == 2 ? 0.0 : 40.0;
        tube.stiffnessHigh_N_per_m = seed == 2 ? 0.0 : 80.0;
        tube.task = seed == 3 ? TubeTask::transfer : TubeTask::hold;
        tube.foldStiffness_N_per_m = 50.0;
        lines.add(QStringLiteral("tube"));
        for (const ElasticTubeTrial& t : planElasticTubeTrials(tube, seed))
            lines.add(QStringLiteral("  trial"),
                      {t.base_m.x(), t.base_m.y(), t.stiffness_N_per_m, t.target_N});
        for (const bool tight : {false, true}) {
            ObjectHandlingParameters object;
            object.objects = 3;
            object.task = seed == 2 ? HandlingTask::place : HandlingTask::weigh;
            object.object.mass_kg = 0.03;
            object.massLow_kg = seed == 3 ? 0.0 : 0.01;
            object.massHigh_kg = seed == 3 ? 0.0 : 0.05;
            object.placesRadius_m = tight ? 0.018 : 0.045;
            lines.add(QStringLiteral("object"), {objectSpacing_m(object), targetSpacing_m(object)});
            for (const ObjectHandlingTrial& t : planObjectHandlingTrials(object, seed))
                lines.add(QStringLiteral("  trial"),
                          {static_cast<double>(t.objects), t.place_m[0].x(), t.place_m[0].y(),
                           t.place_m[1].x(), t.place_m[1].y(), t.place_m[2].x(), t.place_m[2].y(),
                           t.mass_kg[0], t.mass_kg[1], t.mass_kg[2], t.target_m.x(), t.target_m.y(),
                           static_cast<double>(t.heaviest)});
            PalpationParameters palpation;
            palpation.trials = 5;
            palpation.catchTrials = 2;
            palpation.lumpsHigh = tight ? 6 : 3;
            palpation.spacing_m = tight ? 0.027 : 0.020;
            palpation.depthSpread_m = 0.003;
            palpation.kinds = {{}, {0.005, 0.004, 3.0, 2}};
            palpation.regionColumns = seed == 2 ? 4 : 3;
            palpation.tissue.regions = {{"areola", {0.0, 0.0}, {0.012, 0.012}, 0.0, 0.4}};
            palpation.control.moveAfter_s = seed == 3 ? 5.0 : 0.0;
            palpation.control.move_m = {0.02, 0.0};
            lines.add(QStringLiteral("palpation"), {static_cast<double>(mostPalpationLumps(palpation))});
            for (const PalpationTrial& t : planPalpationTrials(palpation, seed)) {
                lines.add(QStringLiteral("  trial of %1").arg(t.lumps));
                for (int i = 0; i < t.lumps; ++i) {
                    const Lump& lump = t.lump[static_cast<std::size_t>(i)];
                    const core::Vec2 moved = palpationMovedPlace_m(palpation, lump.place_m);
                    lines.add(QStringLiteral("    lump"),
                              {lump.place_m.x(), lump.place_m.y(), lump.depth_m, lump.radius_m, lump.ratio,
                               static_cast<double>(t.hardness[static_cast<std::size_t>(i)]), moved.x(),
                               moved.y(), static_cast<double>(palpationRegion(palpation, lump.place_m))});
                }
            }
            for (const double x : {-0.0401, -0.04, -0.0134, -0.0133, 0.0, 0.02, 0.04, 0.0401})
                lines.add(QStringLiteral("  region"),
                          {x, static_cast<double>(palpationRegion(palpation, {x, 0.03})),
                           static_cast<double>(palpationRegion(palpation, {0.03, x}))});
            for (int region = 0; region < 9; ++region)
                lines.addMatrix(QStringLiteral("  middle"), palpationRegionMiddle_m(palpation, region));
        }
    }
    UrethraInsertionParameters urethra;
    const UrethraCentreline line(urethra.anatomy);
    lines.addMatrix(QStringLiteral("bladder"), bladderCentre_A(urethra.anatomy, line));
    for (const double azimuth : {0.0, 0.9, -2.0})
        lines.addMatrix(QStringLiteral("landmark"), landmark_A(urethra.anatomy, line, {"one", 0.8, azimuth}));
    hold(QStringLiteral("plans"), lines.lines());
}

QTEST_APPLESS_MAIN(TestKeptAnswers)
#include "test_kept_written_hands.moc"
