// SPDX-License-Identifier: GPL-3.0-or-later
// Before the clock starts everybody is told what to do, with which movements, up to which force, and what
// counts.
#include "gui/training/training_bench.h"

#include "desktop/exercise_setup/gate_words.h"
#include "desktop/scene3d/scene_marks.h"
#include "desktop/training/mouse_pictogram.h"
#include "desktop/training/ready_card.h"
#include "desktop/training/scene_feed.h"
#include "desktop/training/training_words.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "support/languages.h"
#include "support/patience.h"

#include <QDialog>
#include <QKeyEvent>
#include <QLayout>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>

using namespace chiron;
using namespace chiron::tests;
using desktop::ReadyCard;

namespace {

ReadyCard* card(TrainingBench& bench) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return bench.screen() ? bench.screen()->findChild<ReadyCard*>() : nullptr;
}
QPushButton* button(TrainingBench& bench, const char* name) {
    auto* found = bench.screen()->findChild<QPushButton*>(QLatin1String(name));
    if (!found)
        qFatal("no %s", name);
    return found;
}
std::size_t sessionsOf(TrainingBench& bench) {
    auto connection = bench.desktop.database().openReader();
    const auto listed = database::SessionReader(**connection, bench.desktop.context.actor()).listSessions();
    return listed ? listed->size() : 99;
}
/// A level with its own words in every language.
const catalogue::ExerciseLevel& levelOf(TrainingBench& bench, const char* exercise, int level) {
    return *bench.desktop.site.catalogue().find(exercise, level);
}

} // namespace

class TestReadyCard : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_NO_SOUND", "1"); }
    void nothingRunsBeforeGo();
    void saysWhatToDo_data();
    void saysWhatToDo();
    void everyLevelHasAGoal();
    void laterItIsBrief();
    void aFirstMovementBegins_data();
    void aFirstMovementBegins();
    void theButtonWithTheFocusIsPressed();
    void aKeyOfTheScenePressesNoButton_data();
    void aKeyOfTheScenePressesNoButton();
    void whatIsHeldDownBeginsNothing();
    void theWholeCardIsReadWithTheKeys();
    void theFirstCardIsReadWithSpace();
    void theMovementsAreThoseOfTheDeviceInHand();
    void thatTheJawStaysIsOnTheCard();
    void howToChangeTheInstrumentIsOnTheCard();
    void theMovementsStandInOneRowWhereTheyFit();
    void practiceEndsWithoutAnyButtonInHand();
    void whoIsNewMayWatchFirst();
    void afterAPauseEnterMarks();
    void helpBringsItBack();
    void stoppedItLeadsBackToReArm();
    void whoWatchesHasNone();
    void startingAgainDoesNotAsk();
    void practiceDoesNotCount();
    void practiceIsEndedForWhatCounts();
    void theCardCanBeLeft();
    void whoOnlyTriedItReadsOnceMore();
};

void TestReadyCard::nothingRunsBeforeGo() {
    TrainingBench bench;
    bench.show();
    QVERIFY(card(bench) && card(bench)->kind() == ReadyCard::Kind::first);
    QTest::qWait(300);
    QVERIFY(!bench.screen()->feed() && !bench.screen()->isBusy() && !bench.desktop.context.trialRuns());
    QCOMPARE(sessionsOf(bench), std::size_t{0}); // who reads and leaves has no attempt
    QVERIFY(!button(bench, "training.stop")->isEnabled() && !button(bench, "training.stop")->isVisible());
    button(bench, "training.ready.go")->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(!card(bench));
    QVERIFY(bench.state().timeLeft_s > 29.0); // of 30: reading took none of it
    QVERIFY(bench.screen()->scene()->widget()->isVisible() && button(bench, "training.stop")->isVisible() &&
            button(bench, "training.stop")->isEnabled());
}

