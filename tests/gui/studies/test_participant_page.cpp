// SPDX-License-Identifier: GPL-3.0-or-later
// What a participant sees and can do, and what only the experimenter can: the card and the free minute before
// anything counts, answers only when they are possible, practice taken back, the neutral end, the way to the
// experimenter's desk; and what happens half-way.
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_run/answer_panel.h"
#include "desktop/study_run/asked_sitting.h"
#include "desktop/study_run/participant_window.h"
#include "desktop/study_run/places_view.h"
#include "desktop/study_run/sitting_sentences.h"
#include "desktop/study_run/study_controls.h"
#include "session/study/study_analysis.h"
#include "session/study/trial_fidelity.h"
#include "support/paint_outline.h"
#include "support/patience.h"
#include "support/sitting_hands.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMouseEvent>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <cmath>
#include <map>
#include <string>

using chiron::tests::kPatience_ms;

using namespace chiron;
using State = session::LiveStudyView::State;

namespace {

/// Two screens beside each other, as the platform is told of them.
const char* const kScreens = R"({"screens": [{"name": "one", "x": 0, "y": 0, "width": 1280, "height": 720},
                                             {"name": "two", "x": 1280, "y": 0, "width": 1280, "height": 720}]})";

/// Presses a key in the moment in which a page with this title is painted, before anybody can have read it.
class PressesTooEarly final : public QObject {
public:
    PressesTooEarly(QLabel& title, QString shown, QObject& window, Qt::Key key)
        : m_title(title), m_shown(std::move(shown)), m_window(window), m_key(key) {
        title.installEventFilter(this);
    }
    bool pressed() const { return m_pressed; }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::Paint || m_pressed || m_title.text() != m_shown)
            return false;
        m_pressed = true;
        for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease})
            QCoreApplication::postEvent(&m_window, new QKeyEvent(type, m_key, Qt::NoModifier));
        return false;
    }

private:
    QLabel& m_title;
    QString m_shown;
    QObject& m_window;
    Qt::Key m_key;
    bool m_pressed = false;
};

} // namespace

class TestParticipantPage : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanup();
    void cleanupTestCase() { m_site.reset(); }
    void theControlsOfEveryTaskAndDeviceAreShown();
    void whatIsMissingIsNamed();
    void aTooLightTouchIsTold();
    void aMassIsLiftedAndPutDownStepByStep();
    void pressingAMassIsNoLift();
    void theFreeMinuteTellsEachStep();
    void aPadIsStroked();
    void anAnswerThatIsTakenBackIsNamed();
    void theForceBarIsLabelled();
    void theCardAndTheFreeMinuteComeFirst();
    void nothingCountsBeforeTheTrials();
    void aLongCardIsReadBeforeItBegins();
    void aLongInstructionIsReadBeforeItEnds();
    void nothingIsCutWithLargeTexts();
    void aFurtherPartIsShort();
    void aSecondPressSkipsNoInstruction();
    void aClickInTheSceneAnswersNothing();
    void practiceIsTakenBack();
    void aPageThatComesByItselfTakesNoEarlyKey();
    void theHandIsToldBeforeTheLimit();
    void aStopRepeatsNothing();
    void aTrialThatDoesNotCountIsTold();
    void everyReasonHasWords();
    void theReasonThatHeldIsTold();
    void howTrialsGoOnIsSaidBeforeTheyCount();
    void stopWordsFollowTheDevice();
    void enterAndSpaceGoOn();
    void enterAfterANumberCallsNobody();
    void whatTheStationDoesIsSaid();
    void anEarlierVersionsNoiseIsNotShown();
    void aSessionThatEndsByItselfIsTold();
    void aDoublePressAnswersNothing();
    void stopIsReachedWithACapturedPointer();
    void theDeskTakesThePassword();
    void whoLeavesMidTrialReadsThatItWasStopped();
    void aPilotIsNamed();
    void aPilotIsAskedBeforeItStops();
    void aPilotThatEndsWhileItIsAskedStays();
    void whoWasAskedForSitsDownAfterTheLogin();
    void anOpenStudyAsksForNoPassword();
    void aSecondScreenIsTheParticipants();
    void anUnpluggedScreenBringsThePageBack();
    void sittingsNoteTheirCircumstances();
    void maskingThatNobodyHearsIsToldTheExperimenter();

private:
    /// A frozen study and a participant who has consented.
    void prepare(const std::string& key, const std::function<void(psychophysics::StudyDesign&)>& change = {});
    /// Two objects that differ in mass, one of which is heavier.
    void prepareMass(const std::string& key,
                     const std::function<void(psychophysics::StudyDesign&)>& change = {}) {
        prepare(key, [&change](psychophysics::StudyDesign& design) {
            psychophysics::Condition& condition = design.conditions[0];
            condition.stimulus.attribute = psychophysics::Attribute::mass;
            condition.stimulus.reference = 0.1;
            condition.stimulus.fixed["stiffness_N_per_m"] = 300.0;
            condition.task = psychophysics::Task::twoAfc;
            condition.procedures = {
                psychophysics::ConstantSpec{{condition.stimulus.differences.back()}, 10, true}};
            design.trial.exploreLimit_s = 0.0;
            if (change)
                change(design);
        });
    }
    desktop::TrialsScreen* sit(bool oneScreen = true, double freeMinute_s = 60.0);
    void press(int key) { QTest::keyClick(m_site->window.get(), static_cast<Qt::Key>(key)); }
    QString said(desktop::TrialsScreen* screen, const char* label) {
        return page(screen)->findChild<QLabel*>(QLatin1String(label))->text();
    }
    /// Again and again, as somebody does who waits for it: a key that comes too early is not taken.
    bool pressUntil(int key, const std::function<bool()>& there) {
        return QTest::qWaitFor(
            [&] {
                if (there())
                    return true;
                press(key);
                QTest::qWait(100);
                return there();
            },
            kPatience_ms);
    }
    bool canAnswer(desktop::TrialsScreen* screen) {
        return QTest::qWaitFor([screen] { return screen->live()->view().canAnswer; }, kPatience_ms);
    }
    /// Moves the tool to x and z above the middle line, as fast as a hand.
    bool reach(session::LiveSitting& live, double x_m, double z_m) {
        return QTest::qWaitFor(
            [&] {
                const auto& at = live.training().display().latest().tool[0].p_WT_m;
                const double x = x_m - at[0], y = -at[1], z = z_m - at[2];
                if (std::hypot(x, y, z) < 4e-5)
                    return true;
                live.training().pointer()->move(0.4 * x, 0.4 * y, 0.4 * z);
                QTest::qWait(30);
                return false;
            },
            kPatience_ms);
    }
    std::vector<database::StudyTrial> stored();
    QString told(const QWidget& page) {
        QString words;
        for (const QLabel* label : page.findChildren<QLabel*>())
            words += label->text() + QLatin1Char('\n');
        for (const QAbstractButton* button : page.findChildren<QAbstractButton*>())
            words += button->text() + QLatin1Char('\n');
        return words;
    }
    QWidget* page(desktop::TrialsScreen* screen) {
        QWidget* in =
            screen->participantWindow() ? static_cast<QWidget*>(screen->participantWindow()) : screen;
        return in->findChild<QWidget*>(QStringLiteral("trials.page"));
    }

    std::unique_ptr<tests::DesktopFixture> m_site;
    database::StudyNumber m_study = 0;
    database::Participant m_participant;
};

void TestParticipantPage::initTestCase() {
    m_site = std::make_unique<tests::DesktopFixture>();
    m_site->logIn("rhea");
}

void TestParticipantPage::cleanup() { // what a failure left running
    if (auto* screen = m_site->screen<desktop::TrialsScreen>(); screen && screen->live())
        (void)tests::stopSitting(*m_site, screen);
}

void TestParticipantPage::prepare(const std::string& key,
                                  const std::function<void(psychophysics::StudyDesign&)>& change) {
    const database::Actor rhea = m_site->actor("rhea");
    psychophysics::StudyDesign design = tests::smallStudy(key);
    design.conditions.resize(1);
    design.trial.mustTouchAll = false;
    design.trial.betweenTrials_s = 0.1;
    design.fidelity.lateTicks = 1.0; // a busy machine is no fault of what is tested
    if (change)
        change(design);
    m_study = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(m_study); });
    m_participant = tests::addParticipant(*m_site, rhea, m_study, design, "somebody");
}

desktop::TrialsScreen* TestParticipantPage::sit(bool oneScreen, double freeMinute_s) {
    m_site->go(QStringLiteral("study_trials"),
               {{QStringLiteral("study"), qlonglong(m_study)},
                {QStringLiteral("participant"), QString::fromStdString(m_participant.code)},
                {QStringLiteral("one_screen"), oneScreen},
                {QStringLiteral("free_minute_s"), freeMinute_s}});
    auto* screen = m_site->screen<desktop::TrialsScreen>();
    return screen && screen->live() ? screen : nullptr;
}

std::vector<database::StudyTrial> TestParticipantPage::stored() {
    auto connection = m_site->database().openReader();
    database::StudyReader reader(**connection, m_site->context.actor());
    const auto runs = reader.runs(m_participant.id);
    return runs && !runs->empty() ? *reader.studyTrials(runs->back().id)
                                  : std::vector<database::StudyTrial>();
}

void TestParticipantPage::theControlsOfEveryTaskAndDeviceAreShown() {
    using namespace psychophysics;
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    for (int task = 0; task < kTasks; ++task)
        for (int attribute = 0; attribute < kAttributes; ++attribute)
            for (const desktop::StudyHand hand :
                 {desktop::StudyHand{true, false}, desktop::StudyHand{false, true}}) {
                desktop::ReadyFacts facts;
                facts.controls =
                    desktop::studyControls(static_cast<Task>(task), static_cast<Attribute>(attribute), hand);
                facts.keys =
                    desktop::studyKeys(static_cast<Task>(task), static_cast<Attribute>(attribute), hand);
                facts.offersPractice = false;
                const bool holds = desktop::takesHold(desktop::handlingOf(static_cast<Attribute>(attribute)));
                QCOMPARE(facts.controls.size(), std::size_t(holds ? 4 : 3)); // letting go is one of its own
                for (const desktop::ControlHint& hint : facts.controls) {
                    QVERIFY(!hint.what.isEmpty() && !hint.how.isEmpty());
                    QVERIFY2(hand.pointer || !hint.how.contains(QStringLiteral("mouse")),
                             qPrintable(hint.how));
                }
                QVERIFY(facts.keys.contains(QStringLiteral("Esc")));
                const desktop::ReadyCard card(theme, facts, desktop::ReadyCard::Kind::whole);
                QVERIFY(!card.findChild<QPushButton*>(QStringLiteral("training.ready.practice")));
            }
}

