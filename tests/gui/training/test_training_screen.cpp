// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/training/training_bench.h"

#include "desktop/training/force_bar.h"
#include "desktop/training/live_plot.h"
#include "desktop/widgets/state_panel.h"
#include "haptics/safety_settings.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>
#include <QWindow>

using namespace chiron;
using namespace chiron::tests;
using core::TrialPhase;
using database::SessionState;

namespace {

database::SessionRecord recordOf(TrainingBench& bench, database::SessionId id, const database::Actor& actor) {
    auto connection = bench.desktop.database().openReader();
    auto record = database::SessionReader(**connection, actor).session(id);
    if (!record)
        qFatal("%s", record.error().message.c_str());
    return *record;
}

/// How old the window's newest sign of life ever was, by what is recorded.
std::uint32_t longestSilence_ms(TrainingBench& bench, database::SessionId id) {
    const OpenStored stored(bench.desktop.database(), id);
    const auto frames = stored.session->reader().allFrames();
    if (!frames)
        qFatal("%s", frames.error().message.c_str());
    std::uint32_t longest_ms = 0;
    for (const core::HapticFrame& frame : *frames)
        longest_ms = std::max<std::uint32_t>(longest_ms, frame.header.heartbeatAge_ms);
    return longest_ms;
}

} // namespace

namespace {
/// The longest time for which the event loop did not turn since this was made.
class LongestGap {
public:
    LongestGap() {
        m_since.start();
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer,
                         [this] { m_longest_ms = milliseconds(), m_since.restart(); });
        m_timer.start(10);
    }
    qint64 milliseconds() const { return std::max(m_longest_ms, m_since.elapsed()); }

private:
    QTimer m_timer;
    QElapsedTimer m_since;
    qint64 m_longest_ms = 0;
};
} // namespace

class TestTrainingScreen : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_NO_SOUND", "1"); }
    void aWholeSetWithTheMouse();
    void measurementsAreThePersons();
    void onlyKeys();
    void aSecondPressMarksNothing();
    void keysWhileTheSceneHasTheFocus();
    void aDialogPauses();
    void pauseAndResume();
    void whatWasTrueIsLookedAtBeforeTheNextTrial();
    void theLastTrialIsLookedAtBeforeTheDebrief();
    void anAssessmentGoesOnAtOnce();
    void theWayToTheButtonsIsTold();
    void escStopsAndRearms();
    void aStopShowsNoForce();
    void cuesFollowTheLevel_data();
    void cuesFollowTheLevel();
    void aStallCostsNoTick();
    void whatIsDrawnIsTheNewest();
    void leavingAsks();
    void endKeepsWhatIsRecorded();
    void startAgainBeginsAtOnce();
    void startAgainAsksWhoHasWorked();
    void errorsHaveTheirWords();
    void soundCanBeSilent();
};

void TestTrainingScreen::aWholeSetWithTheMouse() {
    TrainingBench bench(3);
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(bench.desktop.context.trialRuns());
    for (int trial = 0; trial < 3; ++trial) {
        QTRY_VERIFY_WITH_TIMEOUT(bench.runs() && bench.state().trial == trial, kPatience_ms);
        QVERIFY(bench.text("training.trial").contains(QString::number(trial + 1)));
        const double before_m = bench.state().tool[0].p_WT_m[0];
        bench.sweepTo({trial % 2 == 0 ? 50 : -50, 20});
        QTRY_VERIFY_WITH_TIMEOUT(trial % 2 == 0 ? bench.state().tool[0].p_WT_m[0] > before_m
                                                : bench.state().tool[0].p_WT_m[0] < before_m,
                                 kPatience_ms);
        while (bench.state().tool[0].p_WT_m[2] > 0.012 &&
               bench.runs()) { // onto the ball, or the plane beside it
            bench.wheel(-240);
            QTest::qWait(20);
        }
        QVERIFY(bench.mayMark());
        bench.click();
    }
    QElapsedTimer sinceMark;
    sinceMark.start();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
    qInfo("from the last mark to the debrief: %lld ms", static_cast<long long>(sinceMark.elapsed()));
    QVERIFY(!bench.desktop.context.trialRuns());
    const auto id =
        bench.desktop.context.navigator().current().parameters.value(QStringLiteral("session")).toLongLong();
    const database::SessionRecord record = recordOf(bench, id, bench.desktop.context.actor());
    QVERIFY(record.summary.state == SessionState::completed);
    QVERIFY(!record.summary.felt);
    QVERIFY(record.summary.operatorName.empty());
    QCOMPARE(record.summary.dropped, std::uint64_t{0});
    auto connection = bench.desktop.database().openReader();
    const auto trials = database::SessionReader(**connection, bench.desktop.context.actor()).trials(id);
    QCOMPARE(trials->size(), std::size_t{3});
    for (const database::TrialRecord& trial : *trials)
        QVERIFY(trial.marked);
}

