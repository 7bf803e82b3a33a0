// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded grasping exercise played back: the scene as it was, the plots, the marks in words.
#include "app/exercises/elastic_tube/desktop/tube_layer.h"
#include "app/exercises/palpation/desktop/palpation_layer.h"
#include "desktop/exercise_face.h"
#include "desktop/playback/grasp_moment.h"
#include "desktop/playback/mark_look.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_scene.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "report/plot_view.h"
#include "session/study/comparison_marks.h"
#include "session_report/mark_words.h"

#include <QtTest>
#include <set>

#include <qcustomplot.h>
#include <tuple>

using namespace chiron;
using namespace chiron::desktop;
using simulation::TubeTask;

namespace {

session::SessionSetup tubeSetup(TubeTask task) {
    session::SessionSetup setup;
    setup.seed = 5;
    setup.level.exercise = "elastic_tube";
    simulation::ElasticTubeParameters tube;
    tube.task = task;
    tube.trials = 2;
    setup.level.parameters = tube;
    return setup;
}

/// What a playback adds for the exercise of this setup.
std::unique_ptr<PlaybackLayer> layerOf(const session::SessionSetup& setup) {
    return exerciseFace(setup.level.exercise).value()->playbackLayer(setup, {});
}

/// Two seconds of trial 0 at 250 samples a second, the instruments still.
session::PlaybackTrack madeTrack(int tools, const std::vector<std::pair<std::string, double>>& quantities) {
    session::PlaybackTrack track;
    track.toolCount = tools;
    track.forceLimit_N = 4.0;
    track.duration_s = 2.0;
    for (const auto& [id, value] : quantities)
        track.quantities.push_back({id, id.substr(id.find_last_of('_') + 1), {}});
    for (int i = 0; i < 500; ++i) {
        session::PlaybackMoment moment;
        moment.t_s = 4e-3 * i;
        moment.phase = core::TrialPhase::running;
        track.moments.push_back(moment);
        for (int tool = 0; tool < tools; ++tool) {
            session::PlaybackTool pose;
            pose.p_WT = core::Vec3(tool == 0 ? 0.030 : -0.030, 0.0, 0.040);
            pose.jaw_rad = 0.8;
            track.tools.push_back(pose);
        }
        for (std::size_t q = 0; q < quantities.size(); ++q)
            track.quantities[q].values.push_back(quantities[q].second);
    }
    session::PlaybackTrial trial;
    trial.end_s = 2.0;
    track.trials.push_back(trial);
    return track;
}

} // namespace

class TestGraspReview : public QObject {
    Q_OBJECT
private slots:
    void aHeldTubeIsWhereItWas() {
        const session::SessionSetup setup = tubeSetup(TubeTask::twoHanded);
        const session::PlaybackTrack track = madeTrack(2, {{"tension_N", 1.2},
                                                           {"stretch_m", 0.015},
                                                           {"grip_0", 2.0},
                                                           {"grip_1", 1.0},
                                                           {"grip_2", 0.0},
                                                           {"free_end_x_m", 0.031},
                                                           {"free_end_y_m", 0.001},
                                                           {"free_end_z_m", 0.041},
                                                           {"step", 3.0},
                                                           {"dwell", 0.5}});
        const auto replay = layerOf(setup);
        QVERIFY(replay != nullptr);
        const core::LaparoscopyCues cues =
            sceneStateAt(track, nullptr, 1.0, replay.get()).exercise.of<core::LaparoscopyCues>();
        QVERIFY(cues.present && cues.objectShown && cues.tube && cues.tensionShown);
        QCOMPARE(cues.grips, 2);
        QVERIFY(!cues.gripAnchored[0]);
        QCOMPARE(cues.p_WGrip[0][0], -0.030); // the left tip, which holds it
        QCOMPARE(cues.p_WGrip[1][0], 0.031);  // recorded
        QCOMPARE(cues.tension_N, 1.2);
        QCOMPARE(int(cues.step), int(core::LaparoscopyStep::hold));
        const auto trials = simulation::planElasticTubeTrials(
            setup.level.parameters.as<simulation::ElasticTubeParameters>(), setup.seed);
        QVERIFY(std::abs(0.5 * (cues.bandLow_N + cues.bandHigh_N) - trials[0].target_N) < 1e-12);
        const TubeLayer tube(setup.level.parameters.as<simulation::ElasticTubeParameters>(), setup.seed);
        QVERIFY(tube.bandOf(7).high_N == 0.0 && tube.bandOf(-1).high_N == 0.0);
    }

