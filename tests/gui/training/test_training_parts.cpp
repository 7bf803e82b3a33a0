// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/tool_state.h"
#include "desktop/training/column_trace.h"
#include "desktop/training/force_words.h"
#include "desktop/training/info_panel.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/pointer_control.h"
#include "desktop/training/scene_pointer.h"
#include "desktop/training/training_plan.h"
#include "desktop/widgets/kit.h"
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"
#include "support/painted_shapes.h"

#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTemporaryDir>
#include <QWindow>
#include <QtTest>
#include <set>

using namespace chiron;
using namespace chiron::desktop;

namespace {

/// The frame of a panel, around nothing.
class BarePanel final : public InfoView {
public:
    BarePanel(const Theme& theme, bool measures) : InfoView(theme, {}, nullptr) {
        addHead(kit::label(theme, QStringLiteral("words")));
        addFoot({}, measures);
    }
    QString text(const char* name) const {
        const auto* label = findChild<QLabel*>(QLatin1String(name));
        return label ? label->text() : QString();
    }
    int moved = 0;
    int read = 0;

protected:
    void showMoving(const haptics::DisplayState&, std::span<const session::LiveSample>) override { ++moved; }
    void showReadings(const haptics::DisplayState&) override { ++read; }
};

/// A driver beside the usual one, which says that it was asked.
devices::Driver anotherDriver(devices::MovedBy movedBy) {
    devices::Driver driver = devices::usualDriver(movedBy);
    driver.id = "another";
    driver.open = [](devices::DriverRequest) -> core::Result<std::vector<devices::DriverTool>> {
        return core::fail(core::ErrorCode::device, "the other driver was asked");
    };
    return driver;
}

} // namespace

class TestTrainingParts : public QObject {
    Q_OBJECT
private slots:
    void everyPeakStays();
    void theOldLeavesAndGapsStayEmpty();
    void traceIgnoresNonsense();
    void aPlotIsQuicklyPainted();
    void pixelsBecomeMetres();
    void aPointerLedBackMakesNoJump();
    void inAWideSceneNeither();
    void theSamePathEndsAtTheSamePlace();
    void aMovementOutOfTheSceneIsNotLost();
    void onlyACapturedPointerIsLedBackWhenItLeaves();
    void heldKeysBecomeASpeed();
    void everyStateHasItsWords();
    void lateUpdatesAreToldAsAShare();
    void aPanelCountsTheTimeWorked();
    void aPanelSaysWhereNothingIsMeasured();
    void aPlanComesBackFromItsPlace();
    void theChosenDriverIsAsked();
};

void TestTrainingParts::everyPeakStays() {
    core::Random random(7);
    ColumnTrace trace(10.0);
    std::vector<std::pair<double, double>> samples;
    for (int n = 0; n < 25'000; ++n) {
        const double value = random.uniform() < 0.001 ? 9.0 + random.uniform() : random.uniform();
        samples.emplace_back(n * 1e-3, value);
        trace.add(n * 1e-3, value);
    }
    for (const std::size_t count : {std::size_t{1}, std::size_t{37}, std::size_t{260}, std::size_t{2048}}) {
        const std::vector<ColumnRange> columns = trace.columns(count);
        QCOMPARE(columns.size(), count);
        double most = 0.0;
        double least = 10.0;
        for (const ColumnRange& column : columns) {
            QVERIFY(column.any);
            most = std::max(most, column.highest);
            least = std::min(least, column.lowest);
        }
        double wantedMost = 0.0;
        double wantedLeast = 10.0;
        for (const auto& [t, value] : samples) {
            if (t <= trace.newest_s() - 10.0 + 0.01)
                continue;
            wantedMost = std::max(wantedMost, value);
            wantedLeast = std::min(wantedLeast, value);
        }
        QVERIFY(most >= wantedMost && least <= wantedLeast);
        // Each peak is in the column of its time, or beside it.
        for (const auto& [t, value] : samples) {
            if (value < 9.0 || t < trace.newest_s() - 9.9)
                continue;
            const auto at = static_cast<std::ptrdiff_t>((t - trace.newest_s() + 10.0) / 10.0 *
                                                        static_cast<double>(count));
            bool seen = false;
            for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(at - 1, 0);
                 i <= at + 1 && i < static_cast<std::ptrdiff_t>(count); ++i)
                seen = seen || columns[static_cast<std::size_t>(i)].highest >= value;
            QVERIFY(seen);
        }
    }
}

