// SPDX-License-Identifier: GPL-3.0-or-later
// A stored session on the screen: what is shown is what was recorded, at the same moment everywhere.
#include "database/repositories/score_repository.h"
#include "database/repositories/session_repository.h"
#include "desktop/playback/playback_data.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_scene.h"
#include "desktop/playback/playback_screen.h"
#include "desktop/playback/scrubber.h"
#include "desktop/playback/transport_bar.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/wrapped_items.h"
#include "review_sessions.h"
#include "support/grasp_session.h"
#include "support/looked_back.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStyle>
#include <QTabWidget>
#include <QWheelEvent>
#include <algorithm>
#include <map>
#include <set>
#include <sqlite3.h>

using chiron::tests::kPatience_ms;

using namespace chiron;
using tests::DesktopFixture;
using tests::MadeSession;

class TestPlayback : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void opensAtAMoment();
    void aMomentIsPlayedToAndStops();
    void aTickIsPlayedTo();
    void energyIsForExperts_data();
    void energyIsForExperts();
    void aTrainerMarksASessionAsReviewed();
    void cursorsAndScrubberAgree();
    void keysStepAndSeek();
    void playsAndStopsAtTheEnd();
    void pausesAreSkipped();
    void thePlotsZoom();
    void theWheelIsThePages();
    void aKeyOpensTheCommentField();
    void marksJump();
    void textsOfEventsAreNeverShortened();
    void theTimeGivesWayFirst();
    void ghostBesideIt();
    void ghostsAreOfTheSameDeviceClass();
    void theEarliestOfTheBestStandsOut();
    void commentAtAMoment();
    void aCommentIsAnsweredAtItsMoment();
    void oneClockTellsTheTime();
    void voidNeedsAReasonAndATrainer();
    void nothingRecorded();
    void damagedIsNamed();
    void sceneStateIsTheRecording();
    void nothingClippedOrUnnamed();
    void theHeadSaysWhatWasRecorded();

private:
    void open(database::SessionId id, QVariantMap more = {});
    desktop::PlaybackScreen* screen() { return m_site->screen<desktop::PlaybackScreen>(); }
    template <class W> W* find(const char* name) { return screen()->findChild<W*>(QLatin1String(name)); }

    std::unique_ptr<DesktopFixture> m_site;
    std::unique_ptr<tests::ReviewSessions> m_made;
    std::optional<database::Actor> m_tina;
    database::SessionId m_good = 0;
    database::SessionId m_bad = 0;
    database::SessionId m_tube = 0; ///< of an exercise whose energy is recorded
};

void TestPlayback::initTestCase() {
    m_site = std::make_unique<DesktopFixture>();
    m_made = std::make_unique<tests::ReviewSessions>(m_site->database());
    m_tina = m_site->actor("tina");
    MadeSession paused = m_made->bad;
    tests::pauseFrames(paused.frames, 5000, 6500);
    m_good = tests::store(m_site->database(), *m_tina, m_made->good);
    m_bad = tests::store(m_site->database(), *m_tina, paused);
    m_site->context.logIn(*m_tina);
}

void TestPlayback::open(database::SessionId id, QVariantMap more) {
    more.insert(QStringLiteral("session"), qlonglong(id));
    m_site->go(QStringLiteral("playback"), more);
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(find<QWidget>("playback.scene"), kPatience_ms);
}

void TestPlayback::opensAtAMoment() {
    open(m_bad, {{QStringLiteral("at_s"), 7.25}});
    QCOMPARE(screen()->clock().position_s(), 7.25);
    QCOMPARE(find<desktop::Scrubber>("playback.scrubber")->value(), 7250);
    QVERIFY(find<QLabel>("playback.readout")->text().contains(QStringLiteral("Trial")));
    QVERIFY(!screen()->clock().playing());
    tests::takePictures(*m_site, QStringLiteral("playback"), [this] {
        open(m_bad, {{QStringLiteral("at_s"), 12.0}});
    });
}

/// Who is led to a moment sees how it came about; it stops there, once, with one line in the scene.
void TestPlayback::aMomentIsPlayedToAndStops() {
    open(m_bad,
         {{QStringLiteral("at_s"), 4.0},
          {QStringLiteral("caption"), QStringLiteral("Tom, at 0:04.5: ") + QString(300, QLatin1Char('x'))},
          {QStringLiteral("caption_s"), 4.5}});
    auto& clock = screen()->clock();
    QTRY_VERIFY_WITH_TIMEOUT(!clock.playing() && clock.position_s() >= 4.5, kPatience_ms);
    QVERIFY2(clock.position_s() < 5.5,
             qPrintable(QString::number(clock.position_s()))); // nobody pressed anything
    QVERIFY(screen()->captionAt(4.5).title.size() <= 90 &&
            screen()->captionAt(4.5).title.endsWith(QChar(0x2026)));
    QVERIFY(screen()->captionAt(4.0).title.isEmpty());
    clock.seek(4.0);
    clock.play();
    while (clock.playing() && clock.position_s() < 5.0)
        clock.advance(0.1);
    QVERIFY(clock.playing()); // it stopped once, and no more
    clock.pause();
    open(m_bad, {{QStringLiteral("at_s"), 6.0},
                 {QStringLiteral("caption"), QStringLiteral("Here")},
                 {QStringLiteral("caption_s"), 4.5}}); // come back to later
    QTest::qWait(50);
    QVERIFY(!screen()->clock().playing());
}

