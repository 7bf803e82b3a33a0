// SPDX-License-Identifier: GPL-3.0-or-later
// A person looks for an apex on the screen: to the end by keys and mouse, stopped and gone on with at the
// trial, a spoiled trial again; what the picture shows; and the data screen's analysis of it.
// CHIRON_KEEP_PICTURES=<folder> keeps pictures.
#include "desktop/study_run/apex_stage.h"
#include "desktop/study_run/trials_screen.h"
#include "session/study/study_analysis.h"
#include "session/study/study_store.h"
#include "support/apex_marker.h"
#include "support/kept_text.h"
#include "support/patience.h"
#include "support/picture_look.h"
#include "support/screen_outline.h"
#include "support/sitting_hands.h"

#include <QDir>
#include <QLabel>
#include <QMouseEvent>
#include <QPointer>
#include <QRadioButton>
#include <QWheelEvent>

using chiron::tests::kPatience_ms;

using namespace chiron;
using State = session::LiveStudyView::State;

namespace {

constexpr double kBeside_m = 0.004; ///< to the right of the apex

psychophysics::StudyDesign quickApexStudy() {
    psychophysics::StudyDesign design = tests::apexStudy("apex_trials", 4);
    design.instructions = {{"en", "A ball that you cannot see lies in front of you. Feel your way over it "
                                  "and mark its highest point."}};
    psychophysics::Questionnaire effort;
    effort.id = "effort";
    effort.title = {{"en", "Effort"}};
    effort.when = psychophysics::Questionnaire::When::afterCondition;
    effort.items = {{"hard",
                     {{"en", "How hard was it?"}},
                     psychophysics::QuestionnaireItem::Kind::likert,
                     5,
                     {{"en", "not at all"}},
                     {{"en", "very"}},
                     {},
                     "",
                     0,
                     0,
                     true}};
    design.questionnaires = {effort};
    design.trial.visibleObjects = false;
    design.trial.betweenTrials_s = 0.1;
    design.fidelity.lateTicks = 1.0; // a busy machine is no fault of what is tested
    design.fidelity.meanSpeed_m_per_s = 10.0;
    return design;
}

} // namespace

class TestApexTrials : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanupTestCase() { m_site.reset(); }
    void cleanup() { // what a failure left running
        if (auto* screen = m_site->screen<desktop::TrialsScreen>(); screen && screen->live())
            stop(screen);
    }
    void nothingGivesTheSphereAway();
    void stoppedInTheMiddle();
    void forceIsStoppedByKeyAndRearmed();
    void aSpoiledTrialComesAgainAndTheRunEnds();
    void theAnalysisHoldsTheMarks();

private:
    desktop::TrialsScreen* sit();
    bool exploring(desktop::TrialsScreen* screen);
    bool mark(desktop::TrialsScreen* screen);
    template <class Left> void travel(std::pair<Qt::Key, Qt::Key> keys, Left left);
    void stop(desktop::TrialsScreen* screen);
    void press(desktop::TrialsScreen* screen, const char* button) {
        screen->findChild<QPushButton*>(QLatin1String(button))->click();
    }
    session::OpenedStudy opened() {
        return *session::openStudy(m_site->database(), m_site->context.actor(), m_study, m_participant.code);
    }
    std::vector<database::StudyTrial> stored() {
        const auto runs = opened().runs;
        auto connection = m_site->database().openReader();
        return runs.empty() ? std::vector<database::StudyTrial>()
                            : *database::StudyReader(**connection, m_site->context.actor())
                                   .studyTrials(runs.front().id);
    }
    void keep(const char* name) {
        tests::keepPicture(*m_site, QStringLiteral("apex_trials_%1").arg(QLatin1String(name)));
    }

    std::unique_ptr<tests::DesktopFixture> m_site;
    database::StudyNumber m_study = 0;
    database::Participant m_participant;
    std::size_t m_before = 0; ///< trials stored when the present session began
    int m_sessions = 0;
};

void TestApexTrials::initTestCase() {
    if (!tests::hasLook("scene"))
        qputenv("CHIRON_NO_3D", "1");
    m_site = std::make_unique<tests::DesktopFixture>();
    tests::applyLook(*m_site);
    const database::Actor rhea = m_site->actor("rhea");
    const psychophysics::StudyDesign design = quickApexStudy();
    m_study = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(m_study); });
    m_participant = tests::addParticipant(*m_site, rhea, m_study, design, "somebody");
    m_site->logIn("rhea");
}

