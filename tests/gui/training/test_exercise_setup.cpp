// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/training/training_bench.h"

#include "core/units.h"
#include "desktop/exercise_setup/exercise_setup_screen.h"
#include "support/patience.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>

using namespace chiron;
using namespace chiron::tests;
using desktop::ExerciseSetupScreen;

namespace {

QPushButton* tile(TrainingBench& bench, const QString& name) {
    auto* found = bench.desktop.find<QPushButton>(name);
    if (!found)
        qFatal("no %s", qPrintable(name));
    return found;
}

void open(TrainingBench& bench, const QVariantMap& more = {}) {
    QVariantMap parameters{{QStringLiteral("exercise"), QStringLiteral("sphere_apex")}};
    parameters.insert(more);
    bench.desktop.go(QStringLiteral("exercise_setup"), parameters);
}

ExerciseSetupScreen* screen(TrainingBench& bench) {
    return bench.desktop.screen<ExerciseSetupScreen>();
}

} // namespace

class TestExerciseSetup : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_NO_SOUND", "1"); }
    void startIsEnough();
    void enterStarts();
    void anExpertCanBeWatchedFirst();
    void saysWhatIsAskedFor();
    void recommendsTheNextLevel();
    void demonstrationIsNobodysScore();
    void faultsOfATraceAreNamedByRow();
    void aGoodTraceCanBeReplayed();
    void theWorkspaceIsRemembered();
    void aDemonstrationCanBeMountedOtherwise();
    void choicesSurviveANewLook();
    void anUnknownExerciseIsSaid();
};

