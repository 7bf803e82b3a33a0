// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of every button and every command of every screen, against what was read and kept. A change that
// is meant is kept anew, and the difference is read in review: CHIRON_STORE_OUTLINES=1 xvfb-run -a
// build/release/tests/gui/whole/test_every_button
#include "support/kept_text.h"
#include "support/what_came.h"

#include <QAbstractButton>
#include <QSet>
#include <QTableView>

using namespace chiron;
using namespace chiron::desktop;

namespace {

/// Buttons that begin a session (other tests do that), "Try again", which fails again here, and Qt's own
/// buttons of a row of tabs.
const QSet<QString> kNotPressed{QStringLiteral("setup.start"), QStringLiteral("run.begin"),
                                QStringLiteral("state.action"), QStringLiteral("ScrollLeftButton"),
                                QStringLiteral("ScrollRightButton")};

/// What moves by itself once it has begun, is drawn anew each time or tells how fast the machine is: only
/// that something comes is told.
const QSet<QString> kMoving{
    QStringLiteral("playback.play"),     QStringLiteral("Play or pause"),
    QStringLiteral("station.verify"),    QStringLiteral("station.self_test"),
    QStringLiteral("Run the self-test"), QStringLiteral("Verify the fingertip platform"),
    QStringLiteral("preview.start")};

QString nameOf(const QAbstractButton& button) {
    return button.objectName() + QLatin1Char(' ') +
           (button.text().isEmpty() ? button.accessibleName() : button.text()).simplified();
}

/// "Just now" is soon "1 minute ago".
QString lasting(const QString& name) {
    static const QRegularExpression ago(QStringLiteral("just now|[0-9]+ (minute|hour)s? ago"));
    return tests::withoutToday(name).replace(ago, QStringLiteral("lately"));
}

} // namespace

/// Every button and command does something that can be seen: it opens a window, leads to another screen,
/// shows a message or changes the screen; and what it does is what was kept. Training, settings and
/// questionnaires, which have tests of their own, are left out.
class TestEveryButton : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void doesSomething_data() { addPlaces(); }
    void doesSomething();
    void commandsDoSomething_data() { addPlaces(); }
    void commandsDoSomething();
    void commandsAreHarmlessBeforeAnythingIsLoaded_data() { addPlaces(); }
    void commandsAreHarmlessBeforeAnythingIsLoaded();
    void manyWerePressed();
    void cleanupTestCase() { m_desktop.reset(); }

private:
    void addPlaces();
    QList<QAbstractButton*> buttons() const;
    QPointer<QAbstractButton> buttonOf(const QString& name) const;
    void closeWindows();
    bool back(const tests::VisitedPlace& place);
    bool backAfter(const tests::VisitedPlace& place, const QStringList& came);
    QString heldOf(const tests::VisitedPlace& place, const QString& what, const QStringList& came);

    std::unique_ptr<tests::DesktopFixture> m_desktop;
    std::vector<tests::VisitedPlace> m_places;
    std::string m_person;
    database::StudyNumber m_draft = 0;
    int m_visited = 0;
    QSet<QString> m_pressed; ///< a screen is visited with several sessions
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/whole/kept_buttons.txt")};
};

void TestEveryButton::initTestCase() {
    qputenv("CHIRON_NO_SOUND", "1"); // what the check before freezing says does not depend on the machine
    m_desktop = std::make_unique<tests::DesktopFixture>();
    const tests::VisitedSessions sessions = tests::addVisitedSessions(*m_desktop);
    const tests::VisitedStudies studies = tests::addVisitedStudies(*m_desktop);
    m_draft = studies.draft;
    const auto zoe = database::AccountService(m_desktop->database())
                         .createPerson(m_desktop->actor("ada"),
                                       {"zoe", "Zoe Visitor", database::RoleSet{database::Role::trainee},
                                        tests::kTestPassword, false});
    QVERIFY(zoe.has_value());
    m_places = tests::everyPlace(sessions, studies);
    for (tests::VisitedPlace& place : m_places)
        if (place.place.screen == QLatin1String("playback"))
            place.place.parameters.insert(QStringLiteral("at_s"), 2.0); // so that there is a way back, too
    m_desktop->window->resize(1280, 720);
}

