// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "desktop/training/force_bar.h"
#include "desktop/training/insertion_panel.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/signed_bar.h"

#include <QAccessible>
#include <QLabel>
#include <QProgressBar>
#include <QtTest>
#include <functional>
#include <numbers>
#include <set>

using namespace chiron;
using namespace chiron::desktop;
using core::ProcedureStage;
using core::Vec3;

namespace {

/// An endoscope at a place of the canal, `off` beside it and tilted about x and then about the turned y.
struct Posed {
    Vec3 p_W;
    core::Quat q_WT;
    Vec3 axis_A, y_A; ///< looks along; y′
};

Posed pose(const simulation::UrethraInsertionParameters& p, double s_m, const Vec3& off_A = Vec3::Zero(), double tiltX_rad = 0.0,
           double tiltY_rad = 0.0) {
    const simulation::UrethraCentreline line(p.anatomy.curvature_per_m, p.anatomy.zEnd_m);
    const simulation::CentrelinePoint at = line.at(s_m);
    const double pitch = at.psi_rad + tiltX_rad;
    const Vec3 z(0.0, std::sin(pitch), std::cos(pitch));
    Posed posed;
    posed.y_A = Vec3(0.0, std::cos(pitch), -std::sin(pitch));
    posed.axis_A = std::sin(tiltY_rad) * Vec3::UnitX() + std::cos(tiltY_rad) * z;
    posed.p_W = p.pose.pointToW(at.p_A + off_A);
    posed.q_WT = core::Quat::FromTwoVectors(-Vec3::UnitZ(), p.pose.vectorToW(posed.axis_A));
    return posed;
}

simulation::UrethraInsertionParameters rotatedScene() {
    simulation::UrethraInsertionParameters p;
    p.pose.p_WA = Vec3(0.1, -0.2, 0.05);
    p.pose.q_WA = core::Quat(0.4, -0.3, 0.7, 0.2).normalized();
    return p;
}

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
    void aPerfectPoseReadsZero();
    void distanceAndAngle();
    void alongAndAcross();
    void torquesAreP1s();
    void theSceneMayStandAnywhere();
    void stagesInWords();
    void progressOnlyWhereItMayBeTold();
    void everyValueIsShown();
    void aLevelWithoutCuesTellsNothing();
    void overTheLimitIsSaid();
    void fitsItsPlace();

private:
    Theme m_theme = Theme::load(ThemeName::light, 1.0).value();
    QLocale m_locale{QLocale::English};
};

void TestInsertionPanel::aPerfectPoseReadsZero() {
    const simulation::UrethraInsertionParameters p;
    const InsertionGauge gauge(p);
    for (const double s_m : {-0.02, 0.0, 0.02, 0.06, 0.12}) {
        const Posed posed = pose(p, s_m);
        const InsertionValues v = gauge.at(posed.p_W, posed.q_WT, {});
        QVERIFY(std::abs(v.depth_m - s_m) < 1e-9);
        QVERIFY(v.offset_m < 1e-9);
        QVERIFY(v.alignment_rad < 1e-7);
        QCOMPARE(v.resistance_N, 0.0);
    }
    QVERIFY(std::abs(gauge.goal_m() - gauge.length_m() - 0.010) < 1e-12);
    simulation::UrethraInsertionParameters shallow;
    shallow.goalDepth_m = 0.035;
    QCOMPARE(InsertionGauge(shallow).goal_m(), 0.035);
}