void TestExerciseSetup::startIsEnough() {
    TrainingBench bench;
    open(bench);
    auto* start = tile(bench, QStringLiteral("setup.start"));
    QVERIFY(start->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(start->hasFocus(), kPatience_ms);
    start->click();
    QVERIFY(bench.at(QStringLiteral("training")));
    pressGo(bench.desktop);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(bench.screen()->feed()->training().pointer() != nullptr);
}

void TestExerciseSetup::enterStarts() {
    TrainingBench bench;
    open(bench);
    QTRY_VERIFY_WITH_TIMEOUT(tile(bench, QStringLiteral("setup.start"))->hasFocus(), kPatience_ms);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QVERIFY(bench.at(QStringLiteral("training")));
}

void TestExerciseSetup::anExpertCanBeWatchedFirst() {
    TrainingBench bench;
    open(bench, {{QStringLiteral("level"), 1}});
    auto* watch = tile(bench, QStringLiteral("setup.watch"));
    QVERIFY(watch->isVisibleTo(screen(bench)));
    tile(bench, QStringLiteral("setup.device.1"))->click();
    QVERIFY(!watch->isVisibleTo(screen(bench))); // Start watches already
    tile(bench, QStringLiteral("setup.device.0"))->click();
    tile(bench, QStringLiteral("setup.level.2"))->click();
    watch->setFocus();
    QTest::keyClick(watch, Qt::Key_Return); // the button that has the focus, and not Start
    QVERIFY(bench.at(QStringLiteral("training")));
    const desktop::TrainingPlan plan =
        desktop::TrainingPlan::fromMap(bench.desktop.context.navigator().current().parameters);
    QVERIFY(plan.movedBy(devices::MovedBy::scriptedOperator));
    QCOMPARE(plan.operatorName, QStringLiteral("expert"));
    QCOMPARE(plan.level, 2);
}

void TestExerciseSetup::saysWhatIsAskedFor() {
    TrainingBench bench;
    open(bench, {{QStringLiteral("level"), 1}});
    QVERIFY(bench.text("setup.objective").contains(QStringLiteral("highest point")));
    const QString gates = bench.text("setup.gates");
    QCOMPARE(gates.count(QLatin1Char('\n')), 3);
    QVERIFY2(gates.contains(QStringLiteral("at most 10 % of the radius")), qPrintable(gates));
    QVERIFY2(gates.contains(QStringLiteral("at most 2 s")), qPrintable(gates));
    QVERIFY(!bench.desktop.find<QLabel>(QStringLiteral("setup.note"))->isVisibleTo(screen(bench)));
    tile(bench, QStringLiteral("setup.level.2"))->click();
    QCOMPARE(screen(bench)->plan().level, 2);
    QVERIFY(bench.desktop.find<QLabel>(QStringLiteral("setup.note"))->isVisibleTo(screen(bench)));
    QVERIFY(bench.text("setup.note").contains(QStringLiteral("shown, not felt")));
}

void TestExerciseSetup::recommendsTheNextLevel() {
    TrainingBench bench;
    open(bench);
    const auto words = [&](int level) {
        return tile(bench, QStringLiteral("setup.level.%1").arg(level))->accessibleName();
    };
    QTRY_VERIFY_WITH_TIMEOUT(words(1).contains(QStringLiteral("recommended next")), kPatience_ms);
    QVERIFY(words(2).contains(QStringLiteral("Not tried yet")));
    QCOMPARE(screen(bench)->plan().level, 1);
    open(bench, {{QStringLiteral("level"), 3}}); // asked for: the recommendation does not change it
    QTRY_VERIFY_WITH_TIMEOUT(words(1).contains(QStringLiteral("recommended next")), kPatience_ms);
    QCOMPARE(screen(bench)->plan().level, 3);
}

void TestExerciseSetup::demonstrationIsNobodysScore() {
    TrainingBench bench;
    open(bench);
    tile(bench, QStringLiteral("setup.device.1"))->click();
    QVERIFY(screen(bench)->plan().movedBy(devices::MovedBy::scriptedOperator));
    QCOMPARE(screen(bench)->plan().operatorName, QStringLiteral("expert"));
    QCOMPARE(tile(bench, QStringLiteral("setup.start"))->text(), QStringLiteral("Watch"));
    tile(bench, QStringLiteral("setup.start"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().started, kPatience_ms);
    QVERIFY(
        bench.screen()->feed()->training().felt()); // a gimbal that renders force, with a script's hand on it
    const database::SessionId id = bench.screen()->feed()->training().sessionId();
    auto connection = bench.desktop.database().openReader();
    const auto record = database::SessionReader(**connection, bench.desktop.context.actor()).session(id);
    QVERIFY(record.has_value());
    QCOMPARE(record->summary.person, database::Actor::kSimulatedPerson);
    QCOMPARE(record->summary.operatorName, std::string("expert"));
}

void TestExerciseSetup::faultsOfATraceAreNamedByRow() {
    TrainingBench bench;
    const QString file = bench.desktop.folder() + QStringLiteral("/bad.csv");
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write("t_s,x_mm,y_mm,z_mm\n0,0,0,50\n0.01,0,zero,50\n");
    out.close();
    open(bench, {{QStringLiteral("device"), QStringLiteral("trace")}, {QStringLiteral("trace"), file}});
    QTRY_VERIFY2_WITH_TIMEOUT(bench.text("setup.trace.words").contains(QStringLiteral("cannot be played")),
                              qPrintable(bench.text("setup.trace.words")), kPatience_ms);
    QVERIFY2(bench.text("setup.trace.words").contains(QStringLiteral("bad.csv:3")),
             qPrintable(bench.text("setup.trace.words")));
    QVERIFY(!tile(bench, QStringLiteral("setup.start"))->isEnabled());
}

void TestExerciseSetup::aGoodTraceCanBeReplayed() {
    TrainingBench bench;
    const QString file = bench.desktop.folder() + QStringLiteral("/good.csv");
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write("t_s,x_mm,y_mm,z_mm\n");
    for (int n = 0; n <= 20; ++n)
        out.write(QByteArray::number(0.02 * n) + "," + QByteArray::number(0.5 * n) + ",0," +
                  QByteArray::number(50.0 - n) + "\n");
    out.close();
    open(bench, {{QStringLiteral("device"), QStringLiteral("trace")}, {QStringLiteral("trace"), file}});
    QTRY_VERIFY2_WITH_TIMEOUT(bench.text("setup.trace.words").contains(QStringLiteral("21 rows")),
                              qPrintable(bench.text("setup.trace.words")), kPatience_ms);
    tile(bench, QStringLiteral("setup.start"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms); // its end ends the session
}

void TestExerciseSetup::theWorkspaceIsRemembered() {
    TrainingBench bench;
    open(bench);
    tile(bench, QStringLiteral("setup.workspace"))->click();
    bench.desktop.find<QDoubleSpinBox>(QStringLiteral("setup.scale"))->setValue(1.5);
    bench.desktop.find<QDoubleSpinBox>(QStringLiteral("setup.origin_y"))->setValue(-4.0);
    bench.desktop.find<QAbstractButton>(QStringLiteral("setup.left"))->click();
    tile(bench, QStringLiteral("setup.start"))->click();
    pressGo(bench.desktop);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const devices::WorkspaceMapping mapping = bench.screen()->feed()->training().station().mappings().front();
    QCOMPARE(mapping.scale, 1.5);
    QCOMPARE(mapping.origin_m[1], -0.004);
    QVERIFY(mapping.leftHanded);
    const double x_m = bench.state().tool[0].p_WT_m[0];
    QTest::keyPress(bench.screen(), Qt::Key_Right); // right stays right
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().tool[0].p_WT_m[0] > x_m + 0.002, kPatience_ms);
    QTest::keyRelease(bench.screen(), Qt::Key_Right);
    bench.screen()->feed()->training().requestStop();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
    open(bench);
    QCOMPARE(screen(bench)->plan().workspace.scale, 1.5);
    QVERIFY(screen(bench)->plan().workspace.leftHanded);
}

// P2's flexible mounting: of a device that has a base, where its scripted hands know how it stands.
void TestExerciseSetup::aDemonstrationCanBeMountedOtherwise() {
    {
        TrainingBench bench;
        open(bench);
        auto* box = tile(bench, QStringLiteral("setup.workspace"))->parentWidget();
        tile(bench, QStringLiteral("setup.workspace"))->click();
        QVERIFY(!bench.desktop.find<QDoubleSpinBox>(QStringLiteral("setup.turn"))
                     ->isVisibleTo(screen(bench))); // a mouse has no base
        tile(bench, QStringLiteral("setup.device.1"))->click();
        QVERIFY(!box->isVisibleTo(screen(bench))); // the apex's hands take D for W
    }
    TrainingBench bench;
    open(bench, {{QStringLiteral("exercise"), QStringLiteral("object_handling")}});
    tile(bench, QStringLiteral("setup.device.1"))->click();
    tile(bench, QStringLiteral("setup.workspace"))->click();
    QVERIFY(bench.desktop.find<QDoubleSpinBox>(QStringLiteral("setup.turn"))->isVisibleTo(screen(bench)));
    QVERIFY(!bench.desktop.find<QDoubleSpinBox>(QStringLiteral("setup.scale"))->isVisibleTo(screen(bench)));
    bench.desktop.find<QDoubleSpinBox>(QStringLiteral("setup.turn"))->setValue(20.0);
    bench.desktop.find<QDoubleSpinBox>(QStringLiteral("setup.tilt"))->setValue(-10.0);
    tile(bench, QStringLiteral("setup.start"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().started, kPatience_ms);
    const auto expected =
        session::mappingOf({.turn_rad = {core::radFromDeg(20.0), core::radFromDeg(-10.0), 0.0}});
    const auto q_WD = bench.screen()->feed()->training().station().mappings().front().q_WD;
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(std::abs(q_WD[i] - expected->q_WD[i]) < 1e-12);
}

void TestExerciseSetup::choicesSurviveANewLook() {
    TrainingBench bench;
    open(bench);
    tile(bench, QStringLiteral("setup.level.3"))->click();
    tile(bench, QStringLiteral("setup.device.1"))->click();
    const QVariantMap before = screen(bench)->plan().toMap();
    bench.desktop.settings.setTheme(desktop::ThemeName::dark);
    bench.desktop.context.applyAppearance();
    QTRY_VERIFY_WITH_TIMEOUT(screen(bench), kPatience_ms);
    QCOMPARE(screen(bench)->plan().toMap(), before);
}

void TestExerciseSetup::anUnknownExerciseIsSaid() {
    TrainingBench bench;
    open(bench, {{QStringLiteral("exercise"), QStringLiteral("knitting")}});
    QVERIFY(!bench.desktop.find<QPushButton>(QStringLiteral("setup.start")));
    QVERIFY(screen(bench)->commands().empty());
}

QTEST_MAIN(TestExerciseSetup)
#include "test_exercise_setup.moc"
