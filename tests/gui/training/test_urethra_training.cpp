// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/training/training_bench.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "support/settled.h"

#include "app/exercises/urethra_insertion/desktop/insertion_values.h"
#include "desktop/training/force_bar.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/signed_bar.h"
#include "support/patience.h"

#include <QAccessible>
#include <QCheckBox>
#include <QProgressBar>
#include <functional>
#include <map>

using namespace chiron;
using namespace chiron::tests;
using database::SessionState;
using simulation::ProcedureStage;

namespace {

QVariantMap urethra(int level) {
    return {{QStringLiteral("exercise"), QStringLiteral("urethra_insertion")},
            {QStringLiteral("level"), level}};
}

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

/// Steers by keys as a person does: the view is kept along the canal.
class KeyPilot {
public:
    KeyPilot(TrainingBench& bench, const simulation::UrethraInsertionParameters& p)
        : m_bench(bench), m_gauge(p), m_p(p) {}

    void hold(Qt::Key key, bool down) {
        if (down == m_held[key])
            return;
        m_held[key] = down;
        down ? QTest::keyPress(m_bench.screen(), key) : QTest::keyRelease(m_bench.screen(), key);
    }
    /// One look at the picture: the angle between view and canal, in the plane of symmetry, is kept small.
    void steer() {
        const haptics::ToolDisplay tool = m_bench.state().tool[0];
        const core::Quat q(tool.q_WT[0], tool.q_WT[1], tool.q_WT[2], tool.q_WT[3]);
        const core::Vec3 axis_A = m_p.pose.vectorToA(q * core::Vec3(0.0, 0.0, -1.0));
        const simulation::UrethraCentreline line(m_p.anatomy);
        const double wanted =
            line.foot(m_p.pose.pointToA({tool.p_WT_m[0], tool.p_WT_m[1], tool.p_WT_m[2]})).at.psi_rad;
        const double error = wanted - std::atan2(axis_A.y(), axis_A.z());
        hold(Qt::Key_Up, error > 0.02);
        hold(Qt::Key_Down, error < -0.02);
    }
    ProcedureStage stage() { return m_bench.state().exercise.of<simulation::EndoscopeCues>().stage; }

private:
    TrainingBench& m_bench;
    desktop::InsertionGauge m_gauge;
    const simulation::UrethraInsertionParameters& m_p;
    std::map<int, bool> m_held;
};

const simulation::UrethraInsertionParameters& parametersOf(TrainingBench& bench, int level) {
    return bench.desktop.site.catalogue()
        .find("urethra_insertion", level)
        ->parameters.as<simulation::UrethraInsertionParameters>();
}

} // namespace

class TestUrethraTraining : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_NO_SOUND", "1"); }
    void aWholeProcedureByKeys();
    void mouseAndWheelMoveIt();
    void startAgainBringsItBack();
    void depthOfFieldIsASwitch();
    void aLevelMayFixIt();
    void theUnguidedLevelTellsNothing();
    void demonstrated();
    void fitsSmallWindowsAndLargeText();
};

void TestUrethraTraining::aWholeProcedureByKeys() {
    TrainingBench bench;
    bench.train(urethra(1));
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(bench.text("training.keys").contains(QStringLiteral("Advance")));
    QVERIFY(bench.text("training.trial").isEmpty()); // of one there is nothing to count
    KeyPilot pilot(bench, parametersOf(bench, 1));
    pilot.hold(Qt::Key_W, true);
    QTRY_VERIFY_WITH_TIMEOUT((pilot.steer(), pilot.stage() == ProcedureStage::insertion), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(bench.text("training.stage").startsWith(QStringLiteral("Insertion: ")),
                             kPatience_ms);
    QVERIFY(bench.desktop.find<QProgressBar>(QStringLiteral("training.stage_progress"))->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT((pilot.steer(), pilot.stage() == ProcedureStage::withdrawal), kPatience_ms);
    pilot.hold(Qt::Key_W, false);
    QVERIFY(bench.desktop.find<desktop::LivePlot>(QStringLiteral("training.force_plot"))->trace().highest() >
            0.0); // the canal resists
    pilot.hold(Qt::Key_S, true);
    QTRY_VERIFY_WITH_TIMEOUT(
        (bench.at(QStringLiteral("training")) ? pilot.steer() : void(), bench.at(QStringLiteral("debrief"))),
        kPatience_ms);
    const auto id =
        bench.desktop.context.navigator().current().parameters.value(QStringLiteral("session")).toLongLong();
    auto connection = bench.desktop.database().openReader();
    const auto record = database::SessionReader(**connection, bench.desktop.context.actor()).session(id);
    QVERIFY(record.has_value());
    QVERIFY(record->summary.state == SessionState::completed);
    QVERIFY(!record->summary.felt);
    QCOMPARE(record->summary.dropped, std::uint64_t{0});
}

void TestUrethraTraining::mouseAndWheelMoveIt() {
    TrainingBench bench;
    bench.train(urethra(1));
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const haptics::ToolDisplay before = bench.state().tool[0];
    bench.wheel(480);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().tool[0].p_WT_m[1] > before.p_WT_m[1] + 0.005,
                             kPatience_ms); // into the patient
    bench.sweepTo({0, -60});                // upwards
    const auto pitch = [&] {
        const auto q = bench.state().tool[0].q_WT;
        const core::Vec3 axis_W = core::Quat(q[0], q[1], q[2], q[3]) * core::Vec3(0.0, 0.0, -1.0);
        return std::atan2(axis_W.z(), axis_W.y());
    };
    QTRY_VERIFY_WITH_TIMEOUT(pitch() > 0.05, kPatience_ms);
    bench.click(); // nothing is marked
    QTest::qWait(100);
    QVERIFY(bench.runs());
}

void TestUrethraTraining::startAgainBringsItBack() {
    TrainingBench bench;
    bench.train(urethra(1));
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const auto start = bench.state().tool[0].p_WT_m;
    const database::SessionId first = bench.screen()->feed()->training().sessionId();
    bench.wheel(480);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().tool[0].p_WT_m[1] > start[1] + 0.005, kPatience_ms);
    bench.key(Qt::Key_F); // its depth of field as the person has it
    bench.key(Qt::Key_F5);
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen() && bench.screen()->feed() &&
                                 bench.screen()->feed()->training().sessionId() > first,
                             kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(std::abs(bench.state().tool[0].p_WT_m[1] - start[1]) < 1e-5);
    QVERIFY(bench.state().exercise.of<simulation::EndoscopeCues>().stage == ProcedureStage::outside);
    QVERIFY(bench.desktop.find<QCheckBox>(QStringLiteral("training.depth_of_field"))->isChecked());
}