void TestParticipantPage::whatIsMissingIsNamed() {
    prepare("missing", [](psychophysics::StudyDesign& design) { design.trial.mustTouchAll = true; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::exploring, kPatience_ms);
    auto* why = page(screen)->findChild<QLabel*>(QStringLiteral("answer.why"));
    QTRY_COMPARE_WITH_TIMEOUT(
        why->text(),
        QStringLiteral("Pull first: 1, 2, 3. Move the tool over a ring and lower it into "
                       "the ring: roll the wheel towards you, or hold Page Down."),
        kPatience_ms);
    for (const char* name : {"answer.0", "answer.1", "answer.2", "answer.confirm"})
        QVERIFY2(!tests::sittingButton(screen, name)->isEnabled(), name);
    QTest::keyClick(m_site->window.get(), Qt::Key_1); // neither do keys answer
    QVERIFY(screen->findChild<desktop::AnswerPanel*>()->marks().join(QString()).isEmpty());
    const QWidget* first = tests::sittingButton(screen, "answer.0");
    QVERIFY(why->mapTo(screen, QPoint()).y() < first->mapTo(screen, QPoint()).y()); // above the answers
}

/// What was only grazed is named with the force that is missing; once it was felt, the next object is.
void TestParticipantPage::aTooLightTouchIsTold() {
    prepare("light", [](psychophysics::StudyDesign& design) {
        design.trial.mustTouchAll = true;
        design.trial.probeAtLeast_N = 0.3;
        design.trial.exploreLimit_s = 0.0;
    });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::exploring, kPatience_ms);
    session::LiveSitting& live = *screen->live();
    auto* why = page(screen)->findChild<QLabel*>(QStringLiteral("answer.why"));
    QVERIFY(reach(live, -0.04, 0.060) && reach(live, -0.04, 0.027)); // in the ring of the first
    QVERIFY(reach(live, -0.04, 0.03015));                            // 0.15 mm out: at most 0.14 N
    QTRY_COMPARE_WITH_TIMEOUT(why->text(),
                              QStringLiteral("Pull a little harder on 1: at least 0.3 N. Roll the wheel away "
                                             "from you, or hold Page Up."),
                              kPatience_ms);
    QCOMPARE(live.view().touched, 0U);
    QVERIFY(!live.view().canAnswer && (live.view().grazed & 1U) != 0);
    QVERIFY(reach(live, -0.04, 0.0333)); // 1 N and more
    QTRY_COMPARE_WITH_TIMEOUT(live.view().touched, 1U, kPatience_ms);
    QTRY_VERIFY2_WITH_TIMEOUT(
        why->text().startsWith(
            QStringLiteral("You are holding object 1. To let go, lower the tool below the dashed line")) &&
            why->text().endsWith(QStringLiteral("Pull next: 2, 3.")),
        qPrintable(why->text()), kPatience_ms);
    const auto& scene = live.level().parameters.as<simulation::ComparisonParameters>();
    QVERIFY(reach(live, -0.04, simulation::letGoHeight_m(scene) - 0.0005)); // just below the line
    const QString letGo = QStringLiteral("You let go of object 1. Raise the tool. Pull next: 2, 3.");
    QTRY_COMPARE_WITH_TIMEOUT(why->text(), letGo, kPatience_ms);
    QVERIFY(reach(live, -0.04, 0.045)); // straight up through the ring, which takes no hold again
    QTRY_COMPARE_WITH_TIMEOUT(why->text(), letGo, kPatience_ms);
    QCOMPARE(live.view().place, -1);
}