/// A comment belongs to a tick of the recording: where that is on the time bar is known only here.
void TestPlayback::aTickIsPlayedTo() {
    open(m_bad, {{QStringLiteral("at_s"), 8.5},
                 {QStringLiteral("at_tick"), qulonglong(9000)},
                 {QStringLiteral("caption"), QStringLiteral("Tom: look")}});
    auto& clock = screen()->clock();
    QTRY_VERIFY_WITH_TIMEOUT(!clock.playing() && !screen()->captionAt(clock.position_s()).title.isEmpty(),
                             kPatience_ms);
    const double moment_s = clock.position_s();
    QVERIFY2(moment_s > 8.5, qPrintable(QString::number(moment_s)));
    QVERIFY(screen()->captionAt(moment_s - 1.0).title.isEmpty());
}

void TestPlayback::energyIsForExperts_data() {
    QTest::addColumn<QString>("person");
    QTest::addColumn<bool>("shown");
    QTest::newRow("trainee") << QStringLiteral("tina") << false;
    QTest::newRow("trainer") << QStringLiteral("tom") << true;
    QTest::newRow("researcher") << QStringLiteral("rhea") << true;
    QTest::newRow("administrator") << QStringLiteral("ada") << true;
}

/// The balance of energy tells whether the simulation is sound, which is nothing that a trainee can change.
void TestPlayback::energyIsForExperts() {
    QFETCH(QString, person);
    QFETCH(bool, shown);
    if (m_tube == 0)
        m_tube = tests::addGrasping(*m_site, "tina", "elastic_tube");
    QVERIFY(m_tube != 0);
    m_site->logIn(person.toStdString());
    open(m_tube);
    QVERIFY(find<QWidget>("playback.grasp_plot")); // the plots of the exercise are there
    QCOMPARE(find<QWidget>("playback.energy_plot") != nullptr, shown);
    m_site->context.logIn(*m_tina);
}

void TestPlayback::aTrainerMarksASessionAsReviewed() {
    const auto id = tests::store(m_site->database(), *m_tina, m_made->good);
    open(id);
    QVERIFY(find<QPushButton>("playback.reviewed")->isHidden()); // nobody reviews their own
    m_site->logIn("tom");
    open(id);
    auto* reviewed = find<QPushButton>("playback.reviewed");
    QVERIFY(!reviewed->isHidden());
    reviewed->click();
    QTRY_VERIFY_WITH_TIMEOUT(reviewed->isHidden(), kPatience_ms);
    auto connection = m_site->database().openReader();
    QVERIFY(database::SessionReader(**connection, *m_tina).session(id)->summary.reviewed);
    QCOMPARE(find<QListWidget>("playback.comments")->count(), 1);
    open(id);
    QVERIFY(find<QPushButton>("playback.reviewed")->isHidden()); // it is
    m_site->context.logIn(*m_tina);
}

void TestPlayback::cursorsAndScrubberAgree() {
    open(m_bad);
    auto* plots = screen()->findChild<desktop::PlaybackPlots*>();
    for (const double t_s : {0.0, 3.3, 8.004, screen()->clock().duration_s()}) {
        screen()->clock().seek(t_s);
        QCOMPARE(plots->force().cursorX(), t_s);
        QCOMPARE(plots->speed().cursorX(), t_s);
        QVERIFY(std::abs(plots->force().pixelOf(t_s) - plots->speed().pixelOf(t_s)) < 0.75); // one column
    }
    // A click in either plot goes there, in both and on the bar.
    for (const char* name : {"playback.force", "playback.speed_plot"}) {
        auto* plot = find<QWidget>(name);
        const double x = dynamic_cast<report::PlotView*>(plot)->pixelOf(5.5);
        QWidget* canvas = plot->findChild<QWidget*>();
        QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(qRound(x), canvas->height() / 2));
        QVERIFY(std::abs(screen()->clock().position_s() - 5.5) < 0.2);
        QCOMPARE(plots->force().cursorX(), plots->speed().cursorX());
        screen()->clock().seek(1.0);
    }
    auto* scrubber = find<desktop::Scrubber>("playback.scrubber");
    QTest::mouseClick(scrubber, Qt::LeftButton, {},
                      QPoint(qRound(scrubber->xOf(9.0)), scrubber->height() / 2));
    QVERIFY(std::abs(screen()->clock().position_s() - 9.0) < 0.1);
    screen()->clock().seek(5.9);
    QVERIFY(find<QLabel>("playback.readout")->text().contains(QStringLiteral("paused")));
}