void TestTrainingParts::theOldLeavesAndGapsStayEmpty() {
    ColumnTrace trace(10.0);
    trace.add(0.5, 5.0);
    trace.add(1.0, 1.0);
    QCOMPARE(trace.highest(), 5.0);
    trace.add(10.7, 2.0); // 0.5 s lies more than the span back
    QCOMPARE(trace.highest(), 2.0);
    int filled = 0;
    for (const ColumnRange& column : trace.columns(100))
        filled += column.any ? 1 : 0;
    QCOMPARE(filled, 2);
    QVERIFY(trace.columns(100).back().any);
    trace.add(40.0, 3.0); // a gap longer than the span
    QCOMPARE(trace.highest(), 3.0);
    trace.clear();
    QCOMPARE(trace.highest(), 0.0);
}

void TestTrainingParts::traceIgnoresNonsense() {
    ColumnTrace trace(10.0);
    trace.add(std::nan(""), 1.0);
    trace.add(1.0, std::nan(""));
    trace.add(-1.0, 1.0);
    QCOMPARE(trace.highest(), 0.0);
    trace.add(100.0, 1.0);
    trace.add(1.0, 9.0); // long past
    QCOMPARE(trace.highest(), 1.0);
    for (double old_s = 90.0; old_s > 89.9; old_s -= 0.001)
        trace.add(old_s, 9.0); // a span back: its cell is the newest one's today
    QCOMPARE(trace.highest(), 1.0);
}

