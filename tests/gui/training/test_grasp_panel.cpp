// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/desktop/tube_grasping.h"
#include "app/exercises/object_handling/desktop/handling_grasping.h"
#include "desktop/training/force_bar.h"
#include "desktop/training/grasp_panel.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/target_bar.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "session_report/tool_words.h"

#include <QLabel>
#include <QProgressBar>
#include <QtTest>
#include <set>

using namespace chiron;
using namespace chiron::desktop;
using core::LaparoscopyStep;
using simulation::TubeTask;

namespace {

haptics::DisplayState pulling(double tension_N) {
    haptics::DisplayState state;
    state.tools = 2;
    state.tool[0].tissue[0] = -tension_N;
    state.tool[1].tissue[0] = tension_N;
    state.tool[0].p_WProxy_m = {0.0312, -0.004, 0.05};
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    cues.present = cues.tube = cues.objectShown = cues.tensionShown = true;
    cues.grips = 2;
    cues.gripHeldBy = {2, 1, 0};
    cues.step = LaparoscopyStep::hold;
    cues.dwell = 0.42;
    cues.stretch_m = 0.0123;
    cues.tension_N = tension_N;
    cues.bandLow_N = 1.0;
    cues.bandHigh_N = 1.3;
    return state;
}

} // namespace

class TestGraspPanel : public QObject {
    Q_OBJECT
private slots:
    void everyStepHasItsOwnWords() {
        simulation::ElasticTubeParameters tube;
        simulation::ObjectHandlingParameters handling;
        std::set<QString> said;
        for (int step = 0; step <= core::kLastLaparoscopyStep; ++step) {
            core::LaparoscopyCues cues;
            cues.step = static_cast<LaparoscopyStep>(step);
            for (const TubeTask task :
                 {TubeTask::hold, TubeTask::stretch, TubeTask::twoHanded, TubeTask::transfer}) {
                tube.task = task;
                QVERIFY(!tubeGrasping(tube, {}).step(cues, QLocale(QLocale::English)).isEmpty());
            }
            QVERIFY(!handlingGrasping(handling, {}).step(cues, QLocale(QLocale::English)).isEmpty());
            said.insert(tubeGrasping(tube, {}).step(cues, QLocale(QLocale::English)));
        }
        QCOMPARE(said.size(), std::size_t(10)); // of a transfer: one each
        core::LaparoscopyCues over;
        over.step = LaparoscopyStep::place;
        session::LevelLimits limits;
        limits.others = {
            {"placement_error", 5.0}}; // who sets it down knows how far from the middle is too far
        QVERIFY(handlingGrasping(handling, limits)
                    .step(over, QLocale(QLocale::English))
                    .contains(QStringLiteral("5 mm")));
        core::LaparoscopyCues torn;
        torn.torn = true;
        QVERIFY(
            tubeGrasping(tube, {}).step(torn, QLocale(QLocale::English)).contains(QStringLiteral("torn")));
    }

    void everyValueIsShown() {
        simulation::ElasticTubeParameters tube;
        tube.task = TubeTask::twoHanded;
        GraspPanel panel(m_theme, QLocale::c(), allCues(), tubeGrasping(tube, {}));
        panel.show(pulling(1.12), {});
        QCOMPARE(find<TargetBar>(panel, "training.tension_bar")->words(),
                 QStringLiteral("1.12 N, in the band"));
        QVERIFY(find<ForceBar>(panel, "training.force_bar_0") &&
                find<ForceBar>(panel, "training.force_bar_1"));
        QCOMPARE(find<QProgressBar>(panel, "training.dwell")->value(), 42);
        QVERIFY(find<QLabel>(panel, "training.load")->text().contains(QStringLiteral("12.3")));
        QCOMPARE(find<QLabel>(panel, "training.tool_0_0")->text(), QStringLiteral("31.2"));
        QVERIFY(find<QLabel>(panel, "training.tool_1_3") != nullptr);
        QVERIFY(find<QLabel>(panel, "training.held")->text().contains(QStringLiteral("two points")));
        QVERIFY(find<LivePlot>(panel, "training.tension_plot") &&
                !find<LivePlot>(panel, "training.force_plot"));
    }

    void aFoldHasABarOfItsOwn() {
        simulation::ElasticTubeParameters tube;
        tube.task = TubeTask::twoHanded;
        tube.foldStiffness_N_per_m = 25.0;
        GraspPanel panel(m_theme, QLocale::c(), allCues(), tubeGrasping(tube, {}));
        haptics::DisplayState state = pulling(1.12);
        state.tools = 3;
        state.tool[2].tissue[1] = -0.8;
        core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
        cues.fold = cues.foldOpen = cues.retractionShown = true;
        cues.foldHeldBy = 4;
        cues.retraction_N = 0.8;
        cues.retractionLow_N = 0.6;
        cues.retractionHigh_N = 1.0;
        panel.show(state, {});
        QCOMPARE(find<TargetBar>(panel, "training.retraction_bar")->words(),
                 QStringLiteral("0.80 N, in the band"));
        QVERIFY(find<ForceBar>(panel, "training.force_bar_2") && find<QLabel>(panel, "training.tool_2_3"));
        QVERIFY(find<QLabel>(panel, "training.held")->text().contains(QStringLiteral("fold")));
        simulation::ElasticTubeParameters without;
        GraspPanel other(m_theme, QLocale::c(), allCues(), tubeGrasping(without, {}));
        QVERIFY(!find<TargetBar>(other, "training.retraction_bar"));
    }