void TestUrethraTraining::depthOfFieldIsASwitch() {
    TrainingBench bench;
    bench.train(urethra(1));
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    auto* box = bench.desktop.find<QCheckBox>(QStringLiteral("training.depth_of_field"));
    QVERIFY(box && box->isEnabled() && !box->isChecked());
    bench.key(Qt::Key_F);
    QVERIFY(box->isChecked());
    box->click();
    QVERIFY(!box->isChecked());
    QTest::qWait(200); // the scene goes on with the other graph
    QVERIFY(bench.runs());
}

void TestUrethraTraining::aLevelMayFixIt() {
    TrainingBench bench;
    bench.train(urethra(5));
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    auto* box = bench.desktop.find<QCheckBox>(QStringLiteral("training.depth_of_field"));
    QVERIFY(!box->isEnabled() && box->isChecked());
    QVERIFY(box->text().contains(QStringLiteral("this level keeps it on")));
    bench.key(Qt::Key_F);
    QVERIFY(box->isChecked());
}

void TestUrethraTraining::theUnguidedLevelTellsNothing() {
    TrainingBench bench;
    bench.train(urethra(5));
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    KeyPilot pilot(bench, parametersOf(bench, 5));
    pilot.hold(Qt::Key_W, true);
    QTRY_VERIFY_WITH_TIMEOUT(
        (pilot.steer(), pilot.stage() == ProcedureStage::insertion &&
                            bench.state().exercise.of<simulation::EndoscopeCues>().depth_m > 0.01),
        kPatience_ms);
    pilot.hold(Qt::Key_W, false);
    const session::LevelCues cues =
        session::cuesOf(*bench.desktop.site.catalogue().find("urethra_insertion", 5), false);
    QVERIFY(!cues.numbers && !cues.guidance && !cues.overview);
    desktop::TrainingScreen& screen = *bench.screen();
    QVERIFY(screen.findChildren<desktop::SignedBar*>().isEmpty());
    QVERIFY(screen.findChildren<desktop::LivePlot*>().isEmpty());
    QVERIFY(screen.findChildren<QProgressBar*>().isEmpty());
    const QString words = spoken(screen);
    for (const char* word : {" mm", "mN", "Off-centre", "Alignment", "Depth (", "Tip x"})
        QVERIFY2(!words.contains(QLatin1String(word)), word);
    QVERIFY(!bench.text("training.stage").contains(QRegularExpression(QStringLiteral("\\d"))));
}

void TestUrethraTraining::demonstrated() {
    TrainingBench bench;
    QVariantMap plan = urethra(1);
    plan.insert(QStringLiteral("device"), QStringLiteral("demonstration"));
    plan.insert(QStringLiteral("operator"), QStringLiteral("expert"));
    bench.train(plan);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(bench.text("training.device").contains(QStringLiteral("five-bar")));
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().exercise.of<simulation::EndoscopeCues>().stage ==
                                 ProcedureStage::insertion,
                             kPatience_ms);
    QVERIFY(bench.desktop.find<desktop::ForceBar>(QStringLiteral("training.lateral_bar")));
}

void TestUrethraTraining::fitsSmallWindowsAndLargeText() {
    for (const double scale : {1.0, 2.0}) {
        TrainingBench bench;
        bench.desktop.settings.setScale(scale);
        bench.desktop.context.applyAppearance();
        bench.desktop.window->resize(1280, 720);
        bench.train(urethra(1));
        QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
        QTest::qWait(300);
        QCOMPARE(bench.desktop.window->size(),
                 QSize(1280, 720)); // a screen must not force the window to grow
        const QStringList findings = settledFindings(bench.screen());
        QVERIFY2(findings.isEmpty(), qPrintable(findings.join(QLatin1Char('\n'))));
        bench.screen()->feed()->training().requestStop();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.desktop.context.trialRuns(), kPatience_ms);
    }
}

QTEST_MAIN(TestUrethraTraining)
#include "test_urethra_training.moc"