/// Each step is told when it comes, and drawn; whoever holds an object learns how to let go of it before
/// another one can be lifted.
void TestParticipantPage::aMassIsLiftedAndPutDownStepByStep() {
    prepareMass("mass_steps", [](psychophysics::StudyDesign& design) { design.trial.mustTouchAll = true; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::exploring, kPatience_ms);
    session::LiveSitting& live = *screen->live();
    const auto* places = page(screen)->findChild<desktop::PlacesView*>();
    const auto says = [&](const char* words) {
        return QTest::qWaitFor([&] { return said(screen, "answer.why").contains(QLatin1String(words)); },
                               kPatience_ms);
    };
    const double left = -0.02, right = 0.02;
    QVERIFY(says("Lift first: 1, 2. Move the tool over a ring and lower it into the ring"));
    QVERIFY(reach(live, left, 0.050) && reach(live, left, 0.031));
    QVERIFY(says("You are holding object 1. Lift it off the table: roll the wheel away from you"));
    QCOMPARE(live.view().touched, 0U);
    QCOMPARE(places->drawnHeight_m(0), 0.0);
    QVERIFY(reach(live, left, 0.045));
    QVERIFY(says("You are lifting object 1. To put it down, lower it to the table"));
    QVERIFY(says("Lift next: 2."));
    QTRY_VERIFY_WITH_TIMEOUT(places->drawnHeight_m(0) > 0.007, kPatience_ms); // held from 6 mm above the ring
    QVERIFY(places->drawnHeight_m(0) < 0.02);
    QVERIFY(reach(live, right, 0.045) && reach(live, right, 0.0357)); // in the ring of the other one
    QVERIFY(says("Object 1 stands on the table, and you still hold it. To let go, lower the tool at least "
                 "0.9 mm further")); // 0.25 N on a bed of 300 N/m
    QCOMPARE(live.view().place, 0);
    QVERIFY(reach(live, left, 0.0357));
    QTRY_VERIFY_WITH_TIMEOUT(places->drawnHeight_m(0) < 0.001, kPatience_ms);
    QVERIFY(reach(live, left, 0.033));
    QVERIFY(says("Now raise the tool: object 1 stays on the table."));
    QVERIFY(reach(live, left, 0.050));
    QVERIFY(says("You let go of object 1. Raise the tool. Lift next: 2."));
    QCOMPARE(places->drawnHeight_m(0), 0.0);
    QVERIFY(reach(live, right, 0.050) && reach(live, right, 0.031) && reach(live, right, 0.045));
    QVERIFY(says("You can answer now. You are lifting object 2."));
    QVERIFY(live.view().canAnswer);
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// Pressed onto the table it weighs nothing: it does not count as explored.
void TestParticipantPage::pressingAMassIsNoLift() {
    prepareMass("mass_pressed", [](psychophysics::StudyDesign& design) {
        design.trial.mustTouchAll = true;
        design.trial.probeAtLeast_N = 0.3;
        design.fidelity.peakForce_N = 2.0;
    });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::exploring, kPatience_ms);
    session::LiveSitting& live = *screen->live();
    QVERIFY(reach(live, -0.02, 0.050) && reach(live, -0.02, 0.031));
    QVERIFY(reach(live, -0.02, 0.029)); // 1.8 N and more, and not once in the air
    QTRY_VERIFY2_WITH_TIMEOUT(
        said(screen, "answer.why")
            .startsWith(QStringLiteral("Press the object less hard onto the table in this trial. You are "
                                       "holding object 1. Lift it off the table")),
        qPrintable(said(screen, "answer.why")), kPatience_ms);
    QCOMPARE(live.view().touched, 0U);
    QVERIFY(reach(live, -0.02, 0.045));
    QTRY_COMPARE_WITH_TIMEOUT(live.view().touched, 1U, kPatience_ms);
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// The steps of a hold; and whoever never let go reads how before anything counts.
void TestParticipantPage::theFreeMinuteTellsEachStep() {
    for (const bool letsGo : {false, true}) {
        prepareMass(letsGo ? "mass_free" : "mass_free_held");
        desktop::TrialsScreen* screen = sit();
        QVERIFY(screen && tests::pastTheCard(screen));
        QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::trying, kPatience_ms);
        session::LiveSitting& live = *screen->live();
        QTRY_VERIFY_WITH_TIMEOUT(
            said(screen, "answer.why").startsWith(QStringLiteral("Move the tool over a ring")), kPatience_ms);
        QVERIFY(reach(live, -0.02, 0.050) && reach(live, -0.02, 0.031) && reach(live, -0.02, 0.045));
        QTRY_VERIFY_WITH_TIMEOUT(
            said(screen, "answer.why").startsWith(QStringLiteral("You are lifting object 1.")), kPatience_ms);
        if (letsGo) {
            QVERIFY(reach(live, -0.02, 0.028) && reach(live, -0.02, 0.050));
            QTRY_VERIFY_WITH_TIMEOUT(
                said(screen, "answer.why").startsWith(QStringLiteral("You let go of object 1.")),
                kPatience_ms);
        }
        live.endTrying();
        QVERIFY(QTest::qWaitFor([&] { return live.view().state != State::trying; }, kPatience_ms));
        QVERIFY(tests::stopSitting(*m_site, screen));
    }
    prepareMass("mass_free_ends");
    desktop::TrialsScreen* screen = sit(true, 1.0); // ends by itself, and nothing was let go of
    QVERIFY(screen && tests::pastTheCard(screen));
    QTRY_COMPARE_WITH_TIMEOUT(said(screen, "break.title"), QStringLiteral("The free minute is over"),
                              kPatience_ms);
    QVERIFY2(said(screen, "break.text").contains(QStringLiteral("You have not let go of an object yet")) &&
                 said(screen, "break.text").contains(QStringLiteral("To put the object down")),
             qPrintable(said(screen, "break.text")));
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// Nobody is told to pull or to let go of what is stroked.
void TestParticipantPage::aPadIsStroked() {
    prepare("pads", [](psychophysics::StudyDesign& design) {
        design.conditions[0].stimulus.attribute = psychophysics::Attribute::friction;
        design.conditions[0].stimulus.reference = 0.3;
        design.trial.mustTouchAll = true;
    });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::pastTheCard(screen));
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::trying, kPatience_ms);
    session::LiveSitting& live = *screen->live();
    QTRY_VERIFY_WITH_TIMEOUT(said(screen, "answer.why").contains(QStringLiteral("lower it onto the object")),
                             kPatience_ms);
    QVERIFY(reach(live, -0.04, 0.010) && reach(live, -0.04, -0.001));
    QTRY_VERIFY_WITH_TIMEOUT(
        said(screen, "answer.why").contains(QStringLiteral("Move the mouse to stroke it")), kPatience_ms);
    const auto isFree = [&] {
        return said(screen, "answer.why").contains(QStringLiteral("The pointer is free: click in the scene"));
    };
    QVERIFY(!isFree());
    press(Qt::Key_T); // frees it, so that the mouse moves nothing
    QTRY_VERIFY_WITH_TIMEOUT(isFree(), kPatience_ms);
    QTest::mouseClick(page(screen)->findChild<desktop::PlacesView*>(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!isFree(), kPatience_ms);
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// The button of practice says what it takes back, for every task.
void TestParticipantPage::anAnswerThatIsTakenBackIsNamed() {
    using namespace psychophysics;
    const QLocale locale(QLocale::English);
    for (int task = 0; task < kTasks; ++task) {
        QStringList told;
        for (int answer = 0; answer < answers(static_cast<Task>(task)); ++answer) {
            const QString words =
                desktop::study_words::answer(static_cast<Task>(task), Attribute::mass, answer, 12.5, locale);
            QVERIFY2(!words.isEmpty() && !told.contains(words), qPrintable(words));
            told << words;
        }
        QVERIFY(
            desktop::study_words::answer(static_cast<Task>(task), Attribute::mass, -1, {}, locale).isEmpty());
    }
    QCOMPARE(desktop::study_words::answer(Task::rank3Ties, Attribute::mass, rankingOf({1, 0, 1}), {}, locale),
             QStringLiteral("2, 1 = 3"));
    prepareMass("take_back", [](psychophysics::StudyDesign& design) { design.trial.practiceTrials = 1; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    press(Qt::Key_2);
    QTRY_VERIFY_WITH_TIMEOUT(tests::sittingButton(screen, "trials.take_back")->isVisible(), kPatience_ms);
    QCOMPARE(tests::sittingButton(screen, "trials.take_back")->text(),
             QStringLiteral("Take back: 2 is heavier (⌫)"));
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// What the bar shows, and where its limit is, in its unit; the force itself has no number. Where force is
/// felt, there is no bar.
void TestParticipantPage::theForceBarIsLabelled() {
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    desktop::PlacesView view(theme, {});
    view.resize(640, 360);
    desktop::PlacesView::Now now;
    now.force_N = 2.345;
    now.limit_N = 3.5;
    for (const bool felt : {false, true}) {
        now.feltNothing = !felt;
        view.show({}, now);
        const QString drawn = tests::OutlineDevice::of(view).join(QLatin1Char('\n'));
        QCOMPARE(drawn.contains(QStringLiteral("\"Force\"")), !felt);
        QCOMPARE(drawn.contains(QStringLiteral("\"Limit: 3.5 N\"")), !felt);
        QVERIFY(!drawn.contains(QStringLiteral("2.345")) || felt);
    }
}

/// From the press of "Go" to the end of the free minute, also while its objects come and go.
void TestParticipantPage::nothingCountsBeforeTheTrials() {
    prepare("free_strip");
    desktop::TrialsScreen* screen = sit(true, 2.0);
    QVERIFY(screen && tests::pastTheCard(screen));
    QStringList told;
    const auto tried = [&] {
        if (const QString strip = said(screen, "trials.strip"); !told.contains(strip))
            told << strip;
        return screen->live()->view().state == State::tried;
    };
    QVERIFY(QTest::qWaitFor(tried, kPatience_ms));
    const QString all = told.join(QLatin1Char('\n'));
    QVERIFY2(all.contains(QStringLiteral("The free minute ends in")) &&
                 !all.contains(QStringLiteral("every answer counts")) &&
                 !all.contains(QStringLiteral("Trial 1")),
             qPrintable(all));
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// A key that moves the tool reads on while there is more to read, and begins nothing before all was read.
/// Nor does Space.
void TestParticipantPage::aLongCardIsReadBeforeItBegins() {
    prepare("long_card");
    m_site->window->resize(1280, 720);
    m_site->settings.setScale(2.0);
    m_site->context.applyAppearance();
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen);
    tests::sittingButton(screen, "break.button")->click();
    const auto* card = page(screen)->findChild<desktop::ReadyCard*>();
    QVERIFY(card && card->isVisible());
    const QScrollBar& bar =
        *card->findChild<QScrollArea*>(QStringLiteral("training.ready.page"))->verticalScrollBar();
    QTRY_VERIFY_WITH_TIMEOUT(bar.maximum() > 0, kPatience_ms);
    for (const int early : {int(Qt::Key_Right), int(Qt::Key_Up)})
        press(early);
    QVERIFY(page(screen)->findChild<desktop::ReadyCard*>() == card && card->isVisible());
    QVERIFY(pressUntil(Qt::Key_Space, [&] { return bar.value() > 0; }));
    QVERIFY(card->isVisible());
    for (int presses = 0; presses < 50 && bar.value() < bar.maximum(); ++presses)
        press(Qt::Key_PageDown);
    QCOMPARE(bar.value(), bar.maximum());
    QCOMPARE(screen->live()->view().state, State::paused);
    press(Qt::Key_Down); // no more to read: it moves the tool
    QTRY_VERIFY_WITH_TIMEOUT(screen->live()->view().state != State::paused, kPatience_ms);
    QVERIFY(tests::stopSitting(*m_site, screen));
    m_site->settings.setScale(1.0);
    m_site->context.applyAppearance();
}

/// Enter and Space show the rest of a page that is longer than the window, and go on once its end was seen.
void TestParticipantPage::aLongInstructionIsReadBeforeItEnds() {
    const auto look = [this](double scale) {
        m_site->window->resize(1280, 720);
        m_site->settings.setScale(scale);
        m_site->context.applyAppearance();
    };
    for (const int key : {int(Qt::Key_Return), int(Qt::Key_Space)}) {
        prepare(key == Qt::Key_Space ? "long_by_space" : "long_by_enter",
                [](psychophysics::StudyDesign& design) {
                    std::string& words = design.instructions["en"];
                    for (int i = 0; i < 12; ++i)
                        words += " Explore each of them with calm and steady movements.";
                });
        look(2.0);
        desktop::TrialsScreen* screen = sit();
        QVERIFY(screen);
        const auto* text = page(screen)->findChild<QLabel*>(QStringLiteral("break.text"));
        const QScrollArea* area = nullptr;
        for (const QWidget* part = text; part && !area; part = part->parentWidget())
            area = qobject_cast<const QScrollArea*>(part);
        QVERIFY(area);
        const QScrollBar& bar = *area->verticalScrollBar();
        QTRY_VERIFY_WITH_TIMEOUT(bar.maximum() > 0, kPatience_ms);
        const auto* more = page(screen)->findChild<QLabel*>(QStringLiteral("break.read_on"));
        QTRY_VERIFY_WITH_TIMEOUT(more->isVisible(), kPatience_ms);
        const auto card = [&] { return page(screen)->findChild<desktop::ReadyCard*>(); };
        bool endSeen = false;
        QVERIFY(pressUntil(key, [&] {
            endSeen = endSeen || bar.value() >= bar.maximum();
            return card() != nullptr;
        }));
        QVERIFY(endSeen);
        QVERIFY(tests::stopSitting(*m_site, screen));
    }
    look(1.0);
}

/// At 200 % in the smallest window: every line has its height, nothing lies over anything else, and the scene
/// can be worked in.
void TestParticipantPage::nothingIsCutWithLargeTexts() {
    for (const bool apex : {false, true}) {
        const auto large = [apex](psychophysics::StudyDesign& design) {
            design.trial.mustTouchAll = true;
            if (apex)
                design.conditions = tests::apexStudy("large", 4).conditions;
        };
        apex ? prepare("large_apex", large) : prepareMass("large_mass", large);
        m_site->window->resize(1280, 720);
        m_site->settings.setScale(2.0);
        m_site->context.applyAppearance();
        desktop::TrialsScreen* screen = sit();
        QVERIFY(screen && tests::pastTheCard(screen));
        QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::trying, kPatience_ms);
        QTest::qWait(200); // until the layout rests
        const QWidget* all = page(screen);
        QCOMPARE(all->window()->size(), QSize(1280, 720));
        std::vector<std::pair<QRect, QString>> lines;
        for (const QLabel* label : all->findChildren<QLabel*>())
            if (label->isVisible() && !label->text().trimmed().isEmpty()) {
                QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
                lines.push_back({QRect(label->mapTo(all, QPoint()), label->size()), label->text()});
            }
        for (const QPushButton* button : all->findChildren<QPushButton*>())
            if (button->isVisible()) {
                QVERIFY2(button->height() >= button->minimumSizeHint().height(), qPrintable(button->text()));
                lines.push_back({QRect(button->mapTo(all, QPoint()), button->size()), button->text()});
            }
        for (std::size_t i = 0; i < lines.size(); ++i) {
            QVERIFY2(all->rect().contains(lines[i].first), qPrintable(lines[i].second));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY2(!lines[i].first.intersects(lines[j].first),
                         qPrintable(lines[i].second + QStringLiteral(" | ") + lines[j].second));
        }
        const auto* scene =
            all->findChild<QWidget*>(apex ? QStringLiteral("scene.flat") : QStringLiteral("trials.places"));
        QVERIFY(scene);
        QVERIFY2(scene->height() >= 200, qPrintable(QString::number(scene->height())));
        QVERIFY(tests::stopSitting(*m_site, screen));
        m_site->settings.setScale(1.0);
        m_site->context.applyAppearance();
    }
}

/// Whoever has done a part has read the instructions: the next one begins with a short page, and all of it is
/// a press away.
void TestParticipantPage::aFurtherPartIsShort() {
    prepare("parts", [](psychophysics::StudyDesign& design) {
        design.blindParticipant = false;
        design.instructions = {{"en", "The whole instruction of the study."}};
        design.questionnaires.clear();
        design.conditions[0].task = psychophysics::Task::twoAfc;
        design.conditions[0].procedures = {
            psychophysics::ConstantSpec{{design.conditions[0].stimulus.differences.back()}, 1, true}};
        design.conditions.push_back(design.conditions[0]);
        design.conditions[1].id = "second";
        design.conditions[1].title = {{"en", "Second"}};
        design.conditions[0].instructions = {{"en", "Wear no glove."}};
        design.conditions[1].instructions = {{"en", "Put on the glove."}};
    });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && screen->live()->view().firstPart);
    const auto partText = [&] {
        return QString::fromStdString(screen->live()->condition().instructions.at("en"));
    };
    const auto said = [&](const char* name) {
        return page(screen)->findChild<QLabel*>(QLatin1String(name))->text();
    };
    QCOMPARE(said("break.title"), QStringLiteral("Before you begin"));
    QVERIFY(said("break.text").contains(QStringLiteral("The whole instruction")));
    QVERIFY2(said("break.text").endsWith(QStringLiteral("\n\n") + partText()),
             qPrintable(said("break.text")));
    const QString first = partText();
    QVERIFY(tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    QTRY_COMPARE_WITH_TIMEOUT(said("trials.strip"),
                              QStringLiteral("Trial 1 of 1. From now on every answer counts."),
                              kPatience_ms); // neither more nor fewer
    tests::sittingButton(screen, "answer.0")->click();
    QTRY_VERIFY_WITH_TIMEOUT(screen->live()->finished() && !screen->isBusy(), kPatience_ms);
    QVERIFY(screen->live()->result() && screen->live()->result()->completed);
    QCOMPARE(said("break.title"), QStringLiteral("This part is finished"));
    QVERIFY2(said("break.text").contains(QStringLiteral("who decides when it begins")),
             qPrintable(said("break.text")));
    m_site->go(QStringLiteral("studies"));
    screen = sit();
    QVERIFY(screen && !screen->live()->view().firstPart);
    QCOMPARE(said("break.title"), QStringLiteral("The next part"));
    QVERIFY(partText() != first);
    QVERIFY2(said("break.text")
                 .startsWith(
                     partText() +
                     QStringLiteral("\n\nApart from this, you explore and answer as in the previous part")),
             qPrintable(said("break.text")));
    QVERIFY(!said("break.text").contains(QStringLiteral("The whole instruction")));
    QVERIFY2(said("break.text").contains(QStringLiteral("more than 4\u00a0N")),
             qPrintable(said("break.text")));
    m_site->window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_site->window.get()));
    auto* more = tests::sittingButton(screen, "break.more");
    QVERIFY(pressUntil(Qt::Key_Return, [more] {
        if (!more->isHidden())
            more->setFocus(Qt::TabFocusReason);
        return more->isHidden();
    }));
    press(Qt::Key_Return); // the second of two, which would skip what was asked for
    QVERIFY(!page(screen)->findChild<desktop::ReadyCard*>());
    QVERIFY(said("break.text").contains(QStringLiteral("The whole instruction")) &&
            said("break.text").contains(partText()));
    QVERIFY(tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    tests::sittingButton(screen, "answer.0")->click();
    QTRY_VERIFY_WITH_TIMEOUT(screen->live()->finished() && !screen->isBusy(), kPatience_ms);
    QCOMPARE(said("break.title"), QStringLiteral("Everything is finished"));
}

/// Enter pressed twice on "Begin" leaves the instructions there, and pressed twice on them the card.
void TestParticipantPage::aSecondPressSkipsNoInstruction() {
    prepare("second_press");
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen);
    const auto card = [&] { return page(screen)->findChild<desktop::ReadyCard*>(); };
    press(Qt::Key_Return);
    press(Qt::Key_Space);
    QVERIFY(!card());
    QCOMPARE(said(screen, "break.title"), QStringLiteral("Before you begin"));
    QVERIFY(pressUntil(Qt::Key_Return, [&] { return card() != nullptr; }));
    press(Qt::Key_Return);
    QVERIFY(card());
    QCOMPARE(screen->live()->view().state, State::paused);
    QVERIFY(pressUntil(Qt::Key_Return, [&] { return !card(); }));
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// Nothing counts, and nothing is presented, before the card was read and the minute is over; the minute can
/// be ended at once.
void TestParticipantPage::theCardAndTheFreeMinuteComeFirst() {
    prepare("card");
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen);
    tests::sittingButton(screen, "break.button")->click();
    const auto* card = page(screen)->findChild<desktop::ReadyCard*>();
    QVERIFY(card && card->isVisible());
    QVERIFY2(told(*card).contains(QStringLiteral("free minute")), qPrintable(told(*card)));
    QCOMPARE(screen->live()->view().state, State::paused);
    tests::sittingButton(screen, "training.ready.go")->click();
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::trying, kPatience_ms);
    QVERIFY(!screen->live()->view().canAnswer);
    QVERIFY(screen->live()->view().tryLeft_s > 0.0);
    QTRY_VERIFY_WITH_TIMEOUT(page(screen)
                                 ->findChild<QLabel*>(QStringLiteral("trials.strip"))
                                 ->text()
                                 .contains(QStringLiteral("Nothing counts yet")),
                             kPatience_ms);
    QVERIFY(stored().empty());
    tests::sittingButton(screen, "trials.enough")->click();
    QVERIFY(canAnswer(screen));
    QVERIFY(stored().empty()); // the minute is of no trial
    QVERIFY(!tests::sittingButton(screen, "trials.enough")->isVisible());
    QVERIFY(tests::stopSitting(*m_site, screen));
    const auto trials = stored(); // the one at hand: a run that is gone on with has no free minute
    QCOMPARE(trials.size(), std::size_t(1));
    screen = sit();
    QVERIFY(screen);
    QCOMPARE(screen->live()->view().tryLeft_s, 0.0);
    QVERIFY(tests::pastTheCard(screen));
    QVERIFY(canAnswer(screen));
}

void TestParticipantPage::aClickInTheSceneAnswersNothing() {
    prepare("click", [](psychophysics::StudyDesign& design) {
        design.conditions[0].task = psychophysics::Task::twoAfc;
        design.conditions[0].procedures = {
            psychophysics::ConstantSpec{{design.conditions[0].stimulus.differences.back()}, 10, true}};
    });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    auto* scene = page(screen)->findChild<desktop::PlacesView*>();
    for (int i = 0; i < 5; ++i) {
        QTest::mouseClick(scene, Qt::LeftButton);
        QTest::qWait(60);
    }
    QVERIFY(screen->live()->view().canAnswer);
    QVERIFY(stored().empty());
    QTest::keyClick(m_site->window.get(), Qt::Key_1);
    QTRY_COMPARE_WITH_TIMEOUT(stored().size(), std::size_t(1), kPatience_ms);
}

/// A slip in practice is no practice: the presentation is kept as taken back, and comes again.
void TestParticipantPage::practiceIsTakenBack() {
    prepare("practice", [](psychophysics::StudyDesign& design) { design.trial.practiceTrials = 1; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    const auto answer = [&] {
        if (!canAnswer(screen))
            return false;
        for (const char* button : {"answer.2", "answer.0", "answer.confirm"})
            tests::sittingButton(screen, button)->click();
        return QTest::qWaitFor([&] { return screen->live()->view().mayTakeBack; }, kPatience_ms);
    };
    QVERIFY(answer());
    QVERIFY(screen->live()->view().practice);
    QTRY_VERIFY_WITH_TIMEOUT(tests::sittingButton(screen, "trials.take_back")->isVisible(), kPatience_ms);
    QTest::qWait(4500); // nothing goes on by itself, however long somebody thinks
    QVERIFY(tests::sittingButton(screen, "trials.take_back")->isVisible() &&
            tests::sittingButton(screen, "trials.enough")->isVisible());
    QVERIFY(stored().empty());
    tests::sittingButton(screen, "trials.take_back")->click();
    QTRY_COMPARE_WITH_TIMEOUT(stored().size(), std::size_t(1), kPatience_ms);
    QCOMPARE(stored().front().spoiled, std::string("taken_back"));
    QCOMPARE(stored().front().answer, -1);
    QVERIFY(stored().front().practice);
    QVERIFY(answer());                                      // practice again
    tests::sittingButton(screen, "trials.enough")->click(); // enough of the feedback
    QTRY_COMPARE_WITH_TIMEOUT(stored().size(), std::size_t(2), kPatience_ms);
    QVERIFY(stored().back().practice && stored().back().answer >= 0);
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::practised,
                              kPatience_ms); // nothing that counts comes before it was read
    const auto* over = page(screen)->findChild<QLabel*>(QStringLiteral("break.text"));
    QTRY_VERIFY2_WITH_TIMEOUT(over->text().contains(QStringLiteral("From now on every answer counts")),
                              qPrintable(over->text()), kPatience_ms);
    QVERIFY(!screen->live()->view().canAnswer);
    tests::sittingButton(screen, "break.button")->click();
    QVERIFY(canAnswer(screen));
    const auto* strip = page(screen)->findChild<QLabel*>(QStringLiteral("trials.strip"));
    QTRY_COMPARE_WITH_TIMEOUT(strip->text(),
                              QStringLiteral("Trial 1 of at most 40. From now on every answer counts."),
                              kPatience_ms);
    QVERIFY(!screen->live()->view().practice);
    for (const char* button : {"answer.2", "answer.0", "answer.confirm"})
        tests::sittingButton(screen, button)->click();
    QTRY_COMPARE_WITH_TIMEOUT(stored().size(), std::size_t(3), kPatience_ms);
    QVERIFY(!screen->live()->view().mayTakeBack); // what counts, counts
    QTRY_COMPARE_WITH_TIMEOUT(strip->text(), QStringLiteral("Trial 2 of at most 40"), kPatience_ms);
}

/// Whoever paused or ended what stood there: the key was meant for that. Once the page was seen, the same key
/// goes on.
void TestParticipantPage::aPageThatComesByItselfTakesNoEarlyKey() {
    prepare("early_keys");
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Space}) {
        desktop::TrialsScreen* screen = sit(true, 1.0);
        QVERIFY(screen);
        const bool first =
            screen->live()->view().tryLeft_s > 0.0; // a run that is gone on with has no free minute
        auto* title = page(screen)->findChild<QLabel*>(QStringLiteral("break.title"));
        const auto staysAt = [&](const char* shown, State state) {
            const PressesTooEarly early(*title, QLatin1String(shown), *m_site->window, key);
            if (state == State::paused)
                screen->live()->pause(); // as the experimenter does
            if (!QTest::qWaitFor([&] { return early.pressed(); }, kPatience_ms))
                return false;
            QTest::qWait(200);
            return screen->live()->view().state == state &&
                   pressUntil(key, [&] { return screen->live()->view().state != state; });
        };
        QVERIFY(first ? tests::pastTheCard(screen) : tests::beginTrials(screen));
        if (first)
            QVERIFY(staysAt("The free minute is over", State::tried));
        QVERIFY(canAnswer(screen));
        QVERIFY(staysAt("Paused", State::paused));
        QVERIFY(canAnswer(screen));
        QVERIFY(stored().size() == (first ? 0U : 1U)); // the one that the stop interrupted
        QVERIFY(tests::stopSitting(*m_site, screen));
    }
}

