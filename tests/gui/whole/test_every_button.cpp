// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/messages.h"
#include "support/every_place.h"
#include "support/screen_outline.h"

#include <QAbstractButton>
#include <QSet>

using namespace chiron;
using namespace chiron::desktop;

namespace {

/// Buttons that begin a session (other tests do that), "Try again", which fails again here, and Qt's own buttons of a row of tabs.
const QSet<QString> kNotPressed{QStringLiteral("setup.start"), QStringLiteral("run.begin"), QStringLiteral("state.action"),
                                QStringLiteral("ScrollLeftButton"), QStringLiteral("ScrollRightButton")};

QString nameOf(const QAbstractButton& button) { return button.objectName() + QLatin1Char(' ') + (button.text().isEmpty() ? button.accessibleName() : button.text()); }

} // namespace

/// Every button does something that can be seen: it opens a window, leads to another screen, shows a message or changes the screen. Training,
/// settings and questionnaires, which have tests of their own, are left out.
class TestEveryButton : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void doesSomething_data();
    void doesSomething();
    void manyWerePressed();
    void cleanupTestCase() { m_desktop.reset(); }

private:
    QList<QAbstractButton*> buttons() const;
    bool changesWhenPressed(QAbstractButton* button);
    bool back(const tests::VisitedPlace& place);

    std::unique_ptr<tests::DesktopFixture> m_desktop;
    std::vector<tests::VisitedPlace> m_places;
    std::string m_person;
    int m_told = 0;
    int m_visited = 0;
    QSet<QString> m_pressed; ///< a screen is visited with several sessions
};

void TestEveryButton::initTestCase() {
    m_desktop = std::make_unique<tests::DesktopFixture>();
    const tests::VisitedSessions sessions = tests::addVisitedSessions(*m_desktop);
    m_places = tests::everyPlace(sessions, tests::addVisitedStudies(*m_desktop));
    m_desktop->window->resize(1280, 720);
    connect(&m_desktop->context.messages(), &Messages::told, this, [this] { ++m_told; });
}

void TestEveryButton::doesSomething_data() {
    QTest::addColumn<int>("index");
    // A running session changes by itself, settings change the whole program, and a questionnaire asks before it is left.
    const QSet<QString> left{QStringLiteral("training"), QStringLiteral("settings"), QStringLiteral("questionnaire")};
    for (std::size_t i = 0; i < m_places.size(); ++i)
        if (!left.contains(m_places[i].place.screen))
            QTest::newRow(m_places[i].name) << static_cast<int>(i);
}

/// The buttons that can be pressed now, except those that are already checked.
QList<QAbstractButton*> TestEveryButton::buttons() const {
    QList<QAbstractButton*> found;
    for (auto* button : m_desktop->window->screen()->findChildren<QAbstractButton*>())
        if (button->isVisible() && button->isEnabled() && !kNotPressed.contains(button->objectName()) && !(button->isCheckable() && button->isChecked()))
            found << button;
    return found;
}

bool TestEveryButton::back(const tests::VisitedPlace& place) {
    m_desktop->context.background().cancelAndWait();
    for (QWidget* top : QApplication::topLevelWidgets())
        if (top != m_desktop->window.get() && top->isVisible())
            top->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return tests::visit(*m_desktop, place, m_person);
}

bool TestEveryButton::changesWhenPressed(QAbstractButton* button) {
    const auto windows = [] {
        QSet<QWidget*> shown;
        for (QWidget* top : QApplication::topLevelWidgets())
            if (top->isVisible() && !top->windowFlags().testFlag(Qt::ToolTip))
                shown << top;
        return shown;
    };
    const QSet<QWidget*> before = windows();
    const QPointer<Screen> screen = m_desktop->window->screen();
    const QStringList outline = tests::ScreenOutline::of(*screen, false, true);
    m_told = 0;
    QTimer::singleShot(0, button, &QAbstractButton::click); // a dialog may hold the click until it is closed
    return QTest::qWaitFor(
        [&] { return m_told > 0 || windows() != before || !screen || m_desktop->window->screen() != screen || tests::ScreenOutline::of(*screen, false, true) != outline; },
        5000);
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
        const auto now = buttons();
        const auto it = std::find_if(now.begin(), now.end(), [&](const auto* button) { return nameOf(*button) == name; });
        if (m_pressed.contains(once) || it == now.end())
            continue;
        m_pressed << once;
        QVERIFY2(changesWhenPressed(*it), qPrintable(QString::fromLatin1(place.name) + QStringLiteral(": nothing comes of ") + name));
        QVERIFY2(back(place), qPrintable(QString::fromLatin1(place.name) + QStringLiteral(" after ") + name));
    }
}

/// Else there would be nothing to fail.
void TestEveryButton::manyWerePressed() {
    if (m_visited > 1) // not of one row alone
        QVERIFY2(m_pressed.size() > 150, qPrintable(QString::number(m_pressed.size())));
}

QTEST_MAIN(TestEveryButton)
#include "test_every_button.moc"
