// SPDX-License-Identifier: GPL-3.0-or-later
// A haptic station that is plugged in: offered on the set-up screen, held in training, stored with the
// session.
#include "gui/training/training_bench.h"

#include "database/repositories/session_reader.h"
#include "desktop/exercise_setup/exercise_setup_screen.h"
#include "desktop/widgets/state_panel.h"
#include "support/patience.h"
#include "support/station_bench.h"

#include <QComboBox>
#include <cmath>

using namespace chiron;
using namespace chiron::tests;
using desktop::ExerciseSetupScreen;

namespace {

/// Whether USB HID devices can be plugged in here that are not there.
bool g_hid = false;

#define SKIP_WITHOUT_HID()                                                                                   \
    if (!g_hid)                                                                                              \
    QSKIP("takes root and /dev/fuse")

void openSetup(TrainingBench& bench, const char* exercise, int level) {
    bench.desktop.go(QStringLiteral("exercise_setup"), {{QStringLiteral("exercise"), QLatin1String(exercise)},
                                                        {QStringLiteral("level"), level}});
}

/// The tile of connected devices, or null.
QPushButton* stationTile(TrainingBench& bench) {
    for (int i = 0;; ++i) {
        auto* tile = bench.desktop.find<QPushButton>(QStringLiteral("setup.device.%1").arg(i));
        if (!tile)
            return nullptr;
        if (tile->accessibleDescription().contains(QStringLiteral("connected")) ||
            tile->accessibleName().contains(QStringLiteral("connected")))
            return tile;
        for (const QLabel* label : tile->findChildren<QLabel*>())
            if (label->text().contains(QStringLiteral("connected")))
                return tile;
    }
}

template <class Widget> Widget* shown(TrainingBench& bench, const char* name) {
    QCoreApplication::processEvents(); // what was added to a layout is shown with the next events
    auto* found = bench.desktop.find<Widget>(QLatin1String(name));
    return found && found->isVisibleTo(bench.desktop.window.get()) ? found : nullptr;
}

/// Whether the trial runs. On a busy computer, a connection may be too slow for forces when it is opened; the
/// screen then says so, and a person tries again.
bool runsInTheEnd(TrainingBench& bench) {
    auto* panel = bench.screen() ? bench.screen()->findChild<desktop::StatePanel*>() : nullptr;
    if (panel && panel->state() == desktop::StatePanel::State::error) {
        const auto* words = panel->findChild<QLabel*>(QStringLiteral("state.text"));
        if (!words->text().contains(QStringLiteral("Use a faster connection")))
            qFatal("%s", qPrintable(words->text()));
        panel->findChild<QPushButton*>(QStringLiteral("state.action"))->click();
        bench.desktop.find<QPushButton>(QStringLiteral("setup.start"))->click();
        pressGo(bench.desktop);
    }
    // A sphere that is drawn where the hand is: force comes once the person wants it there.
    if (auto* here = bench.desktop.find<QPushButton>(QStringLiteral("training.resume_here"));
        here && here->isVisibleTo(bench.desktop.window.get()))
        here->click();
    // On a busy computer, samples may come too late for a force; then it is stopped until the person wants
    // it.
    if (bench.state().waitsFor == haptics::ArmingWait::rearm)
        bench.desktop.find<QPushButton>(QStringLiteral("training.main"))->click();
    return bench.runs();
}

/// Waits until the tool has been moved by the station's hand, and ends the session.
void holdAndEnd(TrainingBench& bench) {
    QTRY_VERIFY_WITH_TIMEOUT(runsInTheEnd(bench), kPatience_ms);
    QVERIFY(bench.screen()->feed()->training().pointer() == nullptr); // no mouse moves it
    QVERIFY(!shown<QLabel>(bench, "training.shown_force"));           // the force is felt
    const auto p_WT0_m = bench.state().tool[0].p_WT_m;
    const auto moved_m = [&] {
        const auto p_WT_m = bench.state().tool[0].p_WT_m;
        return std::hypot(p_WT_m[0] - p_WT0_m[0], p_WT_m[1] - p_WT0_m[1], p_WT_m[2] - p_WT0_m[2]);
    };
    QTRY_VERIFY_WITH_TIMEOUT(moved_m() > 5e-4, kPatience_ms);
    pressInQuestion("training.ask.end");
    bench.desktop.find<QPushButton>(QStringLiteral("training.end"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
}

} // namespace

class TestConnectedStation : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_NO_SOUND", "1"); }
    void nothingIsOfferedThatIsNotThere();
    void pluggedInAndHeld();
    void aDeviceForEachInstrument();
    void byItsAddress();
};

void TestConnectedStation::nothingIsOfferedThatIsNotThere() {
    SKIP_WITHOUT_HID();
    TrainingBench bench;
    openSetup(bench, "sphere_apex", 2);
    QVERIFY(!stationTile(bench));
}

void TestConnectedStation::pluggedInAndHeld() {
    SKIP_WITHOUT_HID();
    auto configuration = stationOn("gimbal_hprd");
    configuration.serialNumber = "G-7";
    const StationBench station(std::move(configuration), Wire::hid);
    TrainingBench bench;
    openSetup(bench, "sphere_apex", 2);
    QVERIFY(shown<QLabel>(bench, "setup.note")); // with the mouse, force is shown
    auto* tile = stationTile(bench);
    QVERIFY(tile);
    QVERIFY(!shown<QComboBox>(bench, "setup.connected.0"));
    tile->click();
    auto* choice = shown<QComboBox>(bench, "setup.connected.0");
    QVERIFY(choice);
    QCOMPARE(choice->currentText(), QStringLiteral("Emulated station, serial number G-7"));
    QVERIFY(!shown<QLabel>(bench, "setup.note"));
    auto* start = bench.desktop.find<QPushButton>(QStringLiteral("setup.start"));
    QVERIFY(start->isEnabled());
    start->click();
    QVERIFY(bench.at(QStringLiteral("training")));
    pressGo(bench.desktop);
    holdAndEnd(bench);
    auto reader = bench.desktop.site.database().openReader();
    const auto sessions = database::SessionReader(**reader, bench.desktop.context.actor()).listSessions({});
    QVERIFY(sessions && !sessions->empty());
    const auto stored =
        database::SessionReader(**reader, bench.desktop.context.actor()).session(sessions->front().id);
    QVERIFY(stored.has_value());
    QVERIFY2(stored->setup.deviceJson.find("\"station\"") != std::string::npos,
             stored->setup.deviceJson.c_str());
    QVERIFY2(stored->setup.deviceJson.find("G-7") != std::string::npos, stored->setup.deviceJson.c_str());
}

void TestConnectedStation::aDeviceForEachInstrument() {
    SKIP_WITHOUT_HID();
    HidComputer::plugIn(0, "L-1"); // nothing is behind it: it is only chosen
    const auto first = qScopeGuard([] { HidComputer::pullOut(0); });
    {
        TrainingBench bench;
        openSetup(bench, "elastic_tube", 4);
        stationTile(bench)->click();
        const auto* missing = shown<QLabel>(bench, "setup.connected.missing");
        QVERIFY(missing);
        QCOMPARE(shown<QLabel>(bench, "setup.summary")->text(), missing->text()); // beside Start, too
        QVERIFY(!bench.desktop.find<QPushButton>(QStringLiteral("setup.start"))->isEnabled());
    }
    HidComputer::plugIn(1, "R-2");
    const auto second = qScopeGuard([] { HidComputer::pullOut(1); });
    TrainingBench bench;
    openSetup(bench, "elastic_tube", 4);
    stationTile(bench)->click();
    QVERIFY(!shown<QLabel>(bench, "setup.connected.missing"));
    auto* right = shown<QComboBox>(bench, "setup.connected.0");
    auto* left = shown<QComboBox>(bench, "setup.connected.1");
    QVERIFY(right && left);
    const auto* start = bench.desktop.find<QPushButton>(QStringLiteral("setup.start"));
    QVERIFY(start->isEnabled());
    QVERIFY(!shown<QLabel>(bench, "setup.connected.same"));
    right->setCurrentIndex(1);
    QVERIFY(!start->isEnabled());
    QVERIFY(shown<QLabel>(bench, "setup.connected.same"));
    left->setCurrentIndex(0);
    QVERIFY(start->isEnabled());
    const desktop::TrainingPlan plan = bench.desktop.screen<ExerciseSetupScreen>()->plan();
    QCOMPARE(plan.addresses, QStringList({"hid:1209:0001:R-2", "hid:1209:0001:L-1"}));
    QCOMPARE(desktop::TrainingPlan::fromMap(plan.toMap()).addresses, plan.addresses);
}

// As a link or the command line might name it.
void TestConnectedStation::byItsAddress() {
    const StationBench station(stationOn("gimbal_hprd"), Wire::tcp);
    TrainingBench bench;
    bench.train({{QStringLiteral("device"), QStringLiteral("station")},
                 {QStringLiteral("addresses"), QStringList{QString::fromStdString(station.address)}}});
    holdAndEnd(bench);
}

int main(int argc, char** argv) {
    g_hid = HidComputer::enter() && station::HidrawNode::serve(HidComputer::kFolder).has_value();
    QApplication application(argc, argv);
    TestConnectedStation test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_connected_station.moc"