    void aFoldIsDrawnBackByTheThirdInstrument() {
        session::SessionSetup setup = tubeSetup(TubeTask::twoHanded);
        auto& tube = setup.level.parameters.as<simulation::ElasticTubeParameters>();
        tube.foldStiffness_N_per_m = 25.0;
        tube.retractionLow_N = 0.6;
        tube.retractionHigh_N = 1.0;
        const session::PlaybackTrack track = madeTrack(3, {{"tension_N", 1.2},
                                                           {"retraction_N", 0.8},
                                                           {"fold_open", 1.0},
                                                           {"fold_edge_x_m", 0.002},
                                                           {"fold_edge_y_m", 0.03},
                                                           {"fold_edge_z_m", 0.025},
                                                           {"step", 9.0}});
        const auto replay = layerOf(setup);
        const core::LaparoscopyCues cues =
            sceneStateAt(track, nullptr, 1.0, replay.get()).exercise.of<core::LaparoscopyCues>();
        QVERIFY(cues.fold && cues.foldOpen && cues.retractionShown);
        QCOMPARE(cues.p_WFoldEdge[1], 0.03);
        QCOMPARE(cues.retraction_N, 0.8);
        QCOMPARE(int(cues.foldHeldBy), 4);
        QCOMPARE(int(cues.step), int(core::LaparoscopyStep::retract));
        QCOMPARE(TubeLayer(tube, setup.seed).retractionBand().high_N, 1.0);
        const session::SessionSetup plain = tubeSetup(TubeTask::twoHanded);
        const auto withoutFold = layerOf(plain);
        QVERIFY(
            !sceneStateAt(track, nullptr, 1.0, withoutFold.get()).exercise.of<core::LaparoscopyCues>().fold);
    }

    void aTransferKnowsBaseAndTarget() {
        const session::SessionSetup setup = tubeSetup(TubeTask::transfer);
        const session::PlaybackTrack track =
            madeTrack(2, {{"grip_2", 1.0}, {"free_end_x_m", 0.03}, {"free_end_z_m", 0.04}});
        const auto replay = layerOf(setup);
        const core::LaparoscopyCues cues =
            sceneStateAt(track, nullptr, 1.0, replay.get()).exercise.of<core::LaparoscopyCues>();
        QCOMPARE(cues.grips, 3);
        QVERIFY(cues.gripAnchored[0] && cues.targetShown && cues.bandHigh_N == 0.0);
        const auto trials = simulation::planElasticTubeTrials(
            setup.level.parameters.as<simulation::ElasticTubeParameters>(), setup.seed);
        QCOMPARE(cues.p_WGrip[0][0], trials[0].base_m.x());
    }

    void aHeldObjectIsSqueezedByWhatTheJawLeaves() {
        session::SessionSetup setup;
        setup.level.exercise = "object_handling";
        setup.level.parameters = simulation::ObjectHandlingParameters{};
        const session::PlaybackTrack track = madeTrack(1, {{"squeeze_N", 0.9},
                                                           {"held", 1.0},
                                                           {"body_0_x_m", 0.01},
                                                           {"body_0_y_m", 0.02},
                                                           {"body_0_z_m", 0.03}});
        const auto replay = layerOf(setup);
        const core::LaparoscopyCues cues =
            sceneStateAt(track, nullptr, 1.0, replay.get()).exercise.of<core::LaparoscopyCues>();
        QCOMPARE(cues.bodies, 1);
        QCOMPARE(int(cues.body[0].heldBy), 1);
        QCOMPARE(cues.body[0].p_W[2], 0.03);
        QVERIFY(std::abs(cues.body[0].squeeze_m - (0.022 - 2.0 * 0.020 * std::sin(0.4))) < 1e-12);
        QCOMPARE(cues.squeeze_N[0], 0.9);
        QVERIFY(cues.targetShown);
    }