/// Measurements for a trainee to begin with, all of them on request, and remembered; a trainer has them all
/// from the start.
void TestTrainingScreen::measurementsAreThePersons() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const auto details = [&] {
        return bench.screen()->findChild<QCheckBox*>(QStringLiteral("training.details"));
    };
    const auto torque = [&] {
        return bench.screen()
            ->findChild<QWidget*>(QStringLiteral("training.torque_bar"))
            ->isVisibleTo(bench.screen());
    };
    QVERIFY(!details()->isChecked() && !torque());
    bench.key(Qt::Key_F4);
    QVERIFY(details()->isChecked() && torque());
    bench.screen()->feed()->training().requestStop();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
    bench.show();
    QVERIFY(details()->isChecked());
    bench.desktop.logIn("theo"); // each their own
    bench.show();
    QVERIFY(!details()->isChecked());
    bench.desktop.logIn("tom");
    bench.show();
    QVERIFY(details()->isChecked());
}

void TestTrainingScreen::onlyKeys() {
    TrainingBench bench(1);
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const double z_m = bench.state().tool[0].p_WT_m[2];
    QTest::keyPress(bench.screen(), Qt::Key_PageDown);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().tool[0].p_WT_m[2] < z_m - 0.005, kPatience_ms);
    QTest::keyRelease(bench.screen(), Qt::Key_PageDown);
    QTest::keyPress(bench.screen(), Qt::Key_Right);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().tool[0].p_WT_m[0] > 0.002, kPatience_ms);
    QTest::keyRelease(bench.screen(), Qt::Key_Right);
    QVERIFY(bench.mayMark());
    bench.key(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
}

/// The second click of a double click on "Go", or a second press of Enter, comes when the trial has just
/// begun: nobody has moved anything, and the mark would be in the air. The same after a pause.
void TestTrainingScreen::aSecondPressMarksNothing() {
    TrainingBench bench;
    bench.train();
    int pressed = 0;
    const auto pressEarly = [&] {
        if (!bench.screen()->marksAreEarly())
            return; // this program stood still for so long that the mark would count
        bench.click();
        bench.key(Qt::Key_Return);
        ++pressed;
    };
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->feed(), kPatience_ms);
    pressEarly();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    pressEarly();
    QVERIFY(bench.mayMark());
    QTest::qWait(100); // a mark would have arrived
    QVERIFY(bench.runs() && bench.state().trial == 0 && !bench.screen()->drawn().answered);
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    bench.desktop.find<QPushButton>(QStringLiteral("training.main"))->click();
    pressEarly();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms);
    pressEarly();
    QVERIFY(bench.mayMark());
    QTest::qWait(100);
    QVERIFY(bench.runs() && bench.state().trial == 0 && !bench.screen()->drawn().answered);
    bench.click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->drawn().answered, kPatience_ms);
    if (pressed == 0)
        QSKIP("this program stood still, so that no press was early");
}

/// In 3D the scene is a native window of its own, in 2D a widget: keys work either way.
void TestTrainingScreen::keysWhileTheSceneHasTheFocus() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QObject* source = bench.screen()->scene()->inputSource();
    const auto press = [source](Qt::Key key) {
        if (auto* window = qobject_cast<QWindow*>(source))
            QTest::keyClick(window, key);
        else
            QTest::keyClick(static_cast<QWidget*>(source), key);
    };
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms);
    QVERIFY(bench.mayMark());
    press(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(int(bench.state().trial), 1, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    press(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    QCOMPARE(bench.text("training.force.title"), QStringLiteral("Force is stopped"));
    press(Qt::Key_R);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms);
}

void TestTrainingScreen::aDialogPauses() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QDialog dialog(bench.desktop.window.get());
    dialog.setModal(true);
    dialog.show();
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    dialog.close();
    QTest::qWait(100);
    QVERIFY(bench.state().paused); // going on is the person's to say
}