/// Prints; the time is a machine's.
void TestTrainingParts::aPlotIsQuicklyPainted() {
    const Theme theme = Theme::load(ThemeName::light, 1.0).value();
    LivePlot plot(theme, QLocale::c(), QStringLiteral("Force (N)"), 5.0, 4.0);
    core::Random random(3);
    for (int n = 0; n < 10'000; ++n)
        plot.add(n * 1e-3, 5.0 * random.uniform());
    plot.resize(270, 120);
    QPixmap picture(plot.size());
    plot.render(&picture);
    QElapsedTimer timer;
    timer.start();
    constexpr int kPictures = 200;
    for (int n = 0; n < kPictures; ++n)
        plot.render(&picture);
    qInfo("%.3f ms a picture of 270 x 120", 1e-6 * static_cast<double>(timer.nsecsElapsed()) / kPictures);
    const std::vector<tests::PaintedShape> shapes = tests::PaintedShapes::of(plot);
    const auto upright = std::count_if(shapes.begin(), shapes.end(), [](const tests::PaintedShape& shape) {
        return shape.kind == tests::PaintedShape::Kind::line && shape.bounds.width() == 0.0;
    });
    QVERIFY2(upright > 150, qPrintable(QString::number(upright))); // the signal: a line for each column
}

void TestTrainingParts::pixelsBecomeMetres() {
    devices::PointerMailbox mailbox;
    PointerControl hand(mailbox, 2.0);
    hand.drag({100.0, 40.0}, false);
    QCOMPARE(mailbox.read().moved[0], 0.005);  // 100 pixels at 200 %
    QCOMPARE(mailbox.read().moved[1], -0.002); // down on the screen: towards the person
    hand.drag({100.0, 40.0}, true);
    QCOMPARE(mailbox.read().moved[0], 0.005);
    QCOMPARE(mailbox.read().moved[2], -0.002);
    hand.wheel(-120);
    QCOMPARE(mailbox.read().moved[2], -0.004);
    hand.click();
    hand.click();
    QCOMPARE(mailbox.read().markPresses, 2u);
    QCOMPARE(mailbox.read().held, 0u);
    PointerControl left(mailbox, 1.0, true);
    left.drag({50.0, 0.0}, false);
    QCOMPARE(mailbox.read().moved[0], 0.0); // mirrored workspace: right stays right in the scene
}

/// The pointer nears the edge and is led back to the middle; events of before still come, then the first from
/// the middle. The tool only ever moves as the hand did.
void TestTrainingParts::aPointerLedBackMakesNoJump() {
    devices::PointerMailbox mailbox;
    PointerControl hand(mailbox, 1.0);
    QWidget area;
    area.resize(800, 600);
    ScenePointer pointer(hand, area, area);
    const auto moveTo = [&](double x) {
        QMouseEvent event(QEvent::MouseMove, QPointF(x, 300.0), QPointF(x, 300.0), Qt::NoButton, Qt::NoButton,
                          Qt::NoModifier);
        QApplication::sendEvent(&area, &event);
        return mailbox.read().moved[0] / PointerControl::kMetresPerPixel;
    };
    QCOMPARE(moveTo(100.0), 0.0); // free: nobody's hand
    pointer.capture();
    QCOMPARE(moveTo(600.0), 0.0);                 // where it is when it is captured
    QVERIFY(qFuzzyCompare(moveTo(690.0), 90.0));  // near the edge: led back from here on
    QVERIFY(qFuzzyCompare(moveTo(720.0), 120.0)); // of before, on its way
    QVERIFY(qFuzzyCompare(moveTo(410.0), 130.0)); // arrived at 400, moved on by 10
    QVERIFY(qFuzzyCompare(moveTo(400.0), 120.0)); // a movement over the middle is a movement
    QVERIFY(qFuzzyCompare(moveTo(500.0), 220.0));
    pointer.release();
    QVERIFY(qFuzzyCompare(moveTo(100.0), 220.0));
}

/// Above and below the middle of a wide scene there is less room than beside it.
void TestTrainingParts::inAWideSceneNeither() {
    devices::PointerMailbox mailbox;
    PointerControl hand(mailbox, 1.0);
    QWidget area;
    area.resize(1600, 400);
    ScenePointer pointer(hand, area, area);
    const auto moveTo = [&](double y) {
        QMouseEvent event(QEvent::MouseMove, QPointF(800.0, y), QPointF(800.0, y), Qt::NoButton, Qt::NoButton,
                          Qt::NoModifier);
        QApplication::sendEvent(&area, &event);
        return -mailbox.read().moved[1] / PointerControl::kMetresPerPixel; // down on the screen
    };
    pointer.capture();
    QCOMPARE(moveTo(300.0), 0.0);
    QVERIFY(qFuzzyCompare(moveTo(345.0), 45.0)); // near the lower edge: led back from here on
    QVERIFY(qFuzzyCompare(moveTo(205.0), 50.0)); // arrived at 200, moved on by 5
    QVERIFY(qFuzzyCompare(moveTo(255.0), 100.0));
}

/// In one event or in many: nothing is cut off of a large one, and the driver follows all of it.
void TestTrainingParts::theSamePathEndsAtTheSamePlace() {
    std::vector<std::array<std::int32_t, 2>> ends;
    for (const int events : {1, 50}) {
        auto device = devices::KeyboardMouseDevice::create({.following_s = 0.025});
        QVERIFY(device && (*device)->open());
        PointerControl hand((*device)->mailbox(), 1.0);
        QWidget area;
        area.resize(1000, 800);
        ScenePointer pointer(hand, area, area);
        pointer.capture();
        realtime::TickSource ticks;
        core::DeviceSample sample;
        for (int i = 0; i <= events; ++i) {
            const QPointF at = QPointF(300.0, 250.0) + QPointF(400.0, 300.0) * i / events;
            QMouseEvent event(QEvent::MouseMove, at, at, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
            QApplication::sendEvent(&area, &event);
            sample = (*device)->read(ticks.next(0));
        }
        for (int tick = 0; tick < 500; ++tick) // until it has caught up
            sample = (*device)->read(ticks.next(0));
        ends.push_back({sample.counts[0], sample.counts[1]});
    }
    QVERIFY(std::abs(ends[0][0] - ends[1][0]) <= 1 &&
            std::abs(ends[0][1] - ends[1][1]) <= 1); // of a grid of 1 um
    QVERIFY(std::abs(ends[0][0] - 40'000) <= 1);     // 400 pixels
}

/// So quick that the next event is outside of the scene: its window tells of it.
void TestTrainingParts::aMovementOutOfTheSceneIsNotLost() {
    devices::PointerMailbox mailbox;
    PointerControl hand(mailbox, 1.0);
    QWidget window;
    window.resize(900, 400);
    QWidget area(&window);
    area.setGeometry(0, 0, 600, 400);
    QPushButton beside(&window);
    beside.setGeometry(650, 0, 200, 400);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    ScenePointer pointer(hand, area, area);
    int marks = 0, clicks = 0;
    connect(&pointer, &ScenePointer::marked, &window, [&marks] { ++marks; });
    connect(&beside, &QPushButton::clicked, &window, [&clicks] { ++clicks; });
    const auto send = [&](QEvent::Type type, double x, Qt::MouseButton button = Qt::NoButton) {
        const QPointF at(x, 200.0);
        QMouseEvent event(type, at, window.mapToGlobal(at), button,
                          type == QEvent::MouseButtonPress ? Qt::MouseButtons(button) : Qt::NoButton,
                          Qt::NoModifier);
        QApplication::sendEvent(window.windowHandle(), &event);
        return mailbox.read().moved[0] / PointerControl::kMetresPerPixel;
    };
    pointer.capture();
    send(QEvent::MouseMove, 300.0); // where it is
    QVERIFY(qFuzzyCompare(send(QEvent::MouseMove, 320.0), 20.0));
    QVERIFY(qFuzzyCompare(send(QEvent::MouseMove, 740.0), 440.0)); // over the button beside the scene
    send(QEvent::MouseButtonPress, 740.0, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, 740.0, Qt::LeftButton);
    QVERIFY(marks == 1 &&
            clicks == 0); // a captured pointer marks, and presses nothing that it happens to be over
    pointer.release();
    QVERIFY(qFuzzyCompare(send(QEvent::MouseMove, 800.0), 440.0));
}

/// A pointer that is nobody's hand, or whose window is not the one in front, goes where it likes.
void TestTrainingParts::onlyACapturedPointerIsLedBackWhenItLeaves() {
    devices::PointerMailbox mailbox;
    PointerControl hand(mailbox, 1.0);
    QWidget area;
    area.resize(300, 200);
    area.show();
    area.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&area));
    ScenePointer pointer(hand, area, area);
    const QPoint away = area.mapToGlobal(QPoint(5, 5));
    const auto left = [&] {
        QCursor::setPos(away);
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&area, &leave);
        return QCursor::pos();
    };
    QCOMPARE(left(), away);
    pointer.capture();
    QCOMPARE(left(), area.mapToGlobal(area.rect().center()));
    QWidget other;
    other.show();
    other.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&other));
    QCOMPARE(left(), away);
}