void TestInsertionPanel::distanceAndAngle() {
    const simulation::UrethraInsertionParameters p;
    const simulation::CentrelinePoint at = simulation::UrethraCentreline(p.anatomy.curvature_per_m, p.anatomy.zEnd_m).at(0.05);
    const Posed posed = pose(p, 0.05, 0.002 * Vec3::UnitX() + 0.001 * at.n_A, 0.2, 0.0);
    const InsertionValues v = InsertionGauge(p).at(posed.p_W, posed.q_WT, {});
    QVERIFY(std::abs(v.offset_m - std::sqrt(5.0) * 1e-3) < 1e-9);
    QVERIFY(std::abs(v.depth_m - 0.05) < 1e-9); // beside the line, not farther along it
    QVERIFY(std::abs(v.alignment_rad - 0.2) < 1e-9);
    QVERIFY((v.tip_A_m - (at.p_A + 0.002 * Vec3::UnitX() + 0.001 * at.n_A)).norm() < 1e-12);
}

void TestInsertionPanel::alongAndAcross() {
    const simulation::UrethraInsertionParameters p;
    const simulation::CentrelinePoint at = simulation::UrethraCentreline(p.anatomy.curvature_per_m, p.anatomy.zEnd_m).at(0.08);
    const Posed posed = pose(p, 0.08);
    const Vec3 force_A = -2.0 * at.t_A + 1.5 * at.n_A - 2.0 * Vec3::UnitX();
    const InsertionValues v = InsertionGauge(p).at(posed.p_W, posed.q_WT, {p.pose.vectorToW(force_A), Vec3::Zero()});
    QVERIFY(std::abs(v.resistance_N - 2.0) < 1e-9); // pushes out: above zero
    QVERIFY(std::abs(v.lateral_N - 2.5) < 1e-9);
    QVERIFY((v.force_A_N - force_A).norm() < 1e-12);
}

/// The torque of P1's three put together as a wrench (models.md §1.2) and taken apart again.
void TestInsertionPanel::torquesAreP1s() {
    const simulation::UrethraInsertionParameters p;
    const InsertionGauge gauge(p);
    core::Random random(11);
    for (int n = 0; n < 200; ++n) {
        const double tiltY = 1.0 * (random.uniform() - 0.5);
        const Posed posed = pose(p, 0.02 + 0.1 * random.uniform(), Vec3::Zero(), random.uniform() - 0.5, tiltY);
        const Vec3 t_Nm(0.15 * (random.uniform() - 0.5), 0.15 * (random.uniform() - 0.5), 0.01 * (random.uniform() - 0.5));
        const Vec3 z_A = (posed.axis_A - std::sin(tiltY) * Vec3::UnitX()) / std::cos(tiltY); // z″
        const Vec3 torque_A = t_Nm.x() * Vec3::UnitX() + t_Nm.y() * posed.y_A - t_Nm.x() * std::tan(tiltY) * z_A + t_Nm.z() * posed.axis_A;
        const InsertionValues v = gauge.at(posed.p_W, posed.q_WT, {Vec3::Zero(), p.pose.vectorToW(torque_A)});
        QVERIFY((v.torque_Nm - t_Nm).norm() < 1e-9);
    }
}

void TestInsertionPanel::theSceneMayStandAnywhere() {
    const simulation::UrethraInsertionParameters here;
    const simulation::UrethraInsertionParameters there = rotatedScene();
    const Vec3 off(0.001, -0.002, 0.0005);
    const Vec3 force_A(0.3, -0.6, -1.1);
    const Vec3 torque_A(0.02, -0.03, 0.004);
    std::array<InsertionValues, 2> values;
    for (const auto* p : {&here, &there}) {
        const Posed posed = pose(*p, 0.07, off, 0.1, -0.2);
        values[p == &there] = InsertionGauge(*p).at(posed.p_W, posed.q_WT, {p->pose.vectorToW(force_A), p->pose.vectorToW(torque_A)});
    }
    QVERIFY((values[0].tip_A_m - values[1].tip_A_m).norm() < 1e-12);
    QVERIFY((values[0].force_A_N - values[1].force_A_N).norm() < 1e-12);
    QVERIFY((values[0].torque_Nm - values[1].torque_Nm).norm() < 1e-9);
    QVERIFY(std::abs(values[0].alignment_rad - values[1].alignment_rad) < 1e-9);
    QVERIFY(std::abs(values[0].offset_m - values[1].offset_m) < 1e-12);
}