/// The mark and the top are drawn, the next trial waits and loses nothing of its time; no pause of the
/// person's is spoken of, and a pause of theirs outlasts it.
void TestTrainingScreen::whatWasTrueIsLookedAtBeforeTheNextTrial() {
    TrainingBench bench(3);
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(!bench.screen()->drawn().answered);
    QVERIFY(bench.mayMark());
    QElapsedTimer sinceMark;
    sinceMark.start();
    bench.key(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->drawn().answered, kPatience_ms);
    const scene3d::SceneState drawn = bench.screen()->drawn();
    QVERIFY(drawn.marked && drawn.objectShown && drawn.note.kind == scene3d::SceneNote::Kind::said);
    const QString said = drawn.note.title; // marked in the air, beside the ball or above it, as the session
                                           // was drawn: a distance alone would be untrue
    QVERIFY2(said.endsWith(QStringLiteral("not on the sphere")) ||
                 said.startsWith(QStringLiteral("Not counted")),
             qPrintable(said));
    const auto held = [&bench] { return bench.state().paused && bench.state().phase == TrialPhase::between; };
    const LongestGap gap;
    QTRY_VERIFY_WITH_TIMEOUT(held() || bench.state().trial == 1, kPatience_ms);
    if (!held() && 1'000'000 * gap.milliseconds() > desktop::AnswerNote::kHeld_ns / 2)
        QSKIP("this program stood still for a second, so that it could not look");
    QVERIFY(held());
    QVERIFY(bench.screen()->drawn().note.kind == scene3d::SceneNote::Kind::said);
    QVERIFY(bench.text("training.force.title") != QStringLiteral("Paused"));
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs() && bench.state().trial == 1, kPatience_ms);
    const double used_s = 30.0 - bench.state().timeLeft_s; // of the new trial's time
    QVERIFY(!bench.state().paused && used_s >= 0.0 &&
            used_s < 1e-3 * static_cast<double>(sinceMark.elapsed()) -
                         1.5); // its clock stood still for the two seconds
    QTRY_VERIFY_WITH_TIMEOUT(!bench.screen()->drawn().answered && !bench.screen()->drawn().marked,
                             kPatience_ms);
    QVERIFY(bench.mayMark());
    bench.key(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(held() || bench.state().trial == 2, kPatience_ms);
    if (!held() && 1'000'000 * gap.milliseconds() > desktop::AnswerNote::kHeld_ns / 2)
        QSKIP("this program stood still for a second, so that it could not look");
    QVERIFY(held());
    bench.key(Qt::Key_Space); // their own pause
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->drawn().note.kind == scene3d::SceneNote::Kind::paused,
                             kPatience_ms);
    QTest::qWait(static_cast<int>(desktop::AnswerNote::kHeld_ns / 1'000'000) + 500);
    QVERIFY(bench.state().paused && bench.state().trial == 1);
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs() && bench.state().trial == 2, kPatience_ms);
}

/// The session has ended, and is stored meanwhile: the scene with the mark and the top stays before the
/// debrief comes.
void TestTrainingScreen::theLastTrialIsLookedAtBeforeTheDebrief() {
    TrainingBench bench(1);
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const auto* stage = bench.screen()->findChild<desktop::StatePanel*>();
    bool looked = false;
    const auto look = connect(bench.screen()->feed(), &desktop::LiveFeed::frame, this, [&] {
        const scene3d::SceneState& drawn = bench.screen()->drawn();
        looked =
            looked || (bench.state().ended && stage->state() == desktop::StatePanel::State::content &&
                       drawn.answered && drawn.marked && drawn.note.kind == scene3d::SceneNote::Kind::said);
    });
    QVERIFY(bench.mayMark());
    bench.key(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(looked, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
    QVERIFY(!bench.desktop.context.trialRuns());
    disconnect(look);
}

/// The pointer is the scene's while somebody works: the way to the buttons stands above them, and over the
/// scene until it was once gone.
void TestTrainingScreen::theWayToTheButtonsIsTold() {
    const QString inScene = QStringLiteral("The mouse moves the instrument. Space pauses and frees it.");
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->drawn().note.title == inScene, kPatience_ms);
    QCOMPARE(bench.text("training.pointer"), QStringLiteral("Space frees the mouse"));
    QVERIFY(bench.screen()->scene()->widget()->cursor().shape() == Qt::BlankCursor);
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->drawn().note.kind == scene3d::SceneNote::Kind::paused,
                             kPatience_ms);
    QVERIFY(bench.screen()->scene()->widget()->cursor().shape() == Qt::ArrowCursor);
    QCOMPARE(bench.text("training.pointer"), QString()); // the veil says how to go on
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->drawn().note.kind == scene3d::SceneNote::Kind::none,
                             kPatience_ms); // who has found it is not told again
    QCOMPARE(bench.text("training.pointer"), QStringLiteral("Space frees the mouse"));
    bench.key(Qt::Key_Escape); // frees it, too
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->drawn().note.kind == scene3d::SceneNote::Kind::stopped,
                             kPatience_ms);
    QVERIFY(bench.screen()->scene()->widget()->cursor().shape() == Qt::ArrowCursor);
}