void TestPlayback::keysStepAndSeek() {
    open(m_bad, {{QStringLiteral("at_s"), 4.0}});
    auto* scrubber = find<desktop::Scrubber>("playback.scrubber");
    QTRY_VERIFY_WITH_TIMEOUT(scrubber->hasFocus(), kPatience_ms);
    QTest::keyClick(scrubber, Qt::Key_Right);
    QCOMPARE(screen()->clock().position_s(), 4.004);
    QTest::keyClick(scrubber, Qt::Key_Left);
    QCOMPARE(screen()->clock().position_s(), 4.0);
    QTest::keyClick(scrubber, Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(screen()->clock().position_s(), 5.0);
    QTest::keyClick(scrubber, Qt::Key_End);
    QCOMPARE(screen()->clock().position_s(), screen()->clock().duration_s());
    QTest::keyClick(scrubber, Qt::Key_Home);
    QCOMPARE(screen()->clock().position_s(), 0.0);
    QTest::keyClick(scrubber, Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(screen()->clock().position_s() > 0.0);
    QTest::keyClick(scrubber, Qt::Key_Space);
    QVERIFY(screen()->clock().playing());
    QTest::keyClick(scrubber, Qt::Key_Space);
    QVERIFY(!screen()->clock().playing());
}

void TestPlayback::playsAndStopsAtTheEnd() {
    desktop::PlaybackClock clock;
    clock.setDuration(2.0);
    clock.setSpeed(0.5);
    clock.play();
    clock.advance(0.2);
    QCOMPARE(clock.position_s(), 0.1);
    clock.advance(60.0); // the window stood still: no leap
    QVERIFY(clock.position_s() < 0.5);
    clock.setSpeed(9.0);
    QCOMPARE(clock.speed(), 4.0);
    for (int i = 0; i < 40 && clock.playing(); ++i)
        clock.advance(0.1);
    QCOMPARE(clock.position_s(), 2.0);
    QVERIFY(!clock.playing());
    clock.play(); // from the beginning
    QCOMPARE(clock.position_s(), 0.0);
    clock.seek(-5.0);
    QCOMPARE(clock.position_s(), 0.0);
}

void TestPlayback::pausesAreSkipped() {
    open(m_bad, {{QStringLiteral("at_s"), 4.9}});
    const auto& paused = screen()->clock();
    auto* skip = find<QCheckBox>("playback.skip_pauses");
    QVERIFY(skip && skip->isChecked());
    screen()->clock().play();
    screen()->clock().advance(0.2);
    QVERIFY2(paused.position_s() >= 6.5 - 0.01 && paused.position_s() < 6.7,
             qPrintable(QString::number(paused.position_s())));
    screen()->clock().pause();
    screen()->clock().seek(5.5); // who wants to see it goes there
    QCOMPARE(paused.position_s(), 5.5);
    skip->setChecked(false);
    screen()->clock().seek(4.9);
    screen()->clock().play();
    screen()->clock().advance(0.2);
    QVERIFY(std::abs(paused.position_s() - 5.1) < 1e-9);
    screen()->clock().pause();
    open(m_good);
    QVERIFY(!find<QCheckBox>("playback.skip_pauses")); // nothing to skip
}

void TestPlayback::thePlotsZoom() {
    open(m_bad, {{QStringLiteral("at_s"), 8.0}});
    auto* plots = screen()->findChild<desktop::PlaybackPlots*>();
    const double whole_s = plots->to_s();
    QCOMPARE(plots->from_s(), 0.0);
    const double share = plots->force().pixelOf(8.0);
    auto* scrubber = find<desktop::Scrubber>("playback.scrubber");
    QTest::keyClick(scrubber, Qt::Key_Plus);
    QVERIFY(std::abs(plots->to_s() - plots->from_s() - 0.5 * whole_s) < 1e-9);
    QVERIFY(std::abs(plots->force().pixelOf(8.0) - share) < 1.5); // what is looked at stays where it was
    QCOMPARE(plots->force().xLow(), plots->from_s());
    QCOMPARE(plots->speed().xHigh(), plots->to_s()); // all together
    for (int i = 0; i < 20; ++i)
        QTest::mouseClick(find<QPushButton>("playback.zoom_in"), Qt::LeftButton);
    QCOMPARE(plots->to_s() - plots->from_s(), 0.5); // and no farther
    screen()->clock().seek(2.0);                    // beyond the page: it is turned
    QVERIFY(plots->from_s() <= 2.0 && plots->to_s() >= 2.0);
    QVERIFY(std::abs(plots->to_s() - plots->from_s() - 0.5) < 1e-9);
    QTest::mouseClick(find<QPushButton>("playback.zoom_out"), Qt::LeftButton);
    QVERIFY(std::abs(plots->to_s() - plots->from_s() - 1.0) < 1e-9);
    screen()->clock().seek(screen()->clock().duration_s());
    QVERIFY(std::abs(plots->to_s() - whole_s) < 1e-9);
    QTest::keyClick(scrubber, Qt::Key_0);
    QCOMPARE(plots->from_s(), 0.0);
    QCOMPARE(plots->to_s(), whole_s);
    QTest::keyClick(scrubber, Qt::Key_Minus); // nothing beyond all
    QCOMPARE(plots->to_s(), whole_s);
}

/// What a plot does not take goes to the page that it stands on.
void TestPlayback::theWheelIsThePages() {
    open(m_bad);
    for (const char* name : {"playback.force", "playback.speed_plot"}) {
        QWidget* plot = find<QWidget>(name);
        QWidgetList parts = plot->findChildren<QWidget*>();
        parts << plot;
        for (QWidget* part : parts) {
            QWheelEvent turned(part->rect().center(), part->mapToGlobal(part->rect().center()), {}, {0, -120},
                               Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            turned.setAccepted(true);
            QApplication::sendEvent(part, &turned);
            QVERIFY(!turned.isAccepted());
        }
    }
    auto* page = screen()->findChild<desktop::ScrollPage*>(); // and what is ignored goes up to the page
    QVERIFY(page);
    for (const char* name : {"playback.force", "playback.speed_plot"})
        for (QWidget* part : find<QWidget>(name)->findChildren<QWidget*>())
            for (const QWidget* widget = part; widget && widget != page->viewport();
                 widget = widget->parentWidget())
                QVERIFY2(!widget->testAttribute(Qt::WA_NoMousePropagation),
                         widget->metaObject()->className());
}

/// Within the first screen, above what was said before.
void TestPlayback::aKeyOpensTheCommentField() {
    m_site->window->resize(1280, 800);
    m_site->logIn("tom");
    open(m_bad, {{QStringLiteral("at_s"), 3.0}});
    screen()->clock().play();
    QTest::keyClick(find<desktop::Scrubber>("playback.scrubber"), Qt::Key_C);
    auto* field = find<QPlainTextEdit>("playback.comment_text");
    QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), field, kPatience_ms);
    QVERIFY(!screen()->clock().playing()); // the moment does not run away
    QVERIFY(field->mapTo(screen(), QPoint(0, field->height())).y() < screen()->height());
    auto* list = find<QListWidget>("playback.comments");
    QVERIFY(field->mapTo(screen(), QPoint()).y() < list->mapTo(screen(), QPoint()).y());
    QTest::keyClicks(field, QStringLiteral("c0+"));
    QCOMPARE(field->toPlainText(), QStringLiteral("c0+")); // letters are letters there
    m_site->context.logIn(*m_tina);
}

void TestPlayback::marksJump() {
    open(m_bad);
    auto* list = find<QListWidget>("playback.marks");
    QVERIFY(list->count() > 5);
    const int all = list->count();
    find<QCheckBox>("playback.contacts")->setChecked(true);
    QVERIFY(list->count() > all);
    find<QCheckBox>("playback.penalties_only")->setChecked(true);
    QVERIFY(list->count() > 0 && list->count() < all);
    list->setCurrentRow(list->count() - 1);
    const double there_s = list->currentItem()->data(Qt::UserRole).toDouble();
    QCOMPARE(screen()->clock().position_s(), there_s);
    screen()->clock().seek(0.0);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Return); // the mark in hand once more, by keyboard
    QCOMPARE(screen()->clock().position_s(), there_s);
    for (const char* of : {"Over the force limit", "gave way"}) // who pressed so hard did both
        QVERIFY2(!list->findItems(QLatin1String(of), Qt::MatchContains).isEmpty(), of);
}