void TestTrainingParts::heldKeysBecomeASpeed() {
    devices::PointerMailbox mailbox;
    PointerControl hand(mailbox, 1.0);
    QVERIFY(hand.keyDown(Qt::Key_Left) && hand.keyDown(Qt::Key_PageUp));
    QVERIFY(!hand.keyDown(Qt::Key_A));
    const double v = PointerControl::kKeySpeed_m_per_s;
    QVERIFY((mailbox.read().rate_per_s == std::array{-v, 0.0, v, 0.0}));
    hand.keyDown(Qt::Key_Right);
    QCOMPARE(mailbox.read().rate_per_s[0], 0.0);
    hand.keyUp(Qt::Key_Left);
    QCOMPARE(mailbox.read().rate_per_s[0], v);
    hand.releaseKeys();
    QVERIFY((mailbox.read().rate_per_s == std::array{0.0, 0.0, 0.0, 0.0}));
}

/// Every update is recorded, late or not: no count of thousandths that reads like an error.
void TestTrainingParts::lateUpdatesAreToldAsAShare() {
    haptics::DisplayState state;
    state.tick = 60'000;
    QCOMPARE(InfoPanel::loopText(state), QStringLiteral("Recording complete; every force update on time"));
    state.lateTicks = 1125;
    QCOMPARE(InfoPanel::loopText(state),
             QStringLiteral("Recording complete; nothing is lost. 1.88 % of the force updates came late."));
    state.lateTicks = 1;
    QVERIFY(InfoPanel::loopText(state).contains(QStringLiteral("0.01 %")));
}

void TestTrainingParts::aPanelCountsTheTimeWorked() {
    const Theme theme = Theme::load(ThemeName::light, 1.0).value();
    BarePanel panel(theme, true);
    QCOMPARE(panel.text("training.elapsed"), QStringLiteral("Elapsed: 0:00"));
    std::vector<session::LiveSample> samples(62'000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].phase = i < 1000 ? core::TrialPhase::idle : core::TrialPhase::between;
        samples[i].paused = i >= 2000 && i < 2900;
    }
    panel.show({}, samples); // 60.1 s: neither before the first trial nor paused
    QCOMPARE(panel.text("training.elapsed"), QStringLiteral("Elapsed: 1:00"));
    for (int frame = 1; frame <= 6; ++frame)
        panel.show({}, std::span(samples).subspan(2900, 1000));
    QCOMPARE(panel.text("training.elapsed"), QStringLiteral("Elapsed: 1:06"));
    QCOMPARE(panel.moved, 7); // in every frame
    QCOMPARE(panel.read, 2);  // in the first and the seventh
}