/// What to do is said while there is time to do it, and until the trial ends: where it came and went with the
/// force, it would tell objects apart. What is missing is said beside it.
void TestParticipantPage::theHandIsToldBeforeTheLimit() {
    prepare("limit", [](psychophysics::StudyDesign& design) {
        design.trial.mustTouchAll = true;
        design.trial.exploreLimit_s = 0.0;
        design.trial.probeAtLeast_N = 0.0;
        design.fidelity.peakForce_N = 2.0;
    });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::exploring, kPatience_ms);
    session::LiveSitting& live = *screen->live();
    auto* why = page(screen)->findChild<QLabel*>(QStringLiteral("answer.why"));
    QVERIFY(reach(live, -0.04, 0.060) && reach(live, -0.04, 0.027)); // in the ring of the first
    QVERIFY(reach(live, -0.04, 0.031));                              // less than 1 N
    QTRY_VERIFY2_WITH_TIMEOUT(why->text().startsWith(QStringLiteral("You are holding object 1.")),
                              qPrintable(why->text()), kPatience_ms);
    QVERIFY(reach(live, -0.04, 0.036)); // 1.8 N and more
    const QString told = QStringLiteral("Pull less hard in this trial.");
    QTRY_VERIFY2_WITH_TIMEOUT(why->text().startsWith(told + QStringLiteral(" You are holding object 1.")),
                              qPrintable(why->text()), kPatience_ms);
    QVERIFY(why->text().endsWith(QStringLiteral("Pull next: 2, 3.")));
    QVERIFY(reach(live, -0.04, 0.031));
    QTest::qWait(100); // some frames
    QVERIFY2(why->text().startsWith(told), qPrintable(why->text()));
    live.spoil();
    QTRY_COMPARE_WITH_TIMEOUT(live.numbers().spoiled, 1, kPatience_ms);
    QVERIFY(reach(live, -0.04, 0.060)); // off, so that the trial comes again
    QTRY_VERIFY2_WITH_TIMEOUT(why->text().startsWith(QStringLiteral("Pull first: 1, 2, 3.")),
                              qPrintable(why->text()), kPatience_ms);
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// The trial at hand was interrupted, and nothing was wrong with it: it comes again, and is no repeat.
void TestParticipantPage::aStopRepeatsNothing() {
    prepare("interrupted");
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    QVERIFY(tests::stopSitting(*m_site, screen));
    QCOMPARE(stored().size(), std::size_t(1));
    screen = sit();
    QVERIFY(screen);
    QCOMPARE(screen->live()->numbers().spoiled, 0);
    QVERIFY(tests::stopSitting(*m_site, screen));
    auto connection = m_site->database().openReader();
    database::StudyReader reader(**connection, m_site->context.actor());
    const auto analysis = session::analyseStudy(reader, m_study, 1);
    QVERIFY(analysis);
    QCOMPARE(analysis->conditions.front().runs.front().spoiled, 0);
    QVERIFY(analysis->quality.front().spoiled.empty());
}