/// Level 5 teaches nothing: nothing is drawn, and nobody is kept.
void TestTrainingScreen::anAssessmentGoesOnAtOnce() {
    TrainingBench bench;
    QVERIFY(!bench.desktop.site.catalogue().find("sphere_apex", 5)->feedback);
    bench.train({{QStringLiteral("level"), 5}});
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(bench.mayMark());
    bench.key(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->drawn().note.title == QStringLiteral("Marked"), kPatience_ms);
    QVERIFY(!bench.screen()->drawn().answered && !bench.screen()->drawn().marked &&
            !bench.screen()->drawn().objectShown);
    while (!bench.runs() || bench.state().trial == 0) {
        QVERIFY(!bench.state().paused);
        QTest::qWait(20);
    }
    QVERIFY(!bench.screen()->drawn().answered);
}

void TestTrainingScreen::pauseAndResume() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QTest::keyPress(bench.screen(), Qt::Key_Right); // a held key must not go on moving the tool
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    QCOMPARE(bench.text("training.force.title"), QStringLiteral("Paused"));
    const haptics::DisplayState at = bench.state();
    QTest::qWait(300);
    QVERIFY(bench.state().tick > at.tick);             // the loop goes on ...
    QCOMPARE(bench.state().timeLeft_s, at.timeLeft_s); // ... and the clock does not
    QCOMPARE(bench.state().tool[0].p_WT_m[0], at.tool[0].p_WT_m[0]);
    bench.click(); // no mark while paused
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().timeLeft_s < at.timeLeft_s, kPatience_ms);
    QCOMPARE(int(bench.state().trial), 0);
    bench.desktop.find<QPushButton>(QStringLiteral("training.main"))->click(); // the button does the same
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
}

void TestTrainingScreen::escStopsAndRearms() {
    TrainingBench bench;
    bench.train({{QStringLiteral("device"), QStringLiteral("demonstration")},
                 {QStringLiteral("operator"), QStringLiteral("expert")}});
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().force == core::ForceState::on, kPatience_ms);
    bench.key(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().force == core::ForceState::stopped, kPatience_ms);
    QCOMPARE(bench.state().gain, 0.0);
    QVERIFY(bench.state().paused);
    QCOMPARE(bench.text("training.force.title"), QStringLiteral("Force is stopped"));
    bench.key(Qt::Key_Space); // a stop is not left by the pause key
    QTest::qWait(100);
    QVERIFY(bench.state().force == core::ForceState::stopped);
    auto* main = bench.desktop.find<QPushButton>(QStringLiteral("training.main"));
    QVERIFY(main->text().contains(QStringLiteral("Re-arm")));
    bench.key(Qt::Key_R);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().force == core::ForceState::arming ||
                                 bench.state().force == core::ForceState::ramping ||
                                 bench.state().force == core::ForceState::on,
                             kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().force == core::ForceState::on, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused,
                             kPatience_ms); // the trial goes on with the tick after the full force, and the
                                            // picture may lie between them
}

void TestTrainingScreen::aStopShowsNoForce() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    auto* bar = bench.desktop.find<desktop::ForceBar>(QStringLiteral("training.force_bar"));
    for (int n = 0; n < 60 && !bar->isOver(); ++n) { // through the ball or into the plane
        bench.wheel(-240);
        QTest::qWait(30);
    }
    QTRY_VERIFY_WITH_TIMEOUT(bar->isOver(), kPatience_ms);
    bench.key(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isOver(), kPatience_ms);
    bench.key(Qt::Key_R);
    QTRY_VERIFY_WITH_TIMEOUT(bar->isOver(), kPatience_ms); // the hand is where it was
}