void TestReadyCard::saysWhatToDo_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<QStringList>("movements");
    QTest::newRow("point") << QStringLiteral("sphere_apex")
                           << QStringList{QStringLiteral("Move"), QStringLiteral("Lower"),
                                          QStringLiteral("Mark")};
    QTest::newRow("endoscope") << QStringLiteral("urethra_insertion")
                               << QStringList{QStringLiteral("Advance"), QStringLiteral("Turn"),
                                              QStringLiteral("Shift sideways")};
    QTest::newRow("grasper") << QStringLiteral("elastic_tube")
                             << QStringList{QStringLiteral("Move"), QStringLiteral("Lower"),
                                            QStringLiteral("Close the jaw")};
    QTest::newRow("finger") << QStringLiteral("palpation")
                            << QStringList{QStringLiteral("Move"), QStringLiteral("Press"),
                                           QStringLiteral("Mark a finding")};
}

void TestReadyCard::saysWhatToDo() {
    QFETCH(QString, exercise);
    QFETCH(QStringList, movements);
    TrainingBench bench;
    bench.show({{QStringLiteral("exercise"), exercise}});
    QVERIFY(card(bench) && card(bench)->kind() == ReadyCard::Kind::first);
    QVERIFY(!bench.screen()->findChild<QPushButton*>(
        QStringLiteral("training.ready.more"))); // nothing of it has to be looked for
    const catalogue::ExerciseLevel& level = levelOf(bench, qPrintable(exercise), 1);
    QCOMPARE(bench.text("training.ready.goal"), QString::fromStdString(level.goal.at("en")));
    QStringList named;
    for (auto* picture : card(bench)->findChildren<desktop::MousePictogram*>())
        named << picture->parentWidget()->accessibleName().section(QLatin1Char(':'), 0, 0);
    QCOMPARE(named, movements);
    const auto kind = session::exerciseKind(level.exercise);
    const QString limit = bench.text("training.ready.limit");
    for (const QString& words : desktop::limitsInWords(level, bench.desktop.context.locale()))
        QVERIFY2(limit.contains(words), qPrintable(limit));
    QVERIFY2(limit.contains(QStringLiteral("shown, not felt")),
             qPrintable(limit)); // a mouse is no haptic device
    for (const QString& words : desktop::gatesInWords(level, bench.desktop.context.locale()))
        QVERIFY(bench.text("training.ready.gates").contains(words));
    QVERIFY(bench.text("training.ready.clock")
                .contains(QStringLiteral("%1 trial").arg((*kind)->trialCount(level))));
    QVERIFY(!bench.text("training.ready.keys").isEmpty());
    // What is drawn to guide is explained; what this level does not draw is not.
    const session::LevelCues cues = session::cuesOf(level, false);
    const scene3d::SceneSetup setup =
        desktop::sceneSetupOf(level, cues, bench.desktop.context.theme(), false, {});
    const std::vector<std::string> drawn = scene3d::marksOf({setup, cues.coverage, level.feedback});
    const QString marks = bench.text("training.ready.marks");
    for (const catalogue::LegendLine& line :
         bench.desktop.site.catalogue().find(exercise.toStdString())->legend)
        QCOMPARE(marks.contains(QString::fromStdString(line.text.at("en"))),
                 std::find(drawn.begin(), drawn.end(), line.mark) != drawn.end());
}

void TestReadyCard::everyLevelHasAGoal() {
    TrainingBench bench;
    for (const catalogue::Exercise& exercise : bench.desktop.site.catalogue().exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            for (const char* language : tests::languageIds()) {
                const auto goal = level.goal.find(language);
                QVERIFY2(goal != level.goal.end(),
                         qPrintable(QString::fromStdString(exercise.id + " " + level.id)));
                QVERIFY2(QString::fromStdString(goal->second)
                                 .count(QRegularExpression(QStringLiteral("[.!?;](\\s|$)"))) == 1,
                         goal->second.c_str()); // one sentence
            }
}

void TestReadyCard::laterItIsBrief() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    bench.screen()->feed()->training().requestStop();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
    bench.show();
    QVERIFY(card(bench) && card(bench)->kind() == ReadyCard::Kind::brief);
    QVERIFY(!bench.text("training.ready.goal").isEmpty() && !bench.text("training.ready.limit").isEmpty());
    QVERIFY(!bench.screen()->findChild<QLabel*>(QStringLiteral("training.ready.gates")));
    button(bench, "training.ready.more")->click();
    QVERIFY(card(bench) && card(bench)->kind() == ReadyCard::Kind::whole);
    QVERIFY(!bench.text("training.ready.gates").isEmpty());
    bench.show({{QStringLiteral("level"), 2}}); // another level is new
    QVERIFY(card(bench) && card(bench)->kind() == ReadyCard::Kind::first);
    bench.desktop.logIn("theo"); // and so is this one for somebody else
    bench.show();
    QVERIFY(card(bench) && card(bench)->kind() == ReadyCard::Kind::first);
}

