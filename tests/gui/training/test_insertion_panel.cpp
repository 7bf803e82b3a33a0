// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/insertion_panel.h"
#include "desktop/training/force_bar.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/signed_bar.h"
#include "gui/training/posed_endoscope.h"
#include "support/painted_shapes.h"

#include <QAccessible>
#include <QLabel>
#include <QProgressBar>
#include <QtTest>
#include <functional>
#include <numbers>
#include <set>

using namespace chiron;
using namespace chiron::desktop;
using core::Vec3;
using simulation::ProcedureStage;
using tests::Posed;
using tests::posedAt;

namespace {

haptics::DisplayState stateOf(const Posed& posed, const core::Wrench& wrench_W) {
    haptics::DisplayState state;
    state.tools = 1;
    haptics::ToolDisplay& tool = state.tool[0];
    tool.p_WT_m = {posed.p_W.x(), posed.p_W.y(), posed.p_W.z()};
    tool.q_WT = {posed.q_WT.w(), posed.q_WT.x(), posed.q_WT.y(), posed.q_WT.z()};
    tool.tissue = core::toArray(wrench_W);
    return state;
}

/// Every name, value and description that a screen reader could read out.
QString spoken(QWidget& widget) {
    QString all;
    const std::function<void(QAccessibleInterface*)> walk = [&](QAccessibleInterface* at) {
        for (const QAccessible::Text part : {QAccessible::Name, QAccessible::Value, QAccessible::Description})
            all += at->text(part) + QLatin1Char('\n');
        for (int i = 0; i < at->childCount(); ++i)
            walk(at->child(i));
    };
    walk(QAccessible::queryAccessibleInterface(&widget));
    return all;
}

} // namespace

class TestInsertionPanel : public QObject {
    Q_OBJECT
private slots:
    void stagesInWords();
    void progressOnlyWhereItMayBeTold();
    void everyValueIsShown();
    void aLevelWithoutCuesTellsNothing();
    void aTraineeSeesWhatTheyNeed();
    void overTheLimitIsSaid();
    void fitsItsPlace();

private:
    Theme m_theme = Theme::load(ThemeName::light, 1.0).value();
    QLocale m_locale{QLocale::English};
};

void TestInsertionPanel::stagesInWords() {
    simulation::EndoscopeCues cues;
    cues.stage = ProcedureStage::insertion;
    cues.depth_m = 0.0324;
    StageTelling telling{true, true, 0.08};
    QCOMPARE(stageText(cues, telling, m_locale), QStringLiteral("Insertion: 32 of 80 mm"));
    telling.numbers = false;
    QVERIFY(!stageText(cues, telling, m_locale).contains(QRegularExpression(QStringLiteral("\\d"))));
    cues.stage = ProcedureStage::inspection;
    cues.landmarks = 4;
    cues.landmarksSeen = 0b1010;
    QCOMPARE(stageText(cues, telling, m_locale), QStringLiteral("Inspection: 2 of 4 landmarks seen"));
    cues.dwell = 0.4;
    QVERIFY(stageText(cues, telling, m_locale).contains(QStringLiteral("Hold still")));
    telling.guidance = false;
    QVERIFY(!stageText(cues, telling, m_locale).contains(QStringLiteral("Hold still")));
    cues.stage =
        ProcedureStage::withdrawal; // ends where the beak is out, too: said, and the bar is full only there
    cues.depth_m = -0.006;
    telling.clear_m = 0.010;
    QVERIFY(!stageText(cues, telling, m_locale).contains(QRegularExpression(QStringLiteral("\\d"))));
    telling.numbers = true;
    QVERIFY(stageText(cues, telling, m_locale).endsWith(QStringLiteral("4 mm more")));
    QVERIFY(stageProgress(cues, telling) < 1.0 && stageProgress(cues, telling) > 0.9);
    cues.depth_m = -0.010;
    QCOMPARE(stageProgress(cues, telling), 1.0);
    std::set<QString> titles;
    for (int stage = 0; stage <= int(ProcedureStage::completed); ++stage)
        titles.insert(stageTitle(static_cast<ProcedureStage>(stage)));
    QCOMPARE(titles.size(), std::size_t{5});
}

void TestInsertionPanel::progressOnlyWhereItMayBeTold() {
    simulation::EndoscopeCues cues;
    cues.stage = ProcedureStage::insertion;
    cues.depth_m = 0.02;
    QCOMPARE(stageProgress(cues, {true, false, 0.08}), 0.25);
    QVERIFY(stageProgress(cues, {false, true, 0.08}) < 0.0);
    cues.stage = ProcedureStage::inspection;
    cues.dwell = 0.5;
    QCOMPARE(stageProgress(cues, {false, true, 0.08}), 0.5);
    QVERIFY(stageProgress(cues, {true, false, 0.08}) < 0.0);
}