void TestEveryButton::addPlaces() {
    QTest::addColumn<int>("index");
    // A running session changes by itself, settings change the whole program, and a questionnaire asks before
    // it is left.
    const QSet<QString> left{QStringLiteral("training"), QStringLiteral("settings"),
                             QStringLiteral("questionnaire")};
    for (std::size_t i = 0; i < m_places.size(); ++i)
        if (!left.contains(m_places[i].place.screen))
            QTest::newRow(m_places[i].name) << static_cast<int>(i);
}

/// The buttons that can be pressed now, except those that are already checked.
QList<QAbstractButton*> TestEveryButton::buttons() const {
    QList<QAbstractButton*> found;
    for (auto* button : m_desktop->window->screen()->findChildren<QAbstractButton*>())
        if (button->isVisible() && button->isEnabled() && !kNotPressed.contains(button->objectName()) &&
            !(button->isCheckable() && button->isChecked()))
            found << button;
    return found;
}

/// Waits for a button that appears late; null if it does not appear.
QPointer<QAbstractButton> TestEveryButton::buttonOf(const QString& name) const {
    QPointer<QAbstractButton> found;
    (void)QTest::qWaitFor(
        [&] {
            for (auto* button : buttons())
                if (nameOf(*button) == name)
                    found = button;
            return !found.isNull();
        },
        1000);
    return found;
}