void TestReadyCard::aFirstMovementBegins_data() {
    QTest::addColumn<int>("key");
    QTest::newRow("across") << int(Qt::Key_Right);
    QTest::newRow("down") << int(Qt::Key_PageDown);
    QTest::newRow("Enter") << int(Qt::Key_Return);
}

void TestReadyCard::aFirstMovementBegins() {
    QFETCH(int, key);
    TrainingBench bench;
    bench.show();
    QTRY_VERIFY_WITH_TIMEOUT(button(bench, "training.ready.go")->hasFocus(), kPatience_ms);
    for (const Qt::Key no : {Qt::Key_X, Qt::Key_W}) // W moves an endoscope alone
        QTest::keyClick(QApplication::focusWidget(), no);
    QVERIFY(card(bench));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key(key));
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QCOMPARE(int(bench.state().trial), 0); // and marks nothing
}

void TestReadyCard::theButtonWithTheFocusIsPressed() {
    TrainingBench bench;
    bench.show();
    QTRY_VERIFY_WITH_TIMEOUT(button(bench, "training.ready.go")->hasFocus(), kPatience_ms);
    auto* help = button(bench, "training.ready.help");
    help->setFocus();
    QTest::keyClick(help, Qt::Key_Return);
    const auto dialogIsThere = [] {
        const QWidgetList tops = QApplication::topLevelWidgets();
        return std::any_of(tops.begin(), tops.end(),
                           [](QWidget* top) { return qobject_cast<QDialog*>(top) && top->isVisible(); });
    };
    QTRY_VERIFY_WITH_TIMEOUT(dialogIsThere(), kPatience_ms);
    QVERIFY(card(bench) && !bench.screen()->feed());
}

void TestReadyCard::aKeyOfTheScenePressesNoButton_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<bool>("practised");
    for (const auto& [name, kind] : {std::pair{"first", ReadyCard::Kind::first},
                                     {"brief", ReadyCard::Kind::brief},
                                     {"whole", ReadyCard::Kind::whole},
                                     {"paused", ReadyCard::Kind::paused}})
        for (const bool practised : {false, true})
            QTest::addRow("%s%s", name, practised ? ", after a practice" : "")
                << static_cast<int>(kind) << practised;
}

/// Whichever of a card's buttons has the focus: what pauses, marks, re-arms or answers in a scene presses
/// none of them.
void TestReadyCard::aKeyOfTheScenePressesNoButton() {
    QFETCH(int, kind);
    QFETCH(bool, practised);
    TrainingBench bench;
    desktop::ReadyFacts facts;
    facts.goal = QStringLiteral("A goal.");
    facts.offersDemonstration = true;
    facts.practised = practised ? QStringLiteral("The practice is over.") : QString();
    ReadyCard shown(bench.desktop.context.theme(), facts, static_cast<ReadyCard::Kind>(kind));
    shown.setToolKeys(
        desktop::movementKeys(session::PointerTool::point, devices::HandKind::mouseAndKeyboard));
    int asked = 0;
    for (const auto signal : {&ReadyCard::goAsked, &ReadyCard::practiceAsked, &ReadyCard::watchAsked,
                              &ReadyCard::wholeAsked, &ReadyCard::helpAsked})
        connect(&shown, signal, &shown, [&asked] { ++asked; });
    shown.show();
    shown.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&shown));
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::focusWidget(), kPatience_ms);
    for (auto* each : shown.findChildren<QPushButton*>()) {
        each->setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(each->hasFocus(), kPatience_ms);
        for (const Qt::Key key :
             {Qt::Key_Space, Qt::Key_R, Qt::Key_D, Qt::Key_N, Qt::Key_1, Qt::Key_F5, Qt::Key_Delete})
            QTest::keyClick(each, key);
        QCOMPARE(asked, 0);
        QTest::keyClick(each, Qt::Key_Return); // that is how a button is pressed
        QCOMPARE(asked, 1);
        asked = 0;
    }
}