/// Said while the trial is done again, and gone with the next that counts. The count stands still, and
/// somebody reads why.
void TestParticipantPage::aTrialThatDoesNotCountIsTold() {
    for (const bool list : {false, true}) {
        prepare(list ? "told_list" : "told", [list](psychophysics::StudyDesign& design) {
            if (!list)
                return;
            design.conditions[0].task = psychophysics::Task::twoAfc;
            design.conditions[0].procedures = {
                psychophysics::ConstantSpec{{design.conditions[0].stimulus.differences.back()}, 10, true}};
        });
        desktop::TrialsScreen* screen = sit();
        QVERIFY(screen && tests::beginTrials(screen));
        QVERIFY(canAnswer(screen));
        QVERIFY(said(screen, "trials.repeated").isEmpty());
        screen->live()->spoil();
        QTRY_COMPARE_WITH_TIMEOUT(screen->live()->numbers().spoiled, 1, kPatience_ms);
        QVERIFY(canAnswer(screen));
        const QString expected =
            QStringLiteral("The last trial did not count. The experimenter discarded it. ") +
            (list ? QStringLiteral("It comes again later.") : QStringLiteral("The same objects come again."));
        QTRY_COMPARE_WITH_TIMEOUT(said(screen, "trials.repeated"), expected, kPatience_ms);
        QVERIFY(said(screen, "trials.strip").startsWith(QStringLiteral("Trial 1 of")));
        for (const char* button : {"answer.2", "answer.0", "answer.confirm"})
            if (auto* answer = tests::sittingButton(screen, button))
                answer->click();
        QTRY_COMPARE_WITH_TIMEOUT(screen->live()->numbers().scored, 1, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(said(screen, "trials.repeated").isEmpty(), kPatience_ms);
        QVERIFY(tests::stopSitting(*m_site, screen));
    }
}

/// In every language, and of whether an answer was right they tell nothing.
void TestParticipantPage::everyReasonHasWords() {
    using desktop::Handling;
    const QLocale locale(QLocale::English);
    using Missed = session::LiveStudyView::Missed;
    const auto words = [&](const char* reason, Handling handling, Missed missed = Missed::none) {
        return desktop::TrialsScreen::repeatedWords(reason, missed, handling, 0.3, locale);
    };
    for (const Handling handling : {Handling::press, Handling::stroke, Handling::pull, Handling::lift}) {
        QStringList told;
        for (const char* reason :
             {"untouched", "speed", "peak_force", "time", "experimenter", "late_ticks"}) {
            const QString said = words(reason, handling);
            QVERIFY2(!said.isEmpty() && !said.contains(QLatin1Char('_')) && !told.contains(said), reason);
            for (const char* never : {"right", "wrong", "correct", "mistake"})
                QVERIFY2(!said.contains(QLatin1String(never), Qt::CaseInsensitive), qPrintable(said));
            told << said;
        }
        for (const char* device : {"saturation", "force_error",
                                   "stiffness_error"}) // which limit it was might tell what the object was
            QCOMPARE(words(device, handling), told.back());
    }
    // The movement that was too hard is called by its name.
    QVERIFY(words("peak_force", Handling::pull).contains(QStringLiteral("pulled")));
    QVERIFY(words("peak_force", Handling::press).contains(QStringLiteral("pressed too hard")));
    QVERIFY(words("peak_force", Handling::lift).contains(QStringLiteral("onto the table")));
    // A force is named only where it was too small, and letting go only where something was held.
    for (const Handling handling : {Handling::press, Handling::stroke, Handling::pull, Handling::lift})
        for (const Missed missed : {Missed::none, Missed::never, Missed::tooLight, Missed::held}) {
            const QString said = words("untouched", handling, missed);
            QCOMPARE(said.contains(QStringLiteral("0.3 N")),
                     missed == Missed::tooLight && handling != Handling::lift);
            QCOMPARE(said.contains(QStringLiteral("still holding")), missed == Missed::held);
            QCOMPARE(said.contains(QStringLiteral("lift")), handling == Handling::lift);
        }
}

/// Whoever lifts an object and never lets go of it reads that, in practice as well, and not that a force was
/// too small; whoever touches nothing reads that.
void TestParticipantPage::theReasonThatHeldIsTold() {
    using Missed = session::LiveStudyView::Missed;
    for (const bool holds : {true, false}) {
        prepareMass(holds ? "mass_held" : "mass_never", [](psychophysics::StudyDesign& design) {
            design.trial.mustTouchAll = true;
            design.trial.probeAtLeast_N = 0.3;
            design.trial.exploreLimit_s = 5.0;
            design.trial.practiceTrials = 1;
        });
        desktop::TrialsScreen* screen = sit();
        QVERIFY(screen && tests::beginTrials(screen));
        QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::exploring, kPatience_ms);
        session::LiveSitting& live = *screen->live();
        QVERIFY(live.view().practice);
        if (holds)
            QVERIFY(reach(live, -0.02, 0.050) && reach(live, -0.02, 0.031) && reach(live, -0.02, 0.045));
        QTRY_COMPARE_WITH_TIMEOUT(live.view().unanswered, std::string("untouched"), kPatience_ms);
        QVERIFY(live.view().missed == (holds ? Missed::held : Missed::never));
        QTRY_COMPARE_WITH_TIMEOUT(
            said(screen, "trials.repeated"),
            holds ? QStringLiteral("The time ended while you were still holding an object: put it down and "
                                   "let go of it to lift the next one. This practice trial comes again.")
                  : QStringLiteral("The time ended before every object was lifted. This practice trial comes "
                                   "again."),
            kPatience_ms);
        QVERIFY(!said(screen, "answer.why").contains(QStringLiteral("Lift the tool off")));
        QVERIFY(tests::stopSitting(*m_site, screen));
    }
}