void TestInsertionPanel::everyValueIsShown() {
    const simulation::UrethraInsertionParameters p;
    InsertionPanel panel(m_theme, m_locale, {.bars = true, .numbers = true, .plots = true, .guidance = true},
                         p);
    const Posed posed = posedAt(p, 0.05, 0.001 * Vec3::UnitX(), 0.1, 0.0);
    haptics::DisplayState state =
        stateOf(posed, {p.pose.vectorToW(Vec3(0.5, 0.25, -1.0)), p.pose.vectorToW(Vec3(0.02, 0.0, 0.0))});
    state.exercise.own<simulation::EndoscopeCues>().stage = ProcedureStage::insertion;
    state.exercise.own<simulation::EndoscopeCues>().depth_m = 0.05;
    session::LiveSample sample;
    sample.t_s = 1.0;
    sample.phase = core::TrialPhase::running;
    for (std::size_t i = 0; i < 3; ++i)
        sample.p_WT_m[i] = static_cast<float>(state.tool[0].p_WT_m[i]);
    for (std::size_t i = 0; i < 4; ++i)
        sample.q_WT[i] = static_cast<float>(state.tool[0].q_WT[i]);
    panel.show(state, {&sample, 1});
    const auto text = [&](const char* name) { return panel.findChild<QLabel*>(QLatin1String(name))->text(); };
    QCOMPARE(text("training.depth"), QStringLiteral("50.0"));
    QCOMPARE(text("training.offset"), QStringLiteral("1.0"));
    QCOMPARE(text("training.alignment"), QStringLiteral("5.7")); // 0.1 rad
    QCOMPARE(text("training.tip_x"), QStringLiteral("1.0"));
    QVERIFY(text("training.stage").startsWith(QStringLiteral("Insertion: 50 of")));
    const auto bar = [&](const char* name) {
        return panel.findChild<SignedBar*>(QLatin1String(name))->value();
    };
    QVERIFY(std::abs(bar("training.force_x") - 0.5) < 1e-9);
    QVERIFY(std::abs(bar("training.force_z") + 1.0) < 1e-9);
    QVERIFY(std::abs(bar("training.torque_x") - 20.0) < 1e-6);
    const auto highest = [&](const char* name) {
        return panel.findChild<LivePlot*>(QLatin1String(name))->trace().highest();
    };
    QVERIFY(std::abs(highest("training.offset_plot") - 1.0) < 1e-3);
    QVERIFY(std::abs(highest("training.alignment_plot") - 0.1 * 180.0 / std::numbers::pi) < 1e-2);
    QVERIFY(spoken(panel).contains(QStringLiteral("0.50 N")));
    state.exercise.own<simulation::EndoscopeCues>().depth_m = 0.06;
    for (int frame = 0; frame < 5; ++frame)
        panel.show(state, {});
    QVERIFY(text("training.stage")
                .startsWith(QStringLiteral("Insertion: 50 of"))); // digits that can be read stand for a while
    panel.show(state, {});
    QVERIFY(text("training.stage").startsWith(QStringLiteral("Insertion: 60 of")));
}

void TestInsertionPanel::aLevelWithoutCuesTellsNothing() {
    const simulation::UrethraInsertionParameters p;
    InsertionPanel panel(m_theme, m_locale, {.object = true}, p);
    haptics::DisplayState state =
        stateOf(posedAt(p, 0.05, 0.001 * Vec3::UnitX()), {Vec3(9.0, 9.0, 9.0), Vec3(1.0, 1.0, 1.0)});
    state.exercise.own<simulation::EndoscopeCues>().stage = ProcedureStage::insertion;
    state.exercise.own<simulation::EndoscopeCues>().depth_m = 0.05;
    state.exercise.own<simulation::EndoscopeCues>().dwell = 0.5;
    panel.show(state, {});
    QVERIFY(panel.findChildren<ForceBar*>().isEmpty());
    QVERIFY(panel.findChildren<SignedBar*>().isEmpty());
    QVERIFY(panel.findChildren<LivePlot*>().isEmpty());
    QVERIFY(panel.findChildren<QProgressBar*>().isEmpty());
    QVERIFY(panel.findChild<QLabel*>(QStringLiteral("training.no_cues")));
    QString words = spoken(panel);
    words.remove(panel.findChild<QLabel*>(QStringLiteral("training.elapsed"))->text());
    QVERIFY2(!words.contains(QRegularExpression(QStringLiteral("\\d"))), qPrintable(words));
    QVERIFY(!words.contains(QStringLiteral("limit")));
}