void TestReadyCard::whatIsHeldDownBeginsNothing() {
    TrainingBench bench;
    bench.show();
    QTRY_VERIFY_WITH_TIMEOUT(button(bench, "training.ready.go")->hasFocus(), kPatience_ms);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Right}) {
        QKeyEvent again(QEvent::KeyPress, key, Qt::NoModifier, QString(), true);
        QApplication::sendEvent(QApplication::focusWidget(), &again);
    }
    QVERIFY(card(bench) && !bench.screen()->feed());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
}

void TestReadyCard::theWholeCardIsReadWithTheKeys() {
    TrainingBench bench;
    bench.desktop.settings.setScale(2.0);
    bench.desktop.window->resize(1280, 720);
    bench.desktop.context.applyAppearance();
    bench.desktop.settings.setOfPerson(bench.desktop.context.actor().personId(),
                                       desktop::readyKey(desktop::TrainingPlan::fromMap(
                                           {{QStringLiteral("exercise"), QStringLiteral("palpation")}})),
                                       true);
    bench.show({{QStringLiteral("exercise"), QStringLiteral("palpation")}});
    button(bench, "training.ready.more")->click(); // of the brief card
    auto* page = card(bench)->findChild<QScrollArea*>(QStringLiteral("training.ready.page"));
    QVERIFY(page);
    QTRY_VERIFY_WITH_TIMEOUT(page->verticalScrollBar()->maximum() > 0, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(button(bench, "training.ready.go")->hasFocus(), kPatience_ms);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_PageDown);
    QVERIFY(page->verticalScrollBar()->value() > 0);
    QVERIFY(card(bench) && !bench.screen()->feed()); // and it is no first movement
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_PageUp);
    QCOMPARE(page->verticalScrollBar()->value(), 0);
}

/// The first card has everything on it, so it may be longer than the window. Space reads on to its end, and
/// begins nothing; "Go" stays where it is. The arrow and page keys are first movements of the tool.
void TestReadyCard::theFirstCardIsReadWithSpace() {
    TrainingBench bench;
    bench.desktop.settings.setScale(2.0);
    bench.desktop.window->resize(1280, 720);
    bench.desktop.context.applyAppearance();
    bench.show({{QStringLiteral("exercise"), QStringLiteral("palpation")}});
    auto* page = card(bench)->findChild<QScrollArea*>(QStringLiteral("training.ready.page"));
    auto* more = card(bench)->findChild<QLabel*>(QStringLiteral("training.ready.read_on"));
    QVERIFY(page && more);
    QScrollBar& bar = *page->verticalScrollBar();
    QTRY_VERIFY_WITH_TIMEOUT(bar.maximum() > 0 && more->isVisible(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(button(bench, "training.ready.go")->hasFocus(), kPatience_ms);
    for (int presses = 0; presses < 50 && bar.value() < bar.maximum(); ++presses)
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    QCOMPARE(bar.value(), bar.maximum());
    const auto* last = card(bench)->findChild<QLabel*>(QStringLiteral("training.ready.keys"));
    QVERIFY(last && !last->visibleRegion().isEmpty());
    QVERIFY(card(bench) && !bench.screen()->feed());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space, Qt::ShiftModifier);
    QVERIFY(bar.value() < bar.maximum());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_PageDown);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
}