void TestInsertionPanel::stagesInWords() {
    core::EndoscopeCues cues;
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
    std::set<QString> titles;
    for (int stage = 0; stage <= int(ProcedureStage::completed); ++stage)
        titles.insert(stageTitle(static_cast<ProcedureStage>(stage)));
    QCOMPARE(titles.size(), std::size_t{5});
}

void TestInsertionPanel::progressOnlyWhereItMayBeTold() {
    core::EndoscopeCues cues;
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
    InsertionPanel panel(m_theme, m_locale, {.bars = true, .numbers = true, .plots = true, .guidance = true}, p);
    const Posed posed = pose(p, 0.05, 0.001 * Vec3::UnitX(), 0.1, 0.0);
    haptics::DisplayState state = stateOf(posed, {p.pose.vectorToW(Vec3(0.5, 0.25, -1.0)), p.pose.vectorToW(Vec3(0.02, 0.0, 0.0))});
    state.endoscope.stage = ProcedureStage::insertion;
    state.endoscope.depth_m = 0.05;
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
    const auto bar = [&](const char* name) { return panel.findChild<SignedBar*>(QLatin1String(name))->value(); };
    QVERIFY(std::abs(bar("training.force_x") - 0.5) < 1e-9);
    QVERIFY(std::abs(bar("training.force_z") + 1.0) < 1e-9);
    QVERIFY(std::abs(bar("training.torque_x") - 20.0) < 1e-6);
    const auto highest = [&](const char* name) { return panel.findChild<LivePlot*>(QLatin1String(name))->trace().highest(); };
    QVERIFY(std::abs(highest("training.offset_plot") - 1.0) < 1e-3);
    QVERIFY(std::abs(highest("training.alignment_plot") - 0.1 * 180.0 / std::numbers::pi) < 1e-2);
    QVERIFY(spoken(panel).contains(QStringLiteral("0.50 N")));
}

void TestInsertionPanel::aLevelWithoutCuesTellsNothing() {
    const simulation::UrethraInsertionParameters p;
    InsertionPanel panel(m_theme, m_locale, {.object = true}, p);
    haptics::DisplayState state = stateOf(pose(p, 0.05, 0.001 * Vec3::UnitX()), {Vec3(9.0, 9.0, 9.0), Vec3(1.0, 1.0, 1.0)});
    state.endoscope.stage = ProcedureStage::insertion;
    state.endoscope.depth_m = 0.05;
    state.endoscope.dwell = 0.5;
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

void TestInsertionPanel::overTheLimitIsSaid() {
    SignedBar bar(m_theme, m_locale, {QStringLiteral("Tz"), QStringLiteral("Torque about the axis"), QStringLiteral("mN·m"), 10.0, 1}, true, true);
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
    QPixmap picture(bar.size());
    bar.render(&picture);
    QVERIFY(picture.toImage().pixelColor(30, 32) != picture.toImage().pixelColor(90, 32)); // filled to the left alone
}

/// At a small window nothing of it is wider than its place, at either end of the scale.
void TestInsertionPanel::fitsItsPlace() {
    const simulation::UrethraInsertionParameters p;
    for (const double scale : {1.0, 2.0}) {
        const Theme theme = Theme::load(ThemeName::light, scale).value();
        InsertionPanel panel(theme, m_locale, {.bars = true, .numbers = true, .plots = true, .guidance = true}, p);
        panel.setStyleSheet(theme.styleSheet());
        const int place_px = scale == 1.0 ? 372 : 537; // 0.42 of 1280
        QVERIFY2(panel.minimumSizeHint().width() <= place_px - 14, qPrintable(QString::number(panel.minimumSizeHint().width())));
    }
}

QTEST_MAIN(TestInsertionPanel)
#include "test_insertion_panel.moc"