    void aTornTubeIsShownTornAfterItsTrial() {
        const session::SessionSetup setup = tubeSetup(TubeTask::stretch);
        session::PlaybackTrack track = madeTrack(1, {{"grip_1", 1.0}, {"free_end_z_m", 0.08}});
        for (std::size_t i = 250; i < 500; ++i)
            track.moments[i].phase = core::TrialPhase::between;
        const auto replay = layerOf(setup);
        QVERIFY(
            !sceneStateAt(track, nullptr, 1.5, replay.get()).exercise.of<core::LaparoscopyCues>().present);
        track.trials[0].failed = true;
        QVERIFY(sceneStateAt(track, nullptr, 1.5, replay.get()).exercise.of<core::LaparoscopyCues>().torn);
        QVERIFY(!sceneStateAt(track, nullptr, 0.5, replay.get()).exercise.of<core::LaparoscopyCues>().torn);
    }

    void excessEnergyHasItsSpans() {
        const std::vector<double> t_s{0.0, 0.1, 0.2, 0.3, 0.4, 0.5}, in(6, 0.010);
        const auto spans = desktop::excessEnergy(t_s, in, {0.012, 0.010005, 0.011, 0.012, 0.013, 0.009});
        QCOMPARE(spans.size(), std::size_t{2}); // 5 µJ are rounding
        QCOMPARE(spans[0].begin_s, 0.0);
        QCOMPARE(spans[0].end_s, 0.0);
        QCOMPARE(spans[1].begin_s, 0.2);
        QCOMPARE(spans[1].end_s, 0.4);
        QVERIFY(desktop::excessEnergy(t_s, in, in).empty());
    }

    void plotsOfTensionAndOfBothEnergies() {
        const session::SessionSetup setup = tubeSetup(TubeTask::hold);
        session::PlaybackTrack track =
            madeTrack(1, {{"tension_N", 1.0}, {"energy_supplied_J", 0.010}, {"energy_stored_J", 0.008}});
        const auto replay = layerOf(setup);
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        const auto legend = [&] {
            PlaybackPlots plots(theme, QLocale::c(), track, setup.level, replay.get());
            const auto* energy = plots.findChild<report::PlotView*>(QStringLiteral("playback.energy_plot"));
            if (!energy || !plots.findChild<report::PlotView*>(QStringLiteral("playback.grasp_plot")))
                return QStringList();
            return energy->legendTexts();
        };
        QCOMPARE(legend().size(), 2);
        for (std::size_t i = 100; i < 200; ++i)
            track.quantities[2].values[i] = 0.012; // more is held than was put in
        QCOMPARE(legend().size(), 3);
        // Of one energy alone, or of two that do not belong together, nothing can be said.
        const session::PlaybackTrack whole = track;
        using Quantities = std::vector<session::PlaybackQuantity>;
        const std::vector<std::function<void(Quantities&)>> losses{
            [](Quantities& q) { q.erase(q.begin() + 1); }, [](Quantities& q) { q.erase(q.begin() + 2); },
            [](Quantities& q) { q[1].values.resize(10); },
            [](Quantities& q) {
                q[1].values.clear();
                q[2].values.clear();
            }};
        for (const auto& lose : losses) {
            track = whole;
            lose(track.quantities);
            QCOMPARE(legend(), QStringList());
        }
        track = whole;
        PlaybackPlots without(theme, QLocale::c(), track, setup.level);
        QVERIFY(!without.findChild<report::PlotView*>(
            QStringLiteral("playback.felt_plot"))); // of one tool it is a line in the plot of force
        QVERIFY(!without.findChild<report::PlotView*>(QStringLiteral("playback.grasp_plot")));
    }

    void leansAreDrawnInDegreesAndDepthsInMillimetres() {
        const session::PlaybackTrack track = madeTrack(1, {{"lean_0_rad", 0.5}, {"depth_0_m", 0.003}});
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        const PalpationLayer layer(core::Error{}); // what was found is not asked for
        catalogue::ExerciseLevel level;
        level.exercise = "palpation";
        level.parameters = simulation::PalpationParameters{};
        PlaybackPlots plots(theme, QLocale::c(), track, level, &layer);
        plots.resize(900, 620);
        plots.grab(); // lines are made for a width
        std::vector<double> drawn;
        for (QCustomPlot* plot : plots.findChildren<QCustomPlot*>())
            for (int i = 0; i < plot->graphCount(); ++i)
                if (plot->graph(i)->name() == QStringLiteral("finger") && plot->graph(i)->dataCount() > 0)
                    drawn.push_back(plot->graph(i)->data()->at(0)->value);
        std::sort(drawn.begin(), drawn.end());
        QCOMPARE(drawn.size(), std::size_t(2));
        std::sort(drawn.begin(), drawn.end());
        QVERIFY(std::abs(drawn[0] - 3.0) < 1e-9 && std::abs(drawn[1] - 28.64788975654116) < 1e-9);
    }