/// With mouse and keyboard the movements of both, with a device in hand those of its handle; and how to
/// change what one hand moves, where it moves several.
void TestReadyCard::theMovementsAreThoseOfTheDeviceInHand() {
    using devices::HandKind;
    using session::PointerTool;
    const auto words = [](const std::vector<desktop::ControlHint>& hints) {
        QString all;
        for (const desktop::ControlHint& hint : hints)
            all += hint.what + QLatin1Char('\n') + hint.how + QLatin1Char('\n');
        return all;
    };
    const auto ofAHandle = [](desktop::Pictogram picture) {
        return picture == desktop::Pictogram::moveStylus || picture == desktop::Pictogram::pressStylus ||
               picture == desktop::Pictogram::stylusButton;
    };
    for (const PointerTool tool : {PointerTool::point, PointerTool::endoscope, PointerTool::grasper}) {
        const auto mouse = desktop::controlGuide(tool, HandKind::mouseAndKeyboard);
        const auto handle = desktop::controlGuide(tool, HandKind::handle, 2);
        QCOMPARE(mouse.size(), std::size_t{3});
        QCOMPARE(handle.size(), std::size_t{3}); // a handle for each instrument: nothing is changed
        for (std::size_t i = 0; i < mouse.size(); ++i) {
            QCOMPARE(handle[i].what, mouse[i].what);
            QVERIFY(ofAHandle(handle[i].picture) && !ofAHandle(mouse[i].picture));
        }
        for (const char* word : {"mouse", "wheel", "Click", "arrow"})
            QVERIFY2(!words(handle).contains(QLatin1String(word), Qt::CaseInsensitive), word);
        QVERIFY(desktop::movementKeys(tool, HandKind::handle).empty());
        QVERIFY(!desktop::movementKeys(tool, HandKind::mouseAndKeyboard).empty());
        QVERIFY(!desktop::keysInWords(true, tool, 1, HandKind::handle).contains(QStringLiteral("mouse")));
    }
    QVERIFY(words(desktop::controlGuide(PointerTool::grasper, HandKind::mouseAndKeyboard, 2))
                .contains(QStringLiteral("Press 1 for the right one")));
    QVERIFY(words(desktop::controlGuide(PointerTool::grasper, HandKind::mouseAndKeyboard, 3))
                .contains(QStringLiteral("1 to 3")));
    QVERIFY(!words(desktop::controlGuide(PointerTool::grasper, HandKind::mouseAndKeyboard, 1))
                 .contains(QStringLiteral("Change")));
}

/// By mouse and keys the jaw stays where it was let go; a grip that closes and opens says so itself.
void TestReadyCard::thatTheJawStaysIsOnTheCard() {
    using devices::HandKind;
    const auto closes = [](HandKind hand) {
        for (const desktop::ControlHint& hint : desktop::controlGuide(session::PointerTool::grasper, hand, 1))
            if (hint.what == QStringLiteral("Close the jaw"))
                return hint.how;
        return QString();
    };
    QVERIFY2(closes(HandKind::mouseAndKeyboard)
                 .contains(QStringLiteral("When you let go, the jaw stays as it is")),
             qPrintable(closes(HandKind::mouseAndKeyboard)));
    QVERIFY(!closes(HandKind::handle).isEmpty() &&
            !closes(HandKind::handle).contains(QStringLiteral("stays")));
}

/// On the card of every level on which one hand moves several instruments or fingers of both hands.
void TestReadyCard::howToChangeTheInstrumentIsOnTheCard() {
    TrainingBench bench;
    int several = 0;
    for (const catalogue::Exercise& exercise : bench.desktop.site.catalogue().exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels) {
            bench.show({{QStringLiteral("exercise"), QString::fromStdString(exercise.id)},
                        {QStringLiteral("level"), level.number}});
            QVERIFY(card(bench));
            QString how;
            for (auto* picture : card(bench)->findChildren<desktop::MousePictogram*>())
                how += picture->parentWidget()->accessibleName() + QLatin1Char('\n');
            const auto* palpation = level.parameters.find<simulation::PalpationParameters>();
            const auto kind = session::exerciseKind(level.exercise);
            const bool hands = palpation && palpation->hands > 1;
            const bool instruments = !palpation && (*kind)->toolCount(level) > 1;
            several += hands || instruments ? 1 : 0;
            QVERIFY2(how.contains(QStringLiteral("Press H")) == hands, qPrintable(how));
            QVERIFY2(how.contains(QStringLiteral("Change the instrument")) == instruments, qPrintable(how));
        }
    QVERIFY(several >= 3);
}