void TestTrainingParts::aPanelSaysWhereNothingIsMeasured() {
    const Theme theme = Theme::load(ThemeName::light, 1.0).value();
    QVERIFY(BarePanel(theme, false).text("training.no_cues").contains(QStringLiteral("no measurements")));
    BarePanel panel(theme, true);
    QVERIFY(panel.text("training.no_cues").isEmpty());
    const auto* loop = panel.findChild<QLabel*>(QStringLiteral("training.loop"));
    QVERIFY(loop && loop->isHidden()); // a detail
    haptics::DisplayState state;
    state.droppedFrames = 3;
    panel.show(state, {});
    QVERIFY(!loop->isHidden()); // unless samples are lost
    panel.setDetailed(true);
    QVERIFY(!loop->isHidden());
}

void TestTrainingParts::everyStateHasItsWords() {
    using core::ForceState;
    using haptics::ArmingWait;
    std::set<QString> titles;
    const auto words = [&](ForceState force, ArmingWait wait, AskedFor asked = {}) {
        haptics::DisplayState state;
        state.started = true;
        state.force = force;
        state.waitsFor = wait;
        const ForceWords said = forceWords(state, asked, QLocale::c());
        titles.insert(said.title);
        return said;
    };
    for (int force = 0; force <= static_cast<int>(ForceState::heldByHeartbeat); ++force)
        for (int wait = 0; wait <= static_cast<int>(ArmingWait::rearm); ++wait) {
            const ForceWords said = words(static_cast<ForceState>(force), static_cast<ArmingWait>(wait));
            QVERIFY(!said.title.isEmpty() && !said.text.isEmpty());
        }
    QVERIFY(titles.size() >= 8);
    QCOMPARE(words(ForceState::off, ArmingWait::nothing, {.felt = false}).title,
             QStringLiteral("Shown, not felt"));
    QCOMPARE(
        words(ForceState::off, ArmingWait::nothing, {.felt = false, .paused = true, .stopped = true}).title,
        QStringLiteral("Force is stopped"));
    QCOMPARE(words(ForceState::arming, ArmingWait::smallRequest).title,
             QStringLiteral("Force is not on yet"));
    QVERIFY(words(ForceState::ramping, ArmingWait::ramp, {.ownHand = false})
                .text.contains(QStringLiteral("rises")));
    QVERIFY(words(ForceState::on, ArmingWait::nothing, {.ownHand = false})
                .text.contains(QStringLiteral("not felt")));
    QCOMPARE(words(ForceState::on, ArmingWait::nothing).title, QStringLiteral("Force is on"));
}

void TestTrainingParts::aPlanComesBackFromItsPlace() {
    TrainingPlan plan;
    plan.exercise = QStringLiteral("sphere_apex");
    plan.level = 3;
    plan.driver = &devices::usualDriver(devices::MovedBy::recording);
    plan.operatorName = QStringLiteral("novice");
    plan.traceFile = QStringLiteral("/a/b.csv");
    plan.workspace = {.scale = 1.5, .origin_m = {0.01, -0.02, 0.03}, .leftHanded = true};
    plan.familiarisation = true;
    const TrainingPlan again = TrainingPlan::fromMap(plan.toMap());
    QCOMPARE(again.toMap(), plan.toMap());
    QCOMPARE(TrainingPlan::fromMap({}).workspace.scale, 1.0);
    QVERIFY(TrainingPlan::fromMap({{QStringLiteral("device"), QStringLiteral("lathe")}}).ownHand());
}

void TestTrainingParts::theChosenDriverIsAsked() {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QVERIFY(catalogue.has_value());
    QTemporaryDir folder;
    QFile trace(folder.filePath(QStringLiteral("hand.csv")));
    QVERIFY(trace.open(QIODevice::WriteOnly));
    trace.write("t_s,x_mm,y_mm,z_mm\n0,0,0,50\n1,0,0,50\n");
    trace.close();
    TrainingPlan plan;
    plan.exercise = QStringLiteral("sphere_apex");
    plan.operatorName = QStringLiteral("expert");
    plan.traceFile = trace.fileName();
    const catalogue::ExerciseLevel& level = *catalogue->find("sphere_apex", 1);
    for (const devices::MovedBy mover :
         {devices::MovedBy::person, devices::MovedBy::scriptedOperator, devices::MovedBy::recording}) {
        plan.driver = &devices::usualDriver(mover);
        const auto usual = desktop::requestOf(plan, level);
        QVERIFY2(usual.has_value(), usual ? "" : usual.error().message.c_str());
        const devices::Driver another = anotherDriver(mover);
        plan.driver = &another;
        const auto asked = desktop::requestOf(plan, level);
        QVERIFY(!asked);
        QVERIFY2(asked.error().message.ends_with("the other driver was asked"),
                 asked.error().message.c_str());
    }
}

QTEST_MAIN(TestTrainingParts)
#include "test_training_parts.moc"