    void plotsHaveEveryTool() {
        const session::SessionSetup setup = tubeSetup(TubeTask::twoHanded);
        session::PlaybackTrack track = madeTrack(3, {{"tension_N", 1.0}});
        track.felt = true;
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        PlaybackPlots plots(theme, QLocale::c(), track, setup.level);
        const auto* felt = plots.findChild<report::PlotView*>(QStringLiteral("playback.felt_plot"));
        QVERIFY(felt);
        for (const QString& name : {QStringLiteral("Right instrument"), QStringLiteral("Left instrument"),
                                    QStringLiteral("Instrument 3")})
            QVERIFY(plots.force().legendTexts().contains(name) && felt->legendTexts().contains(name) &&
                    plots.speed().legendTexts().contains(name));
        session::PlaybackMark& broken = track.marks.emplace_back();
        broken.t_s = broken.end_s = 0.5;
        broken.kind = session::mark_kinds::kYielded;
        broken.tool = 1;
        broken.critical = true;
        broken.value = 8.0;
        PlaybackPlots marked(theme, QLocale::c(), track, setup.level);
        QVERIFY(marked.force().legendTexts().contains(QStringLiteral("critical error")));
        if (const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES"); !folder.isEmpty()) {
            marked.resize(900, 620);
            marked.grab().save(folder + QStringLiteral("/playback_tools.png"));
        }
    }

    /// From when it happened to the end of that trial, and in no other.
    void tissueThatGaveWayIsMarkedInTheScene() {
        session::PlaybackTrack track = madeTrack(1, {{"tension_N", 1.0}});
        for (const auto& [t_s, trial, x_m] :
             {std::tuple{0.5, 0, 0.010}, std::tuple{1.0, 0, 0.020}, std::tuple{0.1, 1, 0.030}}) {
            session::PlaybackMark& mark = track.marks.emplace_back();
            mark.t_s = mark.end_s = t_s;
            mark.kind = session::mark_kinds::kYielded;
            mark.trial = trial;
            mark.p_W = core::Vec3(x_m, 0.0, 0.040);
        }
        track.marks[1].kind = session::mark_kinds::kCameOff; // an object of a study is crossed as well
        track.marks.emplace_back().kind = session::mark_kinds::kYielded; // nobody knows where
        const auto shown = [&](double t_s) { return sceneStateAt(track, nullptr, t_s).p_WYielded; };
        QVERIFY(shown(0.4).empty());
        QCOMPARE(shown(0.6).size(), std::size_t{1});
        QVERIFY(shown(0.6)[0] == core::Vec3(0.010, 0.0, 0.040));
        QCOMPARE(shown(1.9).size(), std::size_t{2});
    }

    void everyMarkOfGraspingHasWordsAndASign() {
        using namespace session::mark_kinds;
        std::set<QString> said;
        for (const session::PlaybackMarkKind& kind : {kGrasped, kReleased, kSlipped, kDamaged, kFailed}) {
            session::PlaybackMark mark;
            mark.kind = kind;
            QVERIFY(!session_report::markText(mark, tubeSetup(TubeTask::hold).level.exercise, QLocale::c())
                         .isEmpty() &&
                    !markIcon(kind).isEmpty());
            said.insert(
                session_report::markText(mark, tubeSetup(TubeTask::hold).level.exercise, QLocale::c()));
        }
        QCOMPARE(said.size(), std::size_t(5));
        QVERIFY(session::isPenalty(kSlipped) && session::isPenalty(kDamaged) && session::isPenalty(kFailed));
        QVERIFY(!session::isPenalty(kGrasped) && !session::isPenalty(kReleased));
    }

    void nothingWhereNothingIsGrasped() {
        session::SessionSetup setup;
        setup.level.exercise = "sphere_apex";
        setup.level.parameters = simulation::SphereApexParameters{};
        const auto layer = layerOf(setup);
        QVERIFY(!sceneStateAt(madeTrack(1, {{"tension_N", 1.0}}), nullptr, 1.0, layer.get())
                     .exercise.of<core::LaparoscopyCues>()
                     .present);
    }
};

QTEST_MAIN(TestGraspReview)
#include "test_grasp_review.moc"