void TestTrainingScreen::cuesFollowTheLevel_data() {
    QTest::addColumn<int>("level");
    QTest::newRow("visible") << 1;
    QTest::newRow("by touch, shown") << 2;
}

void TestTrainingScreen::cuesFollowTheLevel() {
    QFETCH(int, level);
    TrainingBench bench;
    bench.train({{QStringLiteral("level"), level}});
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const session::LevelCues cues =
        session::cuesOf(*bench.desktop.site.catalogue().find("sphere_apex", level), false);
    QCOMPARE(bench.desktop.find<desktop::ForceBar>(QStringLiteral("training.force_bar")) != nullptr,
             cues.bars);
    QCOMPARE(bench.desktop.find<QLabel>(QStringLiteral("training.tip_x")) != nullptr, cues.numbers);
    QCOMPARE(bench.desktop.find<desktop::LivePlot>(QStringLiteral("training.force_plot")) != nullptr,
             cues.plots);
    QCOMPARE(bench.desktop.find<QPushButton>(QStringLiteral("training.mute")) != nullptr, cues.sound);
    QCOMPARE(bench.state().objectShown, cues.object);
    QCOMPARE(cues.object, level == 1);
    QVERIFY(bench.text("training.device").contains(QStringLiteral("shown, not felt")));
}

/// The window does nothing for a second; lateness is printed beside the same run without that. A busy machine
/// may keep the window as long by itself: what the guard must never do is to speak of a window that was not
/// away; how long it was is recorded.
void TestTrainingScreen::aStallCostsNoTick() {
    for (const bool stall : {false, true}) {
        TrainingBench bench;
        bench.train({{QStringLiteral("device"), QStringLiteral("demonstration")},
                     {QStringLiteral("operator"), QStringLiteral("expert")}});
        QTRY_VERIFY_WITH_TIMEOUT(bench.state().force == core::ForceState::on, kPatience_ms);
        const std::uint64_t at = bench.state().tick;
        if (stall)
            QThread::msleep(1000);
        QTRY_VERIFY_WITH_TIMEOUT(bench.state().tick > at, kPatience_ms);
        const bool seen = (bench.state().guardsSeen & core::guard_bits::kHeartbeat) != 0;
        QVERIFY(seen || !stall);
        QTRY_VERIFY_WITH_TIMEOUT(bench.state().force == core::ForceState::on,
                                 kPatience_ms); // comes back by itself
        QCOMPARE(bench.state().droppedFrames, std::uint64_t{0});
        const haptics::LoopStatistics& loop = bench.screen()->feed()->training().statistics().latest();
        qInfo("%s: %llu ticks, %llu late, %llu skipped, p99 %.1f us, max %.1f us",
              stall ? "stalled for 1 s" : "no stall       ", static_cast<unsigned long long>(loop.ticks()),
              static_cast<unsigned long long>(loop.late()),
              static_cast<unsigned long long>(loop.skippedDeadlines()), loop.lateness().percentile_us(0.99),
              1e-3 * static_cast<double>(loop.lateness().maximum_ns()));
        const database::SessionId id = bench.screen()->feed()->training().sessionId();
        bench.screen()->feed()->training().requestStop();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.desktop.context.trialRuns(), kPatience_ms);
        QVERIFY(!seen || longestSilence_ms(bench, id) >= haptics::SafetySettings{}.heartbeatLimit_ms);
    }
}

/// However long the window was busy: one frame follows, of the newest state, and none of those in between.
void TestTrainingScreen::whatIsDrawnIsTheNewest() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    desktop::LiveFeed& feed = *bench.screen()->feed();
    for (int i = 0; i < 5; ++i) {
        QSignalSpy frames(&feed, &desktop::LiveFeed::frame);
        QVERIFY(frames.wait()); // at a frame
        const double before_s = bench.screen()->drawn().time_s;
        frames.clear();
        QThread::msleep(150); // nine frames' time
        QCoreApplication::sendPostedEvents();
        QCOMPARE(frames.count(), 0); // nothing was posted in the meantime to be drawn one after the other
        QVERIFY(frames.wait());
        QCOMPARE(frames.count(), 1);
        QVERIFY(feed.samples().size() > 16); // more ticks than a frame has
        QVERIFY(bench.screen()->drawn().time_s - before_s >
                0.9e-3 *
                    static_cast<double>(feed.samples().size())); // and all of them are behind what is drawn
    }
}