/// An item is as high as its text is where it is drawn, at every width: within the padding of the style
/// sheet.
void TestPlayback::textsOfEventsAreNeverShortened() {
    const desktop::Theme& theme = m_site->context.theme();
    QListWidget list;
    list.setStyleSheet(theme.styleSheet());
    desktop::wrapItems(list, theme);
    const QString text = QStringLiteral("Trial 1, 0:04.2  Miss: the wrong place was marked");
    list.addItem(text);
    list.show();
    const int margin = list.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &list) + 1;
    std::set<int> heights;
    for (int width = 150; width < 480; ++width) {
        list.resize(width, 300);
        list.doItemsLayout();
        const QRect at = list.visualItemRect(list.item(0));
        const int drawn = at.width() - 2 * (theme.px(8) + margin);
        const QRect needs = list.fontMetrics().boundingRect(QRect(0, 0, drawn, 1000), Qt::TextWordWrap, text);
        QVERIFY2(at.height() >= needs.height(), qPrintable(QString::number(width)));
        heights.insert(at.height());
    }
    QVERIFY(heights.size() > 1);
}

/// Where the width has no room for all controls, the time moves to a line of its own, and no control does. It
/// keeps the room of its longest text, so that it stays there while playing.
void TestPlayback::theTimeGivesWayFirst() {
    session::PlaybackTrial trial;
    trial.start_s = 2.0;
    trial.end_s = 9.0;
    desktop::PlaybackClock clock;
    clock.setDuration(10.0);
    desktop::TransportBar bar(m_site->context.theme(), QLocale::c(), clock, {{trial}, false, QLocale::c()});
    const auto* speed = bar.findChild<QComboBox*>(QStringLiteral("playback.speed"));
    const auto* moment = bar.findChild<QLabel*>(QStringLiteral("playback.time"));
    const auto* first = bar.findChild<QPushButton*>(QStringLiteral("playback.begin"));
    const auto below = [&](int width) {
        bar.resize(width, 200);
        bar.grab(); // lays it out
        return moment->y() > speed->geometry().bottom();
    };
    QVERIFY(!below(2000));
    const int all = moment->geometry().right() + 1;
    QVERIFY(below(all - 1));
    QVERIFY(speed->y() < first->geometry().bottom()); // in the first line
    clock.seek(5.0);                                  // its text is shorter now
    QVERIFY(moment->sizeHint().width() < all);
    QVERIFY(below(all - 1));
}