/// Who learns sees depth, place and two plots; an expert also the six components; lost samples are
/// everybody's business.
void TestInsertionPanel::aTraineeSeesWhatTheyNeed() {
    const simulation::UrethraInsertionParameters p;
    InsertionPanel panel(m_theme, m_locale, {.bars = true, .numbers = true, .plots = true, .guidance = true},
                         p);
    const auto shown = [&](const char* name) {
        auto* part = panel.findChild<QWidget*>(QLatin1String(name));
        return part && part->isVisibleTo(&panel);
    };
    const std::array needed{"training.stage",      "training.resistance_bar", "training.lateral_bar",
                            "training.depth",      "training.offset",         "training.alignment",
                            "training.force_plot", "training.offset_plot"};
    const std::array details{"training.force_x",  "training.force_y",      "training.force_z",
                             "training.torque_x", "training.torque_y",     "training.torque_z",
                             "training.tip_x",    "training.lateral_plot", "training.alignment_plot",
                             "training.loop"};
    QVERIFY(!panel.detailed());
    for (const bool detailed : {false, true, false}) {
        panel.setDetailed(detailed);
        for (const char* name : needed)
            QVERIFY2(shown(name), name);
        for (const char* name : details)
            QVERIFY2(shown(name) == detailed, name);
    }
    haptics::DisplayState state;
    state.lateTicks = 198;
    panel.show(state, {});
    QVERIFY(!shown("training.loop"));
    state.droppedFrames = 1;
    for (int frame = 0; frame < 7; ++frame)
        panel.show(state, {});
    QVERIFY(shown("training.loop"));
}

void TestInsertionPanel::overTheLimitIsSaid() {
    SignedBar bar(
        m_theme, m_locale,
        {QStringLiteral("Tz"), QStringLiteral("Torque about the axis"), QStringLiteral("mN·m"), 10.0, 1},
        true, true);
    bar.setValue(-9.9);
    bar.speak();
    QVERIFY(!bar.isOver());
    QCOMPARE(bar.accessibleDescription(), QStringLiteral("-9.9 mN·m"));
    bar.setValue(-10.1);
    QVERIFY(bar.isOver());
    QVERIFY(bar.accessibleDescription().contains(QStringLiteral("over the limit")));
    bar.setValue(std::nan(""));
    QCOMPARE(bar.value(), -10.1);
    bar.resize(120, 40);
    const auto filled = [&](Qt::BrushStyle style, const QColor& colour) {
        QRectF all;
        for (const tests::PaintedShape& shape : tests::PaintedShapes::of(bar))
            if (shape.kind == tests::PaintedShape::Kind::rect && shape.brush.style() == style &&
                shape.brush.color() == colour && !shape.drawn())
                all |= shape.bounds;
        return all;
    };
    const QRectF over = filled(Qt::SolidPattern, m_theme.color(Colour::bad));
    QVERIFY2(over.right() <= 60.0 && over.left() < 30.0 && over.height() > 5.0, // to the left alone
             qPrintable(QStringLiteral("%1 to %2").arg(over.left()).arg(over.right())));
    QCOMPARE(filled(Qt::BDiagPattern, m_theme.color(Colour::surface)), over); // not shown by colour alone
    QVERIFY(filled(Qt::SolidPattern, m_theme.color(Colour::seriesA)).isNull());
    bar.setValue(9.9);
    const QRectF within = filled(Qt::SolidPattern, m_theme.color(Colour::seriesA));
    QVERIFY2(within.left() >= 59.0 && within.right() > 90.0, qPrintable(QString::number(within.left())));
    QVERIFY(filled(Qt::BDiagPattern, m_theme.color(Colour::surface)).isNull());
}

/// At a small window nothing of it is wider than its place, at either end of the scale.
void TestInsertionPanel::fitsItsPlace() {
    const simulation::UrethraInsertionParameters p;
    for (const double scale : {1.0, 2.0}) {
        const Theme theme = Theme::load(ThemeName::light, scale).value();
        InsertionPanel panel(theme, m_locale,
                             {.bars = true, .numbers = true, .plots = true, .guidance = true}, p);
        panel.setStyleSheet(theme.styleSheet());
        const int place_px = scale == 1.0 ? 372 : 537; // 0.42 of 1280
        QVERIFY2(panel.minimumSizeHint().width() <= place_px - 14,
                 qPrintable(QString::number(panel.minimumSizeHint().width())));
    }
}

QTEST_MAIN(TestInsertionPanel)
#include "test_insertion_panel.moc"