desktop::TrialsScreen* TestApexTrials::sit() {
    m_before = stored().size();
    m_sessions = 1;
    m_site->go(QStringLiteral("study_run"),
               {{QStringLiteral("study"), qlonglong(m_study)},
                {QStringLiteral("participant"), QString::fromStdString(m_participant.code)}});
    const auto begin = [this] {
        return m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("run.begin"));
    };
    if (!tests::waitUntilLoaded(*m_site) || !begin())
        return nullptr;
    begin()->click();
    auto* screen = m_site->screen<desktop::TrialsScreen>();
    return screen && screen->live() ? screen : nullptr;
}

bool TestApexTrials::exploring(desktop::TrialsScreen* screen) {
    return QTest::qWaitFor([screen] { return screen->live()->view().state == State::exploring; },
                           kPatience_ms);
}

/// An arrow key is held until little of the way is left.
template <class Left> void TestApexTrials::travel(std::pair<Qt::Key, Qt::Key> keys, Left left) {
    constexpr double kNear_m = 0.0015;
    if (std::abs(left()) < kNear_m)
        return;
    const bool forward = left() > 0.0;
    const Qt::Key key = forward ? keys.second : keys.first;
    QTest::keyPress(m_site->window.get(), key);
    (void)QTest::qWaitFor([&] { return (left() > 0.0) != forward || std::abs(left()) < kNear_m; },
                          kPatience_ms);
    QTest::keyRelease(m_site->window.get(), key);
}

/// By keys, mouse and wheel over the scene to a place beside the apex, and a click there. False where that
/// did not become a trial.
bool TestApexTrials::mark(desktop::TrialsScreen* screen) {
    session::LiveSitting& live = *screen->live();
    if (!exploring(screen))
        return false;
    if (live.sessions() != m_sessions) {
        m_sessions = live.sessions();
        m_before = stored().size();
    }
    auto& stage = *screen->findChild<desktop::ApexStage*>();
    const auto counted = [&live] { return live.numbers().scored + live.numbers().spoiled; };
    const int before = counted();
    const auto centre = tests::apexPlaces(live, opened().runs.front().seed, m_before)
                            .at(live.training().display().latest().trial)
                            .centre_m;
    const core::Vec3 to(centre.x() + kBeside_m, centre.y(), 0.018);
    QPointF at = QRectF(stage.area().rect()).center();
    const auto send = [&](QEvent::Type type, QPointF where, Qt::MouseButton button) {
        QMouseEvent event(type, where, stage.area().mapToGlobal(where), button,
                          type == QEvent::MouseButtonPress ? button : Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&stage.source(), &event);
    };
    const auto near = [&] { return live.view().canAnswer && (tests::toolOf(live) - to).norm() < 5e-4; };
    travel({Qt::Key_Left, Qt::Key_Right}, [&] { return to.x() - tests::toolOf(live).x(); });
    travel({Qt::Key_Down, Qt::Key_Up}, [&] { return to.y() - tests::toolOf(live).y(); });
    constexpr double kMetresPerPixel = 0.0001, kMetresPerWheelStep = 0.002, kMost_px = 30.0;
    for (int i = 0; i < 300 && !near(); ++i) {
        const core::Vec3 left = to - tests::toolOf(live);
        const core::Vec2 across =
            left.head<2>().norm() > 5e-4 ? core::Vec2(left.head<2>()) : core::Vec2(0.0, 0.0);
        if (across.norm() == 0.0) { // over it first, then down
            const QPointF global = stage.area().mapToGlobal(at);
            QWheelEvent turn(
                at, global, {},
                QPoint(0,
                       std::clamp(static_cast<int>(0.5 * left.z() / kMetresPerWheelStep * 120.0), -240, 240)),
                Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&stage.source(), &turn);
            QTest::qWait(20);
            continue;
        }
        QPointF step(across.x() / kMetresPerPixel, -across.y() / kMetresPerPixel);
        if (const double length = std::hypot(step.x(), step.y()); length > kMost_px)
            step *= kMost_px / length;
        at += step;
        send(QEvent::MouseMove, at, Qt::NoButton);
        QTest::qWait(20);
    }
    if (!near()) {
        const core::Vec3 is = tests::toolOf(live);
        qWarning("tool at %g %g %g, wanted %g %g %g, state %d", is.x(), is.y(), is.z(), to.x(), to.y(),
                 to.z(), static_cast<int>(live.view().state));
        return false;
    }
    QTest::qWait(static_cast<int>(desktop::EarlyMarks::kWait_ms) + 100); // not a second press on "Go on"
    send(QEvent::MouseButtonPress, at, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, at, Qt::LeftButton);
    // after the last one the screen is gone soon
    return QTest::qWaitFor(
        [&, alive = QPointer<desktop::TrialsScreen>(screen)] {
            return !alive || m_site->window->screen() != screen || counted() > before;
        },
        kPatience_ms);
}