void TestPlayback::ghostBesideIt() {
    open(m_bad);
    auto* choice = find<QComboBox>("playback.ghost");
    QTRY_VERIFY_WITH_TIMEOUT(choice->count() > 1, kPatience_ms);
    const int mine = choice->findData(qlonglong(m_good));
    QVERIFY(mine > 0);
    QVERIFY2(choice->itemText(mine).startsWith(QStringLiteral("My ")), qPrintable(choice->itemText(mine)));
    QCOMPARE(choice->findData(qlonglong(m_bad)), -1); // not beside itself
    choice->setCurrentIndex(mine);
    emit choice->activated(mine);
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("ghost")).toLongLong(),
             m_good);
    auto* plots = screen()->findChild<desktop::PlaybackPlots*>();
    const QString second = QStringLiteral("second session");
    QTRY_VERIFY_WITH_TIMEOUT(plots->force().legendTexts().contains(second), kPatience_ms);
    QVERIFY(plots->speed().legendTexts().contains(second));
    choice->setCurrentIndex(0);
    emit choice->activated(0);
    QVERIFY(!plots->force().legendTexts().contains(second));
    tests::takePictures(*m_site, QStringLiteral("playback_ghost"), [this] {
        open(m_bad, {{QStringLiteral("at_s"), 4.5}, {QStringLiteral("ghost"), qlonglong(m_good)}});
        QTest::qWait(800);
    });
}

void TestPlayback::sceneStateIsTheRecording() {
    tests::OpenStored stored(m_site->database(), 1); // a scripted one: everybody may read it
    auto track = tests::trackOf(*stored.session);
    QVERIFY(track);
    const session::PlaybackTrial& trial = track->trials.at(1);
    const double t_s = 0.5 * (trial.start_s + trial.end_s);
    const scene3d::SceneState state = desktop::sceneStateAt(*track, &*track, t_s);
    const session::PlaybackView view = track->at(t_s);
    QVERIFY(state.tool[0].present && !state.tool[1].present);
    QVERIFY(state.tool[0].p_WT == view.tools[0].p_WT);
    QVERIFY(state.tool[0].force_N == view.tools[0].tissue_N);
    QVERIFY(state.objectShown && state.p_WObject == trial.object->p_WObject);
    QVERIFY(!state.marked);
    QVERIFY(state.ghost.present); // itself: the same place
    QVERIFY((state.ghost.p_WT - state.tool[0].p_WT).norm() < 1e-9);
    QVERIFY(desktop::sceneStateAt(*track, nullptr, trial.end_s).marked);
}

// A second session is felt where the first one is felt, and shown where it is shown: only those were done
// alike.
void TestPlayback::ghostsAreOfTheSameDeviceClass() {
    const auto shown = tests::store(m_site->database(), *m_tina, tests::ReviewSessions::shown(m_made->good));
    const auto alsoShown =
        tests::store(m_site->database(), *m_tina, tests::ReviewSessions::shown(m_made->bad));
    auto reader = m_site->database().openReader();
    QVERIFY(reader);
    const auto ghostsOf = [&](database::SessionId id) {
        std::set<database::SessionId> ids;
        const auto record = database::SessionReader(**reader, *m_tina).session(id);
        const auto found = record ? desktop::listGhosts(**reader, *m_tina, *record, "force_max", true)
                                  : core::Result<std::vector<desktop::GhostCandidate>>();
        if (!record || !found)
            qFatal("ghosts");
        for (const auto& candidate : *found)
            ids.insert(candidate.summary.id);
        return ids;
    };
    QVERIFY((ghostsOf(shown) == std::set<database::SessionId>{alsoShown}));
    QVERIFY((ghostsOf(alsoShown) == std::set<database::SessionId>{shown}));
    const auto felt = ghostsOf(m_good);
    QVERIFY(felt.contains(m_bad) && !felt.contains(shown) && !felt.contains(alsoShown) &&
            !felt.contains(m_good));
}