/// Side by side with a mouse and with a handle, however many there are, in every window and at every scale in
/// which their widths have room; below each other only where they have not.
void TestReadyCard::theMovementsStandInOneRowWhereTheyFit() {
    using devices::HandKind;
    const TrainingBench bench; // its application has the theme's style
    int inOneRow = 0, below = 0;
    for (const double scale : {1.0, 1.1, 1.25, 1.5, 2.0}) {
        const auto theme = desktop::Theme::load(desktop::ThemeName::light, scale);
        QVERIFY(theme);
        for (const QSize window : {QSize(960, 540), QSize(1280, 800), QSize(1600, 1000)})
            for (const auto& [hand, tools] : {std::pair{HandKind::mouseAndKeyboard, 1},
                                              {HandKind::mouseAndKeyboard, 2},
                                              {HandKind::handle, 2}}) {
                desktop::ReadyFacts facts;
                facts.goal = QStringLiteral("A goal.");
                facts.controls = desktop::controlGuide(session::PointerTool::grasper, hand, tools);
                ReadyCard shown(*theme, facts, ReadyCard::Kind::first);
                shown.resize(window);
                shown.show();
                QVERIFY(QTest::qWaitForWindowExposed(&shown));
                std::vector<QWidget*> tiles;
                for (auto* picture : shown.findChildren<desktop::MousePictogram*>())
                    tiles.push_back(picture->parentWidget());
                QCOMPARE(tiles.size(), facts.controls.size());
                auto* page = shown.findChild<QScrollArea*>(QStringLiteral("training.ready.page"));
                QVERIFY(page);
                const int count = static_cast<int>(tiles.size());
                const int gap_px = tiles.front()->parentWidget()->layout()->spacing();
                const auto fit = [&] {
                    return count * tiles.front()->width() + (count - 1) * gap_px <=
                           page->widget()->layout()->contentsRect().width();
                };
                const auto rows = [&tiles] {
                    QSet<int> tops;
                    for (const QWidget* tile : tiles)
                        tops.insert(tile->y());
                    return tops.size();
                };
                QTRY_COMPARE_WITH_TIMEOUT(rows() == 1, fit(), kPatience_ms);
                ++(fit() ? inOneRow : below);
            }
    }
    QVERIFY(inOneRow > 0 && below > 0);
}

void TestReadyCard::practiceEndsWithoutAnyButtonInHand() {
    TrainingBench bench;
    bench.show({{QStringLiteral("practice_s"), 1.5}});
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(card(bench), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(card(bench)->hasFocus(), kPatience_ms);
    for (const Qt::Key key :
         {Qt::Key_Return, Qt::Key_Space, Qt::Key_Right, Qt::Key_PageDown}) // they were meant for the practice
        QTest::keyClick(QApplication::focusWidget(), key);
    QTest::qWait(100);
    QVERIFY(card(bench) && !bench.screen()->feed());
    button(bench, "training.ready.go")->setFocus(Qt::TabFocusReason);
    QTest::keyClick(button(bench, "training.ready.go"), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
}

void TestReadyCard::whoIsNewMayWatchFirst() {
    TrainingBench bench;
    bench.show();
    button(bench, "training.ready.watch")->click();
    QVERIFY(!card(bench)); // who watches has none
    QCOMPARE(
        bench.desktop.context.navigator().current().parameters.value(QStringLiteral("device")).toString(),
        QStringLiteral("demonstration"));
    bench.desktop.settings.setOfPerson(bench.desktop.context.actor().personId(),
                                       desktop::readyKey(desktop::TrainingPlan::fromMap(
                                           {{QStringLiteral("exercise"), QStringLiteral("sphere_apex")}})),
                                       true);
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen() && bench.screen()->feed(), kPatience_ms);
    bench.screen()->feed()->training().requestStop();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("debrief")), kPatience_ms);
    bench.show();
    QVERIFY(card(bench) && card(bench)->kind() == ReadyCard::Kind::brief);
    QVERIFY(!bench.screen()->findChild<QPushButton*>(
        QStringLiteral("training.ready.watch"))); // who knows the level is not asked again
}