void TestApexTrials::stop(desktop::TrialsScreen* screen) {
    QVERIFY(tests::stopSitting(*m_site, screen, kPatience_ms));
}

/// The picture is the same wherever the sphere lies, and says where the hand is, not where the surface is.
void TestApexTrials::nothingGivesTheSphereAway() {
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen);
    // Before the first moment of it, against what was read and kept: CHIRON_STORE_OUTLINES=1
    // QT_QPA_PLATFORM=offscreen build/release/tests/gui/studies/test_apex_trials
    tests::KeptText kept(QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/studies/kept_apex_trials.txt"));
    const QString differs = kept.differs(QStringLiteral("trials"), tests::ScreenOutline::of(*screen));
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
    keep("instructions");
    QVERIFY(tests::beginTrials(screen));
    m_sessions = screen->live()->sessions(); // the free minute is one of its own
    QVERIFY(exploring(screen));
    auto& stage = *screen->findChild<desktop::ApexStage*>();
    for (const QLabel* label : screen->findChildren<QLabel*>()) // no value and no name of a condition
        QVERIFY2(!label->text().contains(QStringLiteral("N/m")) &&
                     !label->text().contains(QStringLiteral("20 mm")),
                 qPrintable(label->text()));
    const auto centre = tests::apexPlaces(*screen->live(), opened().runs.front().seed, 0).front().centre_m;
    tests::moveTo(*screen->live(), core::Vec3(centre.x(), centre.y(), 0.017));
    QTRY_VERIFY_WITH_TIMEOUT(screen->live()->view().canAnswer, kPatience_ms);
    QTest::qWait(300);
    const scene3d::SceneState& drawn = stage.drawn();
    QVERIFY(!drawn.objectShown && !drawn.answered && !drawn.marked);
    QCOMPARE(drawn.p_WObject.norm(), 0.0);
    QVERIFY(drawn.tool[0].present && !drawn.tool[0].drawnAtSurface);
    QVERIFY2(drawn.tool[0].p_WT.z() < 0.0198, "the tool is drawn at the surface");
    QCOMPARE((drawn.tool[0].p_WProxy - drawn.tool[0].p_WT).norm(), 0.0);
    QVERIFY(drawn.tool[0].force_N.norm() > 0.05); // shown, not felt
    keep("exploring");
    press(screen, "trials.experimenter");
    QVERIFY(tests::typePassword(*m_site));
    QTRY_VERIFY_WITH_TIMEOUT(screen->findChild<QLabel*>(QStringLiteral("experimenter.estimate"))
                                 ->text()
                                 .contains(QStringLiteral("first scored")),
                             kPatience_ms);
    keep("experimenter");
    stop(screen);
    QCOMPARE(stored().size(), std::size_t(1));
    QCOMPARE(stored().front().spoiled, std::string("stopped"));
}

void TestApexTrials::stoppedInTheMiddle() {
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen);
    QCOMPARE(screen->live()->numbers().scored, 0);
    QVERIFY(tests::beginTrials(screen));
    m_sessions = screen->live()->sessions(); // the free minute is one of its own
    QVERIFY2(mark(screen), "no trial came");
    QVERIFY2(mark(screen), "no second trial came");
    stop(screen);
    const auto trials = stored();
    QCOMPARE(
        std::count_if(trials.begin(), trials.end(), [](const auto& trial) { return trial.spoiled.empty(); }),
        2);
    for (const database::StudyTrial& trial : trials)
        if (const auto error = session::apexMarkOf(trial.fidelityJson)) {
            QVERIFY2(std::abs(error->errorX_m - kBeside_m) < 1e-3 && std::abs(error->errorY_m) < 1e-3,
                     "the mark is not where it was set");
            QVERIFY(error->inContact);
        }
}