// One's own first session heads the list, then one's best; of equally good sessions the earliest counts as
// the best.
void TestPlayback::theEarliestOfTheBestStandsOut() {
    for (const auto& recording : {m_made->bad, m_made->good, m_made->good, m_made->bad, m_made->bad})
        tests::store(m_site->database(), *m_tina, tests::ReviewSessions::shown(recording));
    auto reader = m_site->database().openReader();
    QVERIFY(reader);
    database::SessionReader sessions(**reader, *m_tina);
    database::SessionFilter mine;
    mine.person = m_tina->personId();
    mine.state = database::SessionState::completed;
    const auto listed = sessions.listSessions(mine);
    QVERIFY(listed);
    const database::SessionSummary& newest = *std::max_element(
        listed->begin(), listed->end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    for (const bool lowerIsBetter : {true, false}) {
        std::map<double, database::SessionId> earliestWith; // by the metric's value
        for (const database::SessionSummary& summary : *listed) {
            if (summary.id == newest.id || summary.felt != newest.felt ||
                summary.exercise != newest.exercise || summary.level != newest.level)
                continue;
            const auto card = database::ScoreRepository(**reader, *m_tina).scores(summary.id);
            QVERIFY(card);
            for (const scoring::MetricValue& metric : card->metrics)
                if (metric.id == "force_max" && metric.value)
                    if (const auto [at, isNew] = earliestWith.try_emplace(*metric.value, summary.id); !isNew)
                        at->second = std::min(at->second, summary.id);
        }
        QVERIFY(earliestWith.size() > 1);
        const auto record = sessions.session(newest.id);
        const auto found = desktop::listGhosts(**reader, *m_tina, *record, "force_max", lowerIsBetter);
        QVERIFY(found && found->size() >= 4);
        const database::SessionId best =
            lowerIsBetter ? earliestWith.begin()->second : earliestWith.rbegin()->second;
        QCOMPARE(found->front().role, desktop::GhostRole::ownFirst);
        for (std::size_t i = 1; i < found->size(); ++i)
            QCOMPARE((*found)[i].role == desktop::GhostRole::ownBest, (*found)[i].summary.id == best);
    }
}

void TestPlayback::commentAtAMoment() {
    open(m_bad, {{QStringLiteral("at_s"), 6.0}});
    find<QTabWidget>("playback.tabs")->setCurrentIndex(1);
    auto* add = find<QPushButton>("playback.comment_add");
    QVERIFY(!add->isEnabled());
    find<QPlainTextEdit>("playback.comment_text")->setPlainText(QStringLiteral("Here I pressed too hard"));
    QVERIFY(add->isEnabled());
    add->click();
    auto* list = find<QListWidget>("playback.comments");
    QTRY_COMPARE_WITH_TIMEOUT(list->count(), 1, kPatience_ms);
    QVERIFY(list->item(0)->text().contains(QStringLiteral("Here I pressed too hard")));
    QVERIFY(list->item(0)->text().contains(QStringLiteral("You")));
    QVERIFY(find<QPlainTextEdit>("playback.comment_text")->toPlainText().isEmpty());
    auto connection = m_site->database().openReader();
    const auto stored = database::SessionReader(**connection, *m_tina).comments(m_bad);
    QVERIFY(stored && stored->size() == 1 && stored->front().tick);
    QCOMPARE(*stored->front().tick, std::uint64_t{6000});
    screen()->clock().seek(0.0);
    list->setCurrentRow(0);
    QVERIFY(std::abs(screen()->clock().position_s() - 6.0) <= 0.004);
    tests::takePictures(*m_site, QStringLiteral("playback_comments"), [this] {
        open(m_bad, {{QStringLiteral("at_s"), 6.0}});
        find<QTabWidget>("playback.tabs")->setCurrentIndex(1);
    });
}

void TestPlayback::aCommentIsAnsweredAtItsMoment() {
    const auto id = tests::store(m_site->database(), *m_tina, m_made->bad);
    const auto tom = m_site->actor("tom");
    QVERIFY(m_site->database().write([&](database::WriteContext& write) {
        return database::SessionRepository(write.connection(), tom).addComment(id, "Slower here.", 6000);
    }));
    open(id, {{QStringLiteral("at_s"), 1.0}, {QStringLiteral("tab"), QStringLiteral("comments")}});
    auto* list = find<QListWidget>("playback.comments");
    QTRY_COMPARE_WITH_TIMEOUT(list->count(), 1, kPatience_ms);
    auto* reply = find<QPushButton>("playback.comment_reply");
    auto* add = find<QPushButton>("playback.comment_add");
    QVERIFY(reply->isHidden()); // nothing is chosen
    list->setCurrentRow(0);
    QVERIFY(!reply->isHidden());
    reply->click();
    QCOMPARE(add->text(), QStringLiteral("Reply to Tom Trainer"));
    find<QPushButton>("playback.comment_no_reply")->click();
    QVERIFY(add->text().startsWith(QStringLiteral("Comment here")));
    reply->click();
    screen()->clock().seek(2.0); // wherever one looks meanwhile
    find<QPlainTextEdit>("playback.comment_text")->setPlainText(QStringLiteral("I will."));
    add->click();
    QTRY_COMPARE_WITH_TIMEOUT(list->count(), 2, kPatience_ms);
    QVERIFY(list->item(0)->text().contains(QStringLiteral("Slower here.")) &&
            list->item(1)->text().contains(QStringLiteral("I will.")));
    QVERIFY(add->text().startsWith(QStringLiteral("Comment here")));
    auto connection = m_site->database().openReader();
    const auto stored = database::SessionReader(**connection, *m_tina).comments(id);
    QVERIFY(stored && stored->size() == 2);
    QCOMPARE(stored->at(1).tick, std::optional<std::uint64_t>(6000));
    list->setCurrentRow(1);
    QVERIFY(reply->isHidden()); // one's own
    open(id, {{QStringLiteral("at_s"), 1.0},
              {QStringLiteral("reply"), qlonglong(stored->at(0).id)}}); // from a debrief
    QTRY_COMPARE_WITH_TIMEOUT(find<QPushButton>("playback.comment_add")->text(),
                              QStringLiteral("Reply to Tom Trainer"), kPatience_ms);
    QVERIFY(!m_site->context.navigator().current().parameters.contains(QStringLiteral("reply")));
}

/// A moment is told by its trial and the time in it, in the same words at every place.
void TestPlayback::oneClockTellsTheTime() {
    auto connection = m_site->database().openReader();
    const auto data = desktop::loadPlayback(**connection, *m_tina, m_bad, [](double) { return true; });
    QVERIFY(data && data->track.trials.size() > 1);
    const double moment_s = data->track.trials[1].start_s + 1.3;
    open(m_bad, {{QStringLiteral("at_s"), moment_s}});
    QCOMPARE(find<QLabel>("playback.time")->text(), QStringLiteral("Trial 2, 0:01.3"));
    QCOMPARE(find<QPushButton>("playback.comment_add")->text(),
             QStringLiteral("Comment here: Trial 2, 0:01.3"));
    QCOMPARE(find<desktop::Scrubber>("playback.scrubber")->accessibleDescription(),
             QStringLiteral("Trial 2, 0:01.3"));
    for (int row = 0; row < find<QListWidget>("playback.marks")->count(); ++row)
        QVERIFY(find<QListWidget>("playback.marks")->item(row)->text().startsWith(QStringLiteral("Trial ")));
    screen()->clock().seek(0.0);
    const bool before = data->track.trials[0].start_s > 1e-6;
    const QString first = find<QLabel>("playback.time")->text();
    QVERIFY2(before ? first.endsWith(QStringLiteral(" before the start"))
                    : first == QStringLiteral("Trial 1, 0:00.0"),
             qPrintable(first));
}

void TestPlayback::voidNeedsAReasonAndATrainer() {
    const auto id = tests::store(m_site->database(), *m_tina, m_made->good);
    open(id);
    QVERIFY(!find<QPushButton>("playback.void")); // a trainee is not offered it ...
    screen()->declareVoid(QStringLiteral("I would rather not have done this"));
    auto connection = m_site->database().openReader();
    database::SessionReader reader(**connection, *m_tina);
    QTRY_VERIFY_WITH_TIMEOUT(m_site->context.background().idle(),
                             kPatience_ms); // ... and the data layer refuses it
    QTest::qWait(50);
    QCOMPARE(reader.session(id)->summary.state, database::SessionState::completed);

    m_site->logIn("tom");
    open(id);
    find<QPushButton>("playback.void")->click();
    auto* confirm = m_site->find<QPushButton>(QStringLiteral("void.confirm"));
    QVERIFY(confirm && !confirm->isEnabled());
    m_site->find<QPlainTextEdit>(QStringLiteral("void.reason"))->setPlainText(QStringLiteral("  "));
    QVERIFY(!confirm->isEnabled());
    m_site->find<QPlainTextEdit>(QStringLiteral("void.reason"))
        ->setPlainText(QStringLiteral("wrong person at the device"));
    if (const QString folder = qEnvironmentVariable("CHIRON_PICTURES"); !folder.isEmpty())
        m_site->find<QWidget>(QStringLiteral("void"))
            ->grab()
            .save(QDir(folder).filePath(QStringLiteral("void_dialog.png")));
    confirm->click();
    QTRY_COMPARE_WITH_TIMEOUT(reader.session(id)->summary.state, database::SessionState::voided,
                              kPatience_ms);
    QCOMPARE(reader.session(id)->voidReason, std::string("wrong person at the device"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site) && !find<QPushButton>("playback.void"), kPatience_ms);
    find<QPushButton>("playback.reinstate")->click(); // the wrong one was voided
    confirm = m_site->find<QPushButton>(QStringLiteral("reinstate.confirm"));
    QVERIFY(confirm && !confirm->isEnabled());
    m_site->find<QPlainTextEdit>(QStringLiteral("reinstate.reason"))
        ->setPlainText(QStringLiteral("it was the right person"));
    confirm->click();
    QTRY_COMPARE_WITH_TIMEOUT(reader.session(id)->summary.state, database::SessionState::completed,
                              kPatience_ms);
    QCOMPARE(reader.session(id)->decisions.size(), std::size_t{2});
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site) && find<QPushButton>("playback.void"), kPatience_ms);
    m_site->context.logIn(*m_tina);
}