/// Practice asks for Next and offers to take back; the page after it says that the trials that count do not.
/// Without practice, the page after the free minute does.
void TestParticipantPage::howTrialsGoOnIsSaidBeforeTheyCount() {
    prepare("no_practice", [](psychophysics::StudyDesign& design) { design.trial.practiceTrials = 0; });
    desktop::TrialsScreen* screen = sit(true, 1.0);
    QVERIFY(screen && tests::pastTheCard(screen));
    QTRY_COMPARE_WITH_TIMEOUT(said(screen, "break.title"), QStringLiteral("The free minute is over"),
                              kPatience_ms);
    QString text = said(screen, "break.text");
    QVERIFY2(text.contains(QStringLiteral("next trial comes by itself")) &&
                 text.contains(QStringLiteral("no answer can be taken back")) &&
                 !text.contains(QStringLiteral("ractice")),
             qPrintable(text));
    QVERIFY(tests::stopSitting(*m_site, screen));
    prepareMass("after_practice",
                [](psychophysics::StudyDesign& design) { design.trial.practiceTrials = 1; });
    screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    press(Qt::Key_2);
    QTRY_VERIFY_WITH_TIMEOUT(screen->live()->view().mayTakeBack, kPatience_ms);
    QVERIFY(pressUntil(Qt::Key_Return, [&] { return screen->live()->view().state == State::practised; }));
    QTRY_COMPARE_WITH_TIMEOUT(said(screen, "break.title"), QStringLiteral("Practice is over"), kPatience_ms);
    text = said(screen, "break.text");
    QVERIFY2(text.contains(QStringLiteral("Unlike in practice, the next trial comes by itself")) &&
                 text.contains(QStringLiteral("no answer can be taken back")),
             qPrintable(text));
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// Nobody is told that Esc stops a force where there is none.
void TestParticipantPage::stopWordsFollowTheDevice() {
    using namespace psychophysics;
    const auto keys = [](bool felt) {
        return desktop::studyKeys(Task::twoAfc, Attribute::mass, desktop::StudyHand{true, felt});
    };
    QVERIFY2(keys(true).contains(QStringLiteral("Esc stops force")), qPrintable(keys(true)));
    QVERIFY2(keys(false).contains(QStringLiteral("Esc stops the trial")) &&
                 !keys(false).contains(QStringLiteral("force")),
             qPrintable(keys(false)));
    prepare("stop_words");
    desktop::TrialsScreen* screen = sit(); // with mouse and keyboard
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    for (const QString& text : {screen->help(), tests::sittingButton(screen, "trials.stop")->toolTip()})
        QVERIFY2(!text.contains(QStringLiteral("force")), qPrintable(text));
    for (const desktop::ScreenCommand& command : screen->commands())
        QVERIFY2(!command.text.contains(QStringLiteral("force")), qPrintable(command.text));
    press(Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(said(screen, "break.title"), QStringLiteral("The trial is stopped"),
                              kPatience_ms);
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// Every page on which nothing else is to be done, from the instructions to the first trial that counts.
void TestParticipantPage::enterAndSpaceGoOn() {
    for (const int key : {int(Qt::Key_Return), int(Qt::Key_Space)}) {
        prepare(key == Qt::Key_Space ? "by_space" : "by_enter",
                [](psychophysics::StudyDesign& design) { design.trial.practiceTrials = 1; });
        desktop::TrialsScreen* screen = sit(true, 1.0);
        QVERIFY(screen);
        QCOMPARE(said(screen, "break.title"), QStringLiteral("Before you begin"));
        const auto card = [&] { return page(screen)->findChild<desktop::ReadyCard*>(); };
        QVERIFY(pressUntil(key, [&] { return card() != nullptr; }));
        QVERIFY(pressUntil(key, [&] { return !card(); }));
        QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::tried,
                                  kPatience_ms); // the free minute ends by itself
        QTRY_COMPARE_WITH_TIMEOUT(said(screen, "break.title"), QStringLiteral("The free minute is over"),
                                  kPatience_ms);
        QVERIFY(pressUntil(key, [&] { return screen->live()->view().state != State::tried; }));
        QVERIFY(canAnswer(screen));
        QVERIFY(screen->live()->view().practice && stored().empty());
        for (const char* button : {"answer.2", "answer.0", "answer.confirm"})
            tests::sittingButton(screen, button)->click();
        QTRY_VERIFY_WITH_TIMEOUT(screen->live()->view().mayTakeBack, kPatience_ms);
        QVERIFY(pressUntil(Qt::Key_Return, [&] {
            return screen->live()->view().state == State::practised;
        })); // here another thing can be done, so Space pauses
        QTRY_COMPARE_WITH_TIMEOUT(said(screen, "break.title"), QStringLiteral("Practice is over"),
                                  kPatience_ms);
        QVERIFY(pressUntil(key, [&] { return screen->live()->view().state != State::practised; }));
        QVERIFY(canAnswer(screen));
        QCOMPARE(stored().size(), std::size_t(1));
        QVERIFY(tests::stopSitting(*m_site, screen));
    }
}

/// The field of the number is disabled while the answer is told: Enter goes on there, and nothing else.
void TestParticipantPage::enterAfterANumberCallsNobody() {
    prepare("number", [](psychophysics::StudyDesign& design) {
        design.trial.practiceTrials = 2;
        design.conditions[0].task = psychophysics::Task::magnitude;
        design.conditions[0].procedures = {
            psychophysics::ConstantSpec{{design.conditions[0].stimulus.differences.back()}, 10, true}};
    });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    auto* number = page(screen)->findChild<QLineEdit*>(QStringLiteral("answer.number"));
    QVERIFY(number);
    for (std::size_t trial = 1; trial <= 2; ++trial) {
        QVERIFY(canAnswer(screen));
        QTRY_VERIFY_WITH_TIMEOUT(number->window()->focusWidget() == number, kPatience_ms);
        QTest::keyClicks(number, QStringLiteral("12"));
        QTest::keyClick(number, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!number->isEnabled(), kPatience_ms);
        QVERIFY(!qobject_cast<QAbstractButton*>(m_site->window->focusWidget()));
        QVERIFY(pressUntil(Qt::Key_Return, [&] { return stored().size() == trial; }));
        QVERIFY(!m_site->find<QLineEdit>(QStringLiteral("gate.password")));
    }
    QVERIFY(tests::sittingButton(screen, "trials.experimenter")->focusPolicy() == Qt::NoFocus);
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// From what plays and from the limits by which trials are judged, not from the frozen text.
void TestParticipantPage::whatTheStationDoesIsSaid() {
    const QLocale locale(QLocale::English);
    psychophysics::StudyDesign design = tests::smallStudy("says");
    design.trial.maskingSound = true;
    design.fidelity.peakForce_N = 3.5;
    design.fidelity.meanSpeed_m_per_s = 0.08;
    const psychophysics::Condition& tube = design.conditions[0];
    const QString heard = desktop::sittingSentences(design, tube, true, locale);
    const QString silent = desktop::sittingSentences(design, tube, false, locale);
    QVERIFY2(heard.contains(QStringLiteral("noise")) && heard.endsWith(silent), qPrintable(heard));
    QVERIFY2(!silent.contains(QStringLiteral("noise")) && silent.startsWith(QStringLiteral("Pull")) &&
                 silent.contains(QStringLiteral("3.5\u00a0N")) && // not parted by the end of a line
                 silent.contains(QStringLiteral("8\u00a0cm per second")),
             qPrintable(silent));
    psychophysics::Condition pad = tube;
    pad.stimulus.attribute = psychophysics::Attribute::friction;
    QVERIFY(desktop::sittingSentences(design, pad, false, locale).startsWith(QStringLiteral("Press")));
    // Whoever consents reads the same limits, and how hard the device can push.
    const QString english = QStringLiteral("en");
    for (const desktop::StudyDevice& device :
         {desktop::StudyDevice{}, desktop::StudyDevice{true, 3.25}, desktop::StudyDevice{true, {}}}) {
        const QString told = desktop::forceSentences(design, device, english).join(u' ');
        QVERIFY2(told.endsWith(desktop::limitSentences(design, english).join(u' ')) && told.contains(silent),
                 qPrintable(told));
        QCOMPARE(told.contains(QStringLiteral("renders no force")), !device.rendersForce);
        QCOMPARE(told.contains(QStringLiteral("at most 3.25\u00a0N")), device.largestForce_N.has_value());
    }
    // Nobody is told to touch what is lifted.
    psychophysics::StudyDesign masses = design;
    masses.trial.mustTouchAll = true;
    masses.trial.probeAtLeast_N = 0.3;
    for (psychophysics::Condition& condition : masses.conditions) {
        condition.stimulus.attribute = psychophysics::Attribute::mass;
        condition.task = psychophysics::Task::twoAfc;
    }
    const QString lifts = desktop::participantSentences(masses, english).join(u' ');
    QVERIFY2(lifts.contains(QStringLiteral("Lift every object")) && !lifts.contains(QStringLiteral("ouch")) &&
                 !lifts.contains(QStringLiteral("graze")),
             qPrintable(lifts));
    masses.conditions.front().stimulus.attribute = psychophysics::Attribute::friction;
    QVERIFY(desktop::participantSentences(masses, english)
                .join(u' ')
                .contains(QStringLiteral("Explore every object before you answer")));
    QVERIFY(!desktop::participantSentences(design, QStringLiteral("en"))
                 .join(QLatin1Char(' '))
                 .contains(QStringLiteral("noise")));

    const QByteArray before = qgetenv("CHIRON_NO_SOUND");
    qputenv("CHIRON_NO_SOUND", "1");
    prepare("says", [&](psychophysics::StudyDesign& made) {
        made.trial.maskingSound = true;
        made.fidelity.peakForce_N = design.fidelity.peakForce_N;
        made.fidelity.meanSpeed_m_per_s = design.fidelity.meanSpeed_m_per_s;
    });
    desktop::TrialsScreen* screen = sit();
    before.isEmpty() ? qunsetenv("CHIRON_NO_SOUND") : qputenv("CHIRON_NO_SOUND", before);
    QVERIFY(screen);
    QVERIFY2(said(screen, "break.text").contains(silent) &&
                 !said(screen, "break.text").contains(QStringLiteral("noise")),
             qPrintable(said(screen, "break.text")));
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// A frozen text says what it said; what is read of it is what applies now.
void TestParticipantPage::anEarlierVersionsNoiseIsNotShown() {
    const std::map<std::string, std::string> noise{
        {"en", "During the trials you hear a steady noise."},
        {"de", "Während der Durchgänge hören Sie ein gleichmäßiges Rauschen."},
        {"el", "Κατά τις δοκιμές ακούτε έναν σταθερό θόρυβο."}};
    psychophysics::StudyDesign design = tests::smallStudy("former");
    design.ownInstructions = psychophysics::StudyText{{"en", noise.at("en") + " So I say."}};
    for (const auto& [language, sentence] : noise)
        design.instructions[language] = "One. " + sentence + " Two.";
    design.instructions["en"] = design.ownInstructions->at("en") + "\n\nOne. " + noise.at("en");
    const psychophysics::StudyText shown = desktop::shownInstructions(design);
    QCOMPARE(shown.at("en"), design.ownInstructions->at("en") + "\n\nOne."); // the researcher's words stay
    QCOMPARE(shown.at("de"), std::string("One. Two."));
    QCOMPARE(shown.at("el"), std::string("One. Two."));
    design.ownInstructions.reset(); // all of it is the researcher's
    QVERIFY(desktop::shownInstructions(design) == design.instructions);

    prepare("former", [&](psychophysics::StudyDesign& made) {
        made.ownInstructions = psychophysics::StudyText{{"en", "Hold it lightly."}};
        made.instructions = {{"en", "Hold it lightly.\n\nOne. " + noise.at("en") + " Two."}};
    });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen);
    QVERIFY2(said(screen, "break.text").startsWith(QStringLiteral("Hold it lightly.\n\nOne. Two.")),
             qPrintable(said(screen, "break.text")));
    QVERIFY(QString::fromStdString(screen->live()->design().instructions.at("en"))
                .contains(QStringLiteral("steady noise"))); // as it was frozen
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// The experimenter reads why the run is not done; the participant, that it is not.
void TestParticipantPage::aSessionThatEndsByItselfIsTold() {
    prepare("by_itself");
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    screen->live()->training().post(core::CommandKind::end);
    QTRY_VERIFY_WITH_TIMEOUT(screen->live()->finished() && !screen->isBusy(), kPatience_ms);
    QCOMPARE(said(screen, "break.title"), QStringLiteral("The session was stopped"));
    QVERIFY2(said(screen, "break.text").contains(QStringLiteral("Please call the experimenter")),
             qPrintable(said(screen, "break.text")));
    QVERIFY(!qobject_cast<QAbstractButton*>(m_site->window->focusWidget())); // no key presses anything
    const auto* note = screen->findChild<QLabel*>(QStringLiteral("trials.desk_note"));
    QVERIFY2(note->text().contains(QStringLiteral("ended by itself")) &&
                 note->text().contains(QStringLiteral("All answers given so far are kept")),
             qPrintable(note->text()));
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// The second press of two was meant for the page that is gone.
void TestParticipantPage::aDoublePressAnswersNothing() {
    prepare("double", [](psychophysics::StudyDesign& design) { design.trial.betweenTrials_s = 0.05; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    QTest::qWait(800); // "Go" was pressed longer ago than a double press takes
    press(Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::paused, kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(said(screen, "break.title"), QStringLiteral("Paused"), kPatience_ms);
    press(Qt::Key_Return);
    press(Qt::Key_Return);
    press(Qt::Key_Space); // nor does a third one pause again
    QVERIFY(canAnswer(screen));
    QVERIFY(stored().empty());
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// No pointer is needed for it, and the page says which key.
void TestParticipantPage::stopIsReachedWithACapturedPointer() {
    prepare("captured");
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    QVERIFY(tests::sittingButton(screen, "trials.stop")->text().contains(QStringLiteral("Esc")));
    press(Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::stopped, kPatience_ms);
    QTRY_VERIFY2_WITH_TIMEOUT(said(screen, "break.text").contains(QStringLiteral("Esc to stop the session")),
                              qPrintable(said(screen, "break.text")), kPatience_ms);
    bool asked = false;
    QTimer look;
    connect(&look, &QTimer::timeout, this, [&] {
        if (auto* button = m_site->find<QPushButton>(QStringLiteral("trials.ask.stop"))) {
            asked = true;
            button->click();
        }
    });
    look.start(100);
    press(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(asked && screen->live()->finished() && !screen->isBusy(), kPatience_ms);
    QVERIFY(tests::stopSitting(*m_site, screen));
}

/// F2 shows nobody anything: the password of whoever is logged in is asked for, and a wrong one leaves the
/// page as it is.
void TestParticipantPage::theDeskTakesThePassword() {
    prepare("desk");
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    const QString seen = told(*page(screen));
    for (const char* word : {"Stiffness of a tube", "N/m", "Weber", "stiffness\n"})
        QVERIFY2(!seen.contains(QLatin1String(word)), qPrintable(seen));
    QTest::keyClick(m_site->window.get(), Qt::Key_F2);
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("gate.password")), kPatience_ms);
    QVERIFY(!screen->atDesk());
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::paused,
                              kPatience_ms); // nothing runs while somebody types
    m_site->find<QLineEdit>(QStringLiteral("gate.password"))->setText(QStringLiteral("not the password"));
    m_site->find<QPushButton>(QStringLiteral("gate.accept"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(m_site->context.background().idle(), kPatience_ms);
    QVERIFY(m_site->find<QLineEdit>(QStringLiteral("gate.password")) && !screen->atDesk());
    m_site->context.navigator().go(QStringLiteral("studies")); // no other way out either
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("study_trials"));
    QVERIFY(tests::typePassword(*m_site));
    QVERIFY(screen->atDesk());
    QVERIFY(!page(screen)->isVisible());
    QVERIFY(screen->findChild<QLabel*>(QStringLiteral("experimenter.what"))
                ->text()
                .contains(QStringLiteral("Stiffness of a tube")));
    tests::sittingButton(screen, "trials.to_page")->click();
    QVERIFY(!screen->atDesk() && page(screen)->isVisible());
    QCOMPARE(told(*page(screen)).contains(QStringLiteral("Stiffness of a tube")), false);
}

/// Whether they are done, and who decides; nothing of the condition or of the answers.
void TestParticipantPage::whoLeavesMidTrialReadsThatItWasStopped() {
    prepare("leaves");
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    QTimer look;
    connect(&look, &QTimer::timeout, this, [this] {
        if (auto* button = m_site->find<QPushButton>(QStringLiteral("trials.ask.stop")))
            button->click();
    });
    look.start(100);
    tests::sittingButton(screen, "trials.stop")->click();
    QTRY_VERIFY_WITH_TIMEOUT(screen->live()->finished() && !screen->isBusy(), kPatience_ms);
    QCOMPARE(page(screen)->findChild<QLabel*>(QStringLiteral("break.title"))->text(),
             QStringLiteral("The session was stopped"));
    QVERIFY2(said(screen, "break.text").contains(QStringLiteral("This part is not finished")) &&
                 said(screen, "break.text").contains(QStringLiteral("who decides when it goes on")),
             qPrintable(said(screen, "break.text")));
    QVERIFY(!told(*page(screen)).contains(QStringLiteral("condition"), Qt::CaseInsensitive));
    m_site->context.navigator().go(
        QStringLiteral("study_run")); // the next participant is the experimenter's to call
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("study_trials"));
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("gate.password")), kPatience_ms);
    const QString asked = told(*m_site->find<QLineEdit>(QStringLiteral("gate.password"))->window());
    QVERIFY2(asked.contains(QStringLiteral("The session is over")) &&
                 !asked.contains(QStringLiteral("paused")),
             qPrintable(asked));
    QVERIFY(tests::typePassword(*m_site));
    QTRY_COMPARE_WITH_TIMEOUT(m_site->context.navigator().current().screen, QStringLiteral("study_run"),
                              kPatience_ms);
    QCOMPARE(stored().back().spoiled, std::string("stopped")); // nothing was lost, and it comes again
}

void TestParticipantPage::aPilotIsNamed() {
    for (const bool pilot : {true, false}) {
        prepare(pilot ? "named_pilot" : "named",
                [pilot](psychophysics::StudyDesign& design) { design.pilotOf = pilot ? "draft" : ""; });
        desktop::TrialsScreen* screen = sit();
        QVERIFY(screen && tests::beginTrials(screen));
        QVERIFY(canAnswer(screen));
        QCOMPARE(page(screen)
                     ->findChild<QLabel*>(QStringLiteral("trials.note"))
                     ->text()
                     .startsWith(QStringLiteral("Pilot run")),
                 pilot);
        QVERIFY(tests::stopSitting(*m_site, screen));
    }
}

/// Esc does what the help says, as in any run; and help, question and what is said afterwards agree.
void TestParticipantPage::aPilotIsAskedBeforeItStops() {
    prepare("asked_pilot", [](psychophysics::StudyDesign& design) { design.pilotOf = "draft"; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    const QString what = QStringLiteral("does not count as data of the study");
    QVERIFY(screen->help().contains(QStringLiteral("asks whether to stop")) &&
            screen->help().contains(what) && !screen->help().contains(QStringLiteral("trials are kept")));
    QStringList told;
    QObject hears; // no longer than what it writes to
    connect(&m_site->context.messages(), &desktop::Messages::told, &hears,
            [&told](const desktop::Message& message) { told << message.text; });
    press(Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(screen->live()->view().state, State::stopped, kPatience_ms);
    QString asked;
    const auto answerWith = [&](const char* name) {
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&] {
            auto* button = m_site->find<QPushButton>(QLatin1String(name));
            if (!button)
                return;
            asked = m_site->find<QMessageBox>(QStringLiteral("trials.ask"))->informativeText();
            button->click();
        });
        look.start(100);
        press(Qt::Key_Escape);
    };
    answerWith("trials.ask.keep");
    QVERIFY2(asked.contains(what), qPrintable(asked));
    QVERIFY(!screen->live()->finished());
    asked.clear();
    answerWith("trials.ask.stop");
    QVERIFY2(asked.contains(what), qPrintable(asked));
    QTRY_COMPARE_WITH_TIMEOUT(m_site->context.navigator().current().screen, QStringLiteral("study_run"),
                              kPatience_ms);
    QVERIFY2(told.join(QLatin1Char('|')).contains(what), qPrintable(told.join(QLatin1Char('|'))));
}

/// The run is left only once the question is answered, because the question stands on its screen.
void TestParticipantPage::aPilotThatEndsWhileItIsAskedStays() {
    prepare("ended_pilot", [](psychophysics::StudyDesign& design) { design.pilotOf = "draft"; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    bool stayed = false;
    QTimer look;
    connect(&look, &QTimer::timeout, this, [&] {
        auto* keep = m_site->find<QPushButton>(QStringLiteral("trials.ask.keep"));
        if (!keep)
            return;
        look.stop();
        screen->live()->stop(); // as a stop that was asked for before, and ends only now
        (void)QTest::qWaitFor([&] { return screen->live()->finished(); }, kPatience_ms);
        QTest::qWait(200);
        stayed = screen->live()->finished() && m_site->screen<desktop::TrialsScreen>() == screen;
        keep->click();
    });
    look.start(100);
    tests::sittingButton(screen, "trials.stop")->click();
    QVERIFY(stayed);
    QTRY_COMPARE_WITH_TIMEOUT(m_site->context.navigator().current().screen, QStringLiteral("study_run"),
                              kPatience_ms);
}

/// `chiron --study KEY --person CODE`.
void TestParticipantPage::whoWasAskedForSitsDownAfterTheLogin() {
    prepare("asked");
    const QString code = QString::fromStdString(m_participant.code);
    m_site->context.logOutNow();
    desktop::followAskedSitting(m_site->context, {QStringLiteral("asked"), code});
    QVERIFY(!m_site->screen<desktop::TrialsScreen>()); // nobody is logged in
    m_site->logIn("rhea");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->screen<desktop::TrialsScreen>(), kPatience_ms);
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("participant")).toString(),
             code);
    QTRY_VERIFY_WITH_TIMEOUT(m_site->screen<desktop::TrialsScreen>()->live(), kPatience_ms);
    QVERIFY(tests::stopSitting(*m_site, m_site->screen<desktop::TrialsScreen>()));

    m_site->context.logOutNow();
    QStringList told;
    QObject hears; // no longer than what it writes to
    connect(&m_site->context.messages(), &desktop::Messages::told, &hears,
            [&told](const desktop::Message& message) { told << message.text; });
    desktop::followAskedSitting(m_site->context, {QStringLiteral("no_such_study"), code});
    m_site->logIn("rhea");
    QTRY_VERIFY2_WITH_TIMEOUT(
        told.join(QLatin1Char('|')).contains(QStringLiteral("The study no_such_study could not be opened.")),
        qPrintable(told.join(QLatin1Char('|'))), kPatience_ms);
}

void TestParticipantPage::anOpenStudyAsksForNoPassword() {
    prepare("open", [](psychophysics::StudyDesign& design) { design.blindParticipant = false; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    tests::sittingButton(screen, "trials.experimenter")->click();
    QVERIFY(screen->atDesk());
    QVERIFY(!m_site->find<QLineEdit>(QStringLiteral("gate.password")));
}

void TestParticipantPage::aSecondScreenIsTheParticipants() {
    if (QGuiApplication::screens().size() < 2)
        QSKIP("the platform has one screen");
    prepare("second");
    desktop::TrialsScreen* screen = sit(false);
    QVERIFY(screen && screen->participantWindow());
    QVERIFY(screen->participantWindow()->isVisible() && screen->atDesk());
    QVERIFY(page(screen)->window() == screen->participantWindow());
    QVERIFY(!screen->participantWindow()->close()); // not by whoever sits there
    QVERIFY(tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    const QString seen = told(*screen->participantWindow());
    QVERIFY2(!seen.contains(QStringLiteral("Stiffness of a tube")) && !seen.contains(QStringLiteral("Weber")),
             qPrintable(seen));
    QVERIFY(screen->findChild<QLabel*>(QStringLiteral("experimenter.what"))
                ->text()
                .contains(QStringLiteral("Stiffness of a tube")));
    QVERIFY(tests::stopSitting(*m_site, screen));
}

void TestParticipantPage::anUnpluggedScreenBringsThePageBack() {
    if (QGuiApplication::screens().size() < 2)
        QSKIP("the platform has one screen");
    prepare("unplugged");
    desktop::TrialsScreen* screen = sit(false);
    QVERIFY(screen && screen->participantWindow() && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    emit qGuiApp->screenRemoved(QGuiApplication::screens().at(1));
    QTRY_VERIFY_WITH_TIMEOUT(!screen->participantWindow(), kPatience_ms);
    QCOMPARE(screen->live()->view().state, State::paused);
    QVERIFY(screen->atDesk()); // the experimenter was there, and sees what happened
    QVERIFY(screen->findChild<QLabel*>(QStringLiteral("trials.desk_note"))
                ->text()
                .contains(QStringLiteral("no longer connected")));
    tests::sittingButton(screen, "trials.to_page")->click();
    QVERIFY(page(screen)->isVisible());
    tests::sittingButton(screen, "break.button")->click();
    QVERIFY(canAnswer(screen)); // and on at the same trial
}

void TestParticipantPage::sittingsNoteTheirCircumstances() {
    prepare("noted", [](psychophysics::StudyDesign& design) { design.trial.maskingSound = false; });
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    tests::sittingButton(screen, "answer.2")->click();
    QTest::qWait(200);
    for (const char* button : {"answer.0", "answer.confirm"})
        tests::sittingButton(screen, button)->click();
    QTRY_COMPARE_WITH_TIMEOUT(stored().size(), std::size_t(1), kPatience_ms);
    const database::StudyTrial trial = stored().front();
    const session::TrialCircumstances noted = session::circumstancesOf(trial.fidelityJson);
    QCOMPARE(noted.language, std::string("en"));
    QCOMPARE(noted.masking, std::string(session::TrialCircumstances::kMaskingOff));
    QVERIFY(noted.answerTick && *noted.answerTick >= trial.firstTick &&
            *noted.answerTick + 100 < trial.lastTick); // the first key, not the last
}

/// Before the run and at the desk, never on the participant's page; and with the trial.
void TestParticipantPage::maskingThatNobodyHearsIsToldTheExperimenter() {
    const QByteArray before = qgetenv("CHIRON_NO_SOUND");
    qputenv("CHIRON_NO_SOUND", "1");
    prepare("unmasked", [](psychophysics::StudyDesign& design) { design.trial.maskingSound = true; });
    m_site->go(QStringLiteral("study_run"),
               {{QStringLiteral("study"), qlonglong(m_study)},
                {QStringLiteral("participant"), QString::fromStdString(m_participant.code)}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QWidget>(QStringLiteral("run.no_sound")), kPatience_ms);
    desktop::TrialsScreen* screen = sit();
    QVERIFY(screen && tests::beginTrials(screen));
    QVERIFY(canAnswer(screen));
    auto* notice = screen->findChild<QWidget*>(QStringLiteral("trials.no_sound"));
    QVERIFY(notice && !notice->isHidden());
    QVERIFY(!page(screen)->isAncestorOf(notice));
    QVERIFY2(!told(*page(screen)).contains(QStringLiteral("sound")), qPrintable(told(*page(screen))));
    tests::sittingButton(screen, "answer.2")->click();
    for (const char* button : {"answer.0", "answer.confirm"})
        tests::sittingButton(screen, button)->click();
    QTRY_COMPARE_WITH_TIMEOUT(stored().size(), std::size_t(1), kPatience_ms);
    QCOMPARE(session::circumstancesOf(stored().front().fidelityJson).masking,
             std::string(session::TrialCircumstances::kMaskingSilent));
    QVERIFY(tests::stopSitting(*m_site, screen));
    m_site->go(QStringLiteral("study_data"),
               {{QStringLiteral("study"), qlonglong(m_study)}, {QStringLiteral("tab"), 1}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QWidget>(QStringLiteral("data.not_masked")), kPatience_ms);
    before.isEmpty() ? qunsetenv("CHIRON_NO_SOUND") : qputenv("CHIRON_NO_SOUND", before);
    prepare("no_masking", [](psychophysics::StudyDesign& design) { design.trial.maskingSound = false; });
    m_site->go(QStringLiteral("study_run"),
               {{QStringLiteral("study"), qlonglong(m_study)},
                {QStringLiteral("participant"), QString::fromStdString(m_participant.code)}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("run.begin")), kPatience_ms);
    QVERIFY(!m_site->find<QWidget>(QStringLiteral("run.no_sound")));
}

int main(int argc, char** argv) {
    QTemporaryDir folder;
    if (qEnvironmentVariable("QT_QPA_PLATFORM", QStringLiteral("offscreen")) == QLatin1String("offscreen")) {
        QFile file(folder.filePath(QStringLiteral("screens.json")));
        if (file.open(QIODevice::WriteOnly) && file.write(kScreens) > 0)
            qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + file.fileName().toUtf8());
    }
    QApplication application(argc, argv);
    TestParticipantPage test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_participant_page.moc"