void TestTrainingScreen::leavingAsks() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const database::SessionId id = bench.screen()->feed()->training().sessionId();
    pressInQuestion("training.ask.keep");
    bench.desktop.go(QStringLiteral("settings"));
    QVERIFY(bench.at(QStringLiteral("training")));
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    pressInQuestion("training.ask.end");
    bench.desktop.go(QStringLiteral("settings"));
    QVERIFY(bench.at(QStringLiteral("settings")));
    QTRY_VERIFY_WITH_TIMEOUT(!bench.desktop.context.trialRuns(), kPatience_ms);
    QVERIFY(recordOf(bench, id, bench.desktop.context.actor()).summary.state == SessionState::stopped);
    QTest::qWait(200);
    QVERIFY(bench.at(QStringLiteral("settings"))); // its end carries nobody to a debrief
}

void TestTrainingScreen::endKeepsWhatIsRecorded() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const database::SessionId id = bench.screen()->feed()->training().sessionId();
    pressInQuestion("training.ask.end");
    bench.desktop.find<QPushButton>(QStringLiteral("training.end"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
    const database::SessionRecord record = recordOf(bench, id, bench.desktop.context.actor());
    QVERIFY(record.summary.state == SessionState::stopped);
    QVERIFY(record.summary.frames > 0);
}

void TestTrainingScreen::startAgainBeginsAtOnce() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const database::SessionId first = bench.screen()->feed()->training().sessionId();
    bench.sweepTo({60, 0});
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().tool[0].p_WT_m[0] > 0.001, kPatience_ms);
    bench.key(Qt::Key_F5);
    const auto second = [&] {
        return bench.screen() && bench.screen()->feed() ? bench.screen()->feed()->training().sessionId() : 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(second() != 0 && second() != first, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(bench.at(QStringLiteral("training")));
    QVERIFY(std::abs(bench.state().tool[0].p_WT_m[0]) <
            1e-4); // from the start position, with every value from nothing
    QCOMPARE(int(bench.state().trial), 0);
    QVERIFY(bench.screen()->feed()->worked_s() < 4.0);
    const database::SessionRecord kept = recordOf(bench, first, bench.desktop.context.actor());
    QVERIFY(kept.summary.state == SessionState::stopped);
    QVERIFY(kept.summary.frames > 0);
}

void TestTrainingScreen::startAgainAsksWhoHasWorked() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const database::SessionId first = bench.screen()->feed()->training().sessionId();
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->feed()->worked_s() > 5.2, kPatience_ms);
    auto* button = bench.desktop.find<QPushButton>(QStringLiteral("training.again"));
    QVERIFY(button && button->isEnabled() && (button->focusPolicy() & Qt::TabFocus));
    pressInQuestion("training.ask.keep");
    button->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    QCOMPARE(bench.screen()->feed()->training().sessionId(), first);
    bench.key(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms); // the same attempt goes on
    pressInQuestion("training.ask.end");
    button->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen() && bench.screen()->feed() &&
                                 bench.screen()->feed()->training().sessionId() > first,
                             kPatience_ms);
    QVERIFY(recordOf(bench, first, bench.desktop.context.actor()).summary.state == SessionState::stopped);
}

void TestTrainingScreen::errorsHaveTheirWords() {
    TrainingBench bench;
    bench.train({{QStringLiteral("device"), QStringLiteral("trace")},
                 {QStringLiteral("trace"), QStringLiteral("/nowhere/trace.csv")}});
    auto* panel = bench.screen()->findChild<desktop::StatePanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(panel->state() == desktop::StatePanel::State::error, kPatience_ms);
    QVERIFY(!bench.desktop.context.trialRuns());
    QVERIFY(bench.screen()->mayLeave());
    bench.train({{QStringLiteral("level"), 99}});
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen()->findChild<desktop::StatePanel*>()->state() ==
                                 desktop::StatePanel::State::error,
                             kPatience_ms);
}

void TestTrainingScreen::soundCanBeSilent() {
    TrainingBench bench; // CHIRON_NO_SOUND: there is no output
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    auto* mute = bench.desktop.find<QPushButton>(QStringLiteral("training.mute"));
    QVERIFY(mute && !mute->isEnabled());
    QVERIFY(mute->toolTip().contains(QStringLiteral("Everything that can be heard is also shown")));
}

QTEST_MAIN(TestTrainingScreen)
#include "test_training_screen.moc"