void TestPlayback::nothingRecorded() {
    MadeSession made = m_made->good;
    made.frames.clear();
    const auto id = tests::store(m_site->database(), *m_tina, made);
    m_site->go(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(id)}});
    QTRY_COMPARE_WITH_TIMEOUT(tests::panelOf(*m_site)->state(), desktop::StatePanel::State::empty,
                              kPatience_ms);
    QCOMPARE(find<QLabel>("state.title")->text(), QStringLiteral("Nothing was recorded"));
    if (const QString folder = qEnvironmentVariable("CHIRON_PICTURES"); !folder.isEmpty())
        m_site->window->grab().save(QDir(folder).filePath(QStringLiteral("playback_empty.png")));
}

void TestPlayback::damagedIsNamed() {
    const auto id = tests::store(m_site->database(), *m_tina, m_made->good);
    sqlite3* raw = nullptr; // past everything that keeps a database whole
    QCOMPARE(sqlite3_open(m_site->file().toUtf8().constData(), &raw), SQLITE_OK);
    const std::string flip =
        "UPDATE chunk SET payload = zeroblob(length(payload)) WHERE sequence = 2 AND session_id = " +
        std::to_string(id);
    QCOMPARE(sqlite3_exec(raw, flip.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(raw);
    m_site->go(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(id)}});
    QTRY_COMPARE_WITH_TIMEOUT(tests::panelOf(*m_site)->state(), desktop::StatePanel::State::error,
                              kPatience_ms);
    QVERIFY(find<QLabel>("state.title")->text().contains(QStringLiteral("damaged")));
    QVERIFY(find<QLabel>("state.text")->text().contains(QStringLiteral("chunk 2")));
    if (const QString folder = qEnvironmentVariable("CHIRON_PICTURES"); !folder.isEmpty())
        m_site->window->grab().save(QDir(folder).filePath(QStringLiteral("playback_error.png")));
}