void TestReadyCard::afterAPauseEnterMarks() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    auto* main = button(bench, "training.main");
    main->setFocus();
    main->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    main->click(); // with the mouse: the focus stays on it until the trial goes on
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms);
    QVERIFY(!main->hasFocus());
    QVERIFY(bench.mayMark());
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : bench.screen(),
                    Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().trial > 0 || bench.state().phase == core::TrialPhase::between,
                             kPatience_ms);
    QVERIFY(!bench.state().paused || bench.state().phase == core::TrialPhase::between);
}

void TestReadyCard::helpBringsItBack() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    bench.key(Qt::Key_F1);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    QVERIFY(card(bench) && card(bench)->kind() == ReadyCard::Kind::paused && card(bench)->isVisible());
    QVERIFY(!bench.text("training.ready.gates").isEmpty());
    QVERIFY(button(bench, "training.stop")->isVisible() &&
            button(bench, "training.stop")->isEnabled()); // whatever is read
    // It says what is true now, and there is one button that goes on.
    QCOMPARE(bench.text("training.ready.clock"),
             QStringLiteral("The trial is paused and its clock is stopped. Press Resume or Space to go on."));
    QCOMPARE(button(bench, "training.ready.go")->text(), QStringLiteral("Resume (Enter)"));
    QVERIFY(!button(bench, "training.main")->isVisible());
    const double left_s = bench.state().timeLeft_s;
    QTest::qWait(200);
    QCOMPARE(bench.state().timeLeft_s, left_s);
    button(bench, "training.ready.go")->click();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms);
    QVERIFY(!card(bench) && bench.screen()->scene()->widget()->isVisible());
    QVERIFY(button(bench, "training.main")->isVisible());
    bench.key(Qt::Key_F1);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    bench.key(Qt::Key_Space); // as a pause is always left
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms);
    QVERIFY(!card(bench));
}

void TestReadyCard::stoppedItLeadsBackToReArm() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    bench.key(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().paused, kPatience_ms);
    bench.key(Qt::Key_F1);
    QTRY_VERIFY_WITH_TIMEOUT(card(bench), kPatience_ms);
    QCOMPARE(bench.text("training.ready.clock"),
             QStringLiteral("The clock is stopped. Press Re-arm or R to go on."));
    QCOMPARE(button(bench, "training.ready.go")->text(), QStringLiteral("Back to the scene (Enter)"));
    QVERIFY(button(bench, "training.main")->isVisible()); // which re-arms
    button(bench, "training.ready.go")->click();
    QVERIFY(!card(bench));
    QTest::qWait(100);
    QVERIFY(bench.state().paused); // a card gives no force back
    bench.key(Qt::Key_R);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.state().paused, kPatience_ms);
}

void TestReadyCard::whoWatchesHasNone() {
    TrainingBench bench;
    bench.show({{QStringLiteral("device"), QStringLiteral("demonstration")},
                {QStringLiteral("operator"), QStringLiteral("expert")}});
    QVERIFY(!card(bench));
    QTRY_VERIFY_WITH_TIMEOUT(bench.state().started, kPatience_ms);
    QVERIFY(!bench.screen()->helpItself()); // the help of the screen is what there is
}

void TestReadyCard::startingAgainDoesNotAsk() {
    TrainingBench bench;
    bench.train();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    const database::SessionId first = bench.screen()->feed()->training().sessionId();
    bench.key(Qt::Key_F5);
    QTRY_VERIFY_WITH_TIMEOUT(bench.screen() && bench.screen()->feed() &&
                                 bench.screen()->feed()->training().sessionId() > first && bench.runs(),
                             kPatience_ms);
    QVERIFY(!card(bench));
}