void TestEveryButton::closeWindows() {
    m_desktop->context.background().cancelAndWait();
    for (QWidget* top : QApplication::topLevelWidgets())
        if (top != m_desktop->window.get() && top->isVisible())
            top->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

/// Where nothing but a window opened, closing it is enough: some screens take long to build.
bool TestEveryButton::backAfter(const tests::VisitedPlace& place, const QStringList& came) {
    const bool windowOnly = !came.isEmpty() && std::all_of(came.begin(), came.end(), [](const QString& line) {
        return line.startsWith(QLatin1Char(' ')) || line.startsWith(QLatin1String("window "));
    });
    if (!windowOnly)
        return back(place);
    closeWindows();
    return tests::waitUntilLoaded(*m_desktop);
}

bool TestEveryButton::back(const tests::VisitedPlace& place) {
    closeWindows();
    if (place.place.screen ==
        QLatin1String("study")) { // changes to a draft are kept at once: begin with the same one
        m_desktop->context.navigator().replace({QStringLiteral("home"), {}});
        if (!tests::waitUntilLoaded(*m_desktop))
            return false;
        const std::string design = catalogue::studyJson(tests::smallStudy("pilot")).toStdString();
        tests::writeAs(*m_desktop, m_desktop->actor("rhea"),
                       [&](database::StudyRepository& all) { return all.saveDraft(m_draft, design); });
    }
    if (place.place.screen ==
        QLatin1String("sessions")) // a filter is kept for the day, and may leave an empty list
        m_desktop->context.settings().setOfPerson(m_desktop->actor(place.person).personId(),
                                                  QStringLiteral("sessions_filter"), QVariantMap());
    if (!tests::visit(*m_desktop, place, m_person))
        return false;
    // Some buttons need a selected row. We take the last: in the list of people that is Zoe, who never logs
    // in here, so she may be disabled.
    for (auto* table : m_desktop->window->screen()->findChildren<QTableView*>())
        if (table->isVisible() && table->selectionBehavior() == QAbstractItemView::SelectRows &&
            !table->currentIndex().isValid() && table->model())
            table->selectRow(table->model()->rowCount() - 1);
    return tests::waitUntilLoaded(*m_desktop);
}

/// What differs from the kept text; empty if nothing does.
QString TestEveryButton::heldOf(const tests::VisitedPlace& place, const QString& what,
                                const QStringList& came) {
    const QString name = QString::fromLatin1(place.name) + QLatin1Char(' ') + what;
    if (came.isEmpty())
        return name + QStringLiteral(": nothing comes of it");
    // Sealed codes are drawn.
    return QByteArray(place.name).endsWith("_blind") ? QString() : m_kept.differs(lasting(name), came);
}

void TestEveryButton::doesSomething() {
    QFETCH(int, index);
    const tests::VisitedPlace& place = m_places[static_cast<std::size_t>(index)];
    QVERIFY2(back(place), place.name);
    ++m_visited;
    QStringList names;
    for (const auto* button : buttons())
        names << nameOf(*button);
    for (const QString& name : names) {
        const QString once = place.place.screen + QLatin1Char(' ') + name;
        if (m_pressed.contains(once))
            continue;
        const QPointer<QAbstractButton> button = buttonOf(name);
        if (!button)
            continue; // another press took it away
        m_pressed << once;
        const QStringList came = tests::WhatCame(*m_desktop)
                                     .of(
                                         [button] {
                                             if (button)
                                                 button->click();
                                         },
                                         kMoving.contains(button->objectName()));
        const QString wrong = heldOf(place, name, came);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY2(backAfter(place, came),
                 qPrintable(QString::fromLatin1(place.name) + QStringLiteral(" after ") + name));
    }
}

void TestEveryButton::commandsDoSomething() {
    QFETCH(int, index);
    const tests::VisitedPlace& place = m_places[static_cast<std::size_t>(index)];
    QVERIFY2(back(place), place.name);
    const std::size_t many = m_desktop->window->screen()->commands().size();
    for (std::size_t i = 0; i < many; ++i) {
        const ScreenCommand command = m_desktop->window->screen()->commands()[i];
        const QString once = place.place.screen + QStringLiteral(" command ") + command.text;
        if (m_pressed.contains(once))
            continue;
        m_pressed << once;
        const QStringList came =
            tests::WhatCame(*m_desktop)
                .of(command.act, kMoving.contains(command.text), 1500); // of "Undo" at first nothing comes
        const QString name = QStringLiteral("%1 command %2 %3")
                                 .arg(QString::fromLatin1(place.name), command.text, command.keys.toString());
        const QString wrong =
            QByteArray(place.name).endsWith("_blind")
                ? QString()
                : m_kept.differs(lasting(name), came + QStringList{QStringLiteral("that is all")});
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY2(backAfter(place, came), qPrintable(once));
    }
}

/// A person may be faster than the disk.
void TestEveryButton::commandsAreHarmlessBeforeAnythingIsLoaded() {
    QFETCH(int, index);
    const tests::VisitedPlace& place = m_places[static_cast<std::size_t>(index)];
    QVERIFY2(back(place), place.name);
    const std::size_t many = m_desktop->window->screen()->commands().size();
    for (std::size_t i = 0; i < many; ++i) {
        m_desktop->context.navigator().replace(place.place);
        const auto commands = m_desktop->window->screen()->commands();
        if (i >= commands.size())
            break; // the others come with what is loaded
        const QString once = place.place.screen + QStringLiteral(" early ") + commands[i].text;
        if (m_pressed.contains(once))
            continue;
        m_pressed << once;
        QTimer::singleShot(0, m_desktop->window.get(), commands[i].act);
        QCoreApplication::processEvents();
        closeWindows();
    }
    QVERIFY2(back(place), place.name);
}

/// Else there would be nothing to fail.
void TestEveryButton::manyWerePressed() {
    if (m_visited <= 1) // one row alone
        return;
    QVERIFY2(m_pressed.size() > 200, qPrintable(QString::number(m_pressed.size())));
    QCOMPARE(m_kept.unseen(), QStringList());
}

QTEST_MAIN(TestEveryButton)
#include "test_every_button.moc"