void TestPlayback::nothingClippedOrUnnamed() {
    const QStringList findings = tests::findingsOn(*m_site, [this] { open(m_bad); });
    QVERIFY2(findings.isEmpty(), qPrintable(findings.join(QLatin1Char('\n'))));
}

/// The exercise, an attempt by its number, and the level; a scripted operator's session is no attempt.
void TestPlayback::theHeadSaysWhatWasRecorded() {
    MadeSession scripted = m_made->good;
    scripted.operatorName = "expert";
    const auto own = tests::store(m_site->database(), *m_tina, m_made->good);
    const auto demonstration = tests::store(m_site->database(), *m_tina, scripted);
    const auto heads = [&](database::SessionId id) {
        open(id);
        QStringList texts;
        for (const QLabel* label : screen()->findChildren<QLabel*>())
            texts << label->text();
        return texts;
    };
    auto connection = m_site->database().openReader();
    const int attempt = database::SessionReader(**connection, *m_tina).session(own)->summary.attempt;
    QVERIFY(attempt > 1);
    const auto& exercises = m_site->context.site().catalogue().exercises();
    const auto apex = std::find_if(exercises.begin(), exercises.end(),
                                   [](const auto& exercise) { return exercise.id == "sphere_apex"; });
    QVERIFY(apex != exercises.end());
    const QString exercise = QString::fromStdString(apex->title.at("en")),
                  level = QString::fromStdString(m_made->good.setup.level.title.at("en"));
    QVERIFY(heads(own).contains(
        QStringLiteral("%1, attempt %2 at level 2: %3").arg(exercise).arg(attempt).arg(level)));
    QVERIFY(heads(demonstration).contains(QStringLiteral("%1, level 2: %2").arg(exercise, level)));
}

QTEST_MAIN(TestPlayback)
#include "test_playback.moc"