void TestReadyCard::practiceDoesNotCount() {
    TrainingBench bench;
    bench.show();
    button(bench, "training.ready.practice")->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QVERIFY(bench.text("training.device").contains(QStringLiteral("not counted")));
    const database::SessionId id = bench.screen()->feed()->training().sessionId();
    bench.screen()->feed()->training().requestStop();
    QTRY_VERIFY_WITH_TIMEOUT(card(bench),
                             kPatience_ms); // what was practised waits, and the level is still new
    QVERIFY(bench.at(QStringLiteral("training")) && card(bench)->kind() == ReadyCard::Kind::first);
    bench.show({{QStringLiteral("practice_s"), 1.5}}); // it ends by itself, and says so before and after
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(
        bench.screen()->drawn().note.title.startsWith(QStringLiteral("Practice ends in ")), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(card(bench), kPatience_ms);
    QVERIFY(bench.text("training.ready.practised").contains(QStringLiteral("does not count")));
    QVERIFY(button(bench, "training.ready.go")->text().startsWith(QStringLiteral("Continue")));
    QVERIFY(bench.text("training.ready.clock").contains(QStringLiteral("Continue")));
    bench.show(); // whoever comes without a practice is told nothing of one
    QVERIFY(card(bench) && !bench.screen()->findChild<QLabel*>(QStringLiteral("training.ready.practised")));
    QVERIFY(button(bench, "training.ready.go")->text().startsWith(QStringLiteral("Go")));
    bench.show({{QStringLiteral("practice_s"), 60.0}}); // nor is its end told before it is near
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QTest::qWait(200);
    QCOMPARE(bench.screen()->drawn().note.title,
             QStringLiteral("The mouse moves the instrument. Space pauses and frees it."));
    bench.screen()->feed()->training().requestStop();
    QTRY_VERIFY_WITH_TIMEOUT(card(bench), kPatience_ms);
    auto connection = bench.desktop.database().openReader();
    const auto record = database::SessionReader(**connection, bench.desktop.context.actor()).session(id);
    QVERIFY(record && record->summary.familiarisation);
    QCOMPARE(sessionsOf(bench), std::size_t{3});
}

void TestReadyCard::practiceIsEndedForWhatCounts() {
    TrainingBench bench;
    bench.show({{QStringLiteral("practice_s"), 60.0}});
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    auto* end = button(bench, "training.end");
    QCOMPARE(end->text(), QStringLiteral("End the practice"));
    QVERIFY(!button(bench, "training.again")->isVisible());
    end->click(); // asks nothing: nothing is lost
    QTRY_VERIFY_WITH_TIMEOUT(card(bench), kPatience_ms);
    QVERIFY(bench.at(QStringLiteral("training")) &&
            bench.text("training.ready.practised").contains(QStringLiteral("does not count")));
    button(bench, "training.ready.go")->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs(), kPatience_ms);
    QCOMPARE(button(bench, "training.end")->text(), QStringLiteral("End session …"));
    QVERIFY(button(bench, "training.again")->isVisible());
}

void TestReadyCard::theCardCanBeLeft() {
    TrainingBench bench;
    bench.desktop.go(QStringLiteral("exercises"));
    bench.show();
    QVERIFY(card(bench));
    button(bench, "training.ready.leave")->click();
    QTRY_VERIFY_WITH_TIMEOUT(bench.at(QStringLiteral("exercises")), kPatience_ms);
    QCOMPARE(sessionsOf(bench), std::size_t{0}); // nothing had begun
}

void TestReadyCard::whoOnlyTriedItReadsOnceMore() {
    TrainingBench bench;
    const auto kindAfterGo = [&](const QVariantMap& plan) {
        bench.show(plan);
        button(bench, "training.ready.go")->click();
        QTest::qWait(0);
        bench.show();
        return card(bench) ? card(bench)->kind() : ReadyCard::Kind::paused;
    };
    QVERIFY(kindAfterGo({{QStringLiteral("familiarisation"), true}, {QStringLiteral("trials"), 3}}) ==
            ReadyCard::Kind::first);
    QVERIFY(kindAfterGo({}) == ReadyCard::Kind::brief);
}

QTEST_MAIN(TestReadyCard)
#include "test_ready_card.moc"