    void bandAndLimitAreSaid() {
        TargetBar bar(m_theme, QLocale::c(), {QStringLiteral("Tension"), QStringLiteral("N"), 3.0, 2}, true);
        bar.setValue(0.4);
        QCOMPARE(bar.words(), QStringLiteral("0.40 N"));
        bar.setBand(1.0, 1.3);
        QCOMPARE(bar.accessibleDescription(), QStringLiteral("0.40 N, below the band"));
        bar.setValue(1.5);
        QCOMPARE(bar.words(), QStringLiteral("1.50 N, above the band"));
        bar.setLimit(1.4);
        QCOMPARE(bar.words(), QStringLiteral("1.50 N, over the limit"));
        bar.setValue(std::nan(""));
        QCOMPARE(bar.words(), QStringLiteral("1.50 N, over the limit"));
        TargetBar blind(m_theme, QLocale::c(), {QStringLiteral("Tension"), QStringLiteral("N"), 3.0, 2},
                        false);
        blind.setBand(1.0, 1.3);
        blind.setValue(1.1);
        QCOMPARE(blind.words(), QStringLiteral("in the band"));
    }

    /// Name and words never overlap: where the width has no room for both, the bar has a second line, for all
    /// that it may say and not only for what it says now.
    void nameAndWordsHaveRoom() {
        const QString name = QStringLiteral("Right index finger: squeeze of the jaw");
        const auto heightAt = [](QWidget& bar, int width) {
            bar.resize(width, bar.sizeHint().height());
            bar.grab(); // delivers the resize event of a widget that is not shown
            return bar.sizeHint().height();
        };
        const QFontMetrics metrics(m_theme.font(TextStyle::label));
        const auto roomFor = [&](const QString& words) {
            return metrics.horizontalAdvance(name) + metrics.horizontalAdvance(words);
        };
        TargetBar target(m_theme, QLocale::c(), {name, QStringLiteral("N"), 5.0, 2}, true);
        target.setLimit(4.0);
        target.setValue(0.5);
        ForceBar force(m_theme, QLocale::c(), {name, QStringLiteral("N"), 4.0, 2}, true);
        for (QWidget* bar : {static_cast<QWidget*>(&target), static_cast<QWidget*>(&force)}) {
            const int line = heightAt(*bar, 1000);
            QCOMPARE(heightAt(*bar, roomFor(QStringLiteral("0.50 N")) + 30) - line, metrics.height());
            QVERIFY(heightAt(*bar, roomFor(QStringLiteral("5.00 N, over the limit"))) > line);
            QCOMPARE(heightAt(*bar, roomFor(QStringLiteral("5.00 N, over the limit")) + 30), line);
        }
    }

    void aLevelWithoutCuesTellsNothing() {
        simulation::ObjectHandlingParameters handling;
        GraspPanel panel(m_theme, QLocale::c(), {}, handlingGrasping(handling, {}));
        haptics::DisplayState state = pulling(1.12);
        state.exercise.own<core::LaparoscopyCues>().tube = false;
        panel.show(state, {});
        QVERIFY(panel.findChildren<TargetBar*>().isEmpty() && panel.findChildren<ForceBar*>().isEmpty());
        QVERIFY(panel.findChildren<LivePlot*>().isEmpty() && panel.findChildren<QProgressBar*>().isEmpty());
        QVERIFY(find<QLabel>(panel, "training.no_cues") != nullptr);
        for (const QLabel* label : panel.findChildren<QLabel*>())
            QVERIFY2(!label->text().contains(QStringLiteral("1.12")), qPrintable(label->text()));
    }

    void whatIsHeldIsSaid() {
        simulation::ObjectHandlingParameters handling;
        core::LaparoscopyCues cues;
        cues.bodies = 3;
        QVERIFY(handlingGrasping(handling, {}).held(cues, QLocale::c()).contains(QStringLiteral("nothing")));
        cues.body[1].heldBy = 1;
        QVERIFY(handlingGrasping(handling, {})
                    .held(cues, QLocale::c())
                    .contains(QStringLiteral("object 2 of 3")));
        QVERIFY(session_report::instrumentName(0, 2) != session_report::instrumentName(1, 2));
    }

private:
    static session::LevelCues allCues() {
        session::LevelCues cues;
        cues.object = cues.tool = cues.arrow = cues.bars = cues.numbers = cues.plots = true;
        return cues;
    }
    template <class W> static W* find(QWidget& in, const char* name) {
        return in.findChild<W*>(QLatin1String(name));
    }

    Theme m_theme = Theme::load(ThemeName::light, 1.0).value();
};

QTEST_MAIN(TestGraspPanel)
#include "test_grasp_panel.moc"