void TestApexTrials::forceIsStoppedByKeyAndRearmed() {
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen);
    QCOMPARE(screen->live()->numbers().scored, 2);
    QVERIFY(tests::beginTrials(screen));
    m_sessions = screen->live()->sessions(); // the free minute is one of its own
    QVERIFY(exploring(screen));
    QTest::keyClick(m_site->window.get(), Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::stopped, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(screen->findChild<QLabel*>(QStringLiteral("break.title"))->isVisible(),
                             kPatience_ms);
    keep("stopped");
    QTest::keyClick(m_site->window.get(), Qt::Key_Space); // that takes R
    QTest::qWait(100);
    QCOMPARE(screen->live()->view().state, State::stopped);
    QTest::keyClick(m_site->window.get(), Qt::Key_R);
    QVERIFY(exploring(screen));
    QTest::qWait(700); // so soon after going on, a key counts as a second press
    QTest::keyClick(m_site->window.get(), Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::paused, kPatience_ms);
    QTest::qWait(700);
    QTest::keyClick(m_site->window.get(), Qt::Key_Space);
    QVERIFY(exploring(screen));
    stop(screen);
}

void TestApexTrials::aSpoiledTrialComesAgainAndTheRunEnds() {
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen);
    QCOMPARE(screen->live()->numbers().scored, 2);
    const int spoiled = screen->live()->numbers().spoiled;
    QVERIFY(tests::beginTrials(screen));
    m_sessions = screen->live()->sessions(); // the free minute is one of its own
    QVERIFY(exploring(screen));
    screen->live()->spoil();
    QVERIFY(mark(screen));
    QCOMPARE(screen->live()->numbers().scored, 2);
    QCOMPARE(screen->live()->numbers().spoiled, spoiled + 1);
    QVERIFY(mark(screen));
    QVERIFY(mark(screen)); // in a further session
    QCOMPARE(m_sessions, 2);
    QTRY_VERIFY_WITH_TIMEOUT(screen->live()->finished() && !screen->isBusy(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(screen->findChild<QWidget*>(QStringLiteral("trials.questions")),
                             kPatience_ms); // about what was just done, on the participant's page
    auto* submit = screen->findChild<QPushButton*>(QStringLiteral("questions.submit"));
    QVERIFY(submit && submit->isVisible());
    submit->click(); // it must be answered
    screen->findChild<QRadioButton*>(QStringLiteral("questionnaire.hard.4"))->click();
    submit->click();
    const QPointer<QLabel> said = screen->findChild<QLabel*>(QStringLiteral("break.text"));
    QTRY_VERIFY_WITH_TIMEOUT(said && said->isVisible() &&
                                 said->text().contains(QStringLiteral("Please call the experimenter")),
                             kPatience_ms);
    stop(screen);
    const database::StudyRun run = opened().runs.front();
    QCOMPARE(run.state, database::StudyRunState::completed);
    auto connection = m_site->database().openReader();
    const auto answers =
        database::StudyReader(**connection, m_site->context.actor()).questionnaireAnswers(m_study);
    QVERIFY(answers && answers->size() == 1);
    QVERIFY(answers->front().run == run.id && answers->front().condition == "sphere" &&
            answers->front().number == 4.0 && answers->front().language == "en");
}

void TestApexTrials::theAnalysisHoldsTheMarks() {
    auto connection = m_site->database().openReader();
    database::StudyReader reader(**connection, m_site->context.actor());
    const auto analysis = session::analyseStudy(reader, m_study, 3);
    QVERIFY(analysis);
    const auto& run = analysis->conditions.front().runs.front();
    QVERIFY(run.apex);
    QCOMPARE(run.apex->trials, 4);
    double sumX_mm = 0.0, sumY_mm = 0.0;
    for (const database::StudyTrial& trial : stored())
        if (const auto error = session::apexMarkOf(trial.fidelityJson); error && trial.spoiled.empty()) {
            sumX_mm += 1e3 * error->errorX_m;
            sumY_mm += 1e3 * error->errorY_m;
        }
    QVERIFY(std::abs(run.apex->axes[0].bias_mm - sumX_mm / 4.0) < 1e-9);
    QVERIFY(std::abs(run.apex->axes[1].bias_mm - sumY_mm / 4.0) < 1e-9);
    QVERIFY2(std::abs(run.apex->axes[0].bias_mm - 1e3 * kBeside_m) < 1.0, "4 mm to the right, every time");
    QCOMPARE(run.replayed.same, run.replayed.trials);
}

QTEST_MAIN(TestApexTrials)
#include "test_apex_trials.moc"
