// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/message_bar.h"
#include "desktop/screen_catalogue.h"
#include "support/every_place.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTabBar>

using namespace chiron;
using namespace chiron::desktop;

namespace {

struct Control {
    const QWidget* widget;
    QString name;
    QRect place; ///< what is seen of it, in the window
};

/// Everything that can be used now, but for the message's own buttons.
std::vector<Control> controlsOf(const QWidget& window, const QWidget* besides) {
    std::vector<Control> controls;
    for (const QWidget* each : window.findChildren<QWidget*>()) {
        const bool control =
            qobject_cast<const QAbstractButton*>(each) || qobject_cast<const QLineEdit*>(each) ||
            qobject_cast<const QComboBox*>(each) || qobject_cast<const QAbstractSpinBox*>(each) ||
            qobject_cast<const QAbstractSlider*>(each) || qobject_cast<const QAbstractItemView*>(each) ||
            qobject_cast<const QPlainTextEdit*>(each) || qobject_cast<const QTabBar*>(each);
        if (!control || !each->isVisibleTo(&window) || !each->isEnabled() || each->window() != &window ||
            (besides && besides->isAncestorOf(each)))
            continue;
        const QRect seen = each->visibleRegion().boundingRect();
        if (!seen.isEmpty())
            controls.push_back({each,
                                QStringLiteral("%1 %2").arg(QLatin1String(each->metaObject()->className()),
                                                            each->objectName()),
                                QRect(each->mapTo(&window, seen.topLeft()), seen.size())});
    }
    return controls;
}

/// The same once the page has come to rest: rooms are shared out after a change, on a busy machine later.
std::vector<Control> controlsAtRest(const QWidget& window, const QWidget* besides) {
    std::vector<Control> controls;
    for (int i = 0; i < 40; ++i) {
        QTest::qWait(50);
        std::vector<Control> now = controlsOf(window, besides);
        const bool rests = std::equal(
            controls.begin(), controls.end(), now.begin(), now.end(),
            [](const Control& a, const Control& b) { return a.widget == b.widget && a.place == b.place; });
        controls = std::move(now);
        if (rests)
            break;
    }
    return controls;
}

} // namespace

/// Wherever somebody is, a message covers nothing that can be used and moves nothing, at both ends of the
/// scale.
class TestMessageRoom : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_desktop = std::make_unique<tests::DesktopFixture>();
        const tests::VisitedSessions sessions = tests::addVisitedSessions(*m_desktop);
        m_places = tests::everyPlace(sessions, tests::addVisitedStudies(*m_desktop));
    }
    void cleanupTestCase() { m_desktop.reset(); }

    void nothingIsCovered_data() {
        QTest::addColumn<double>("scale");
        QTest::newRow("100 %") << 1.0;
        QTest::newRow("200 %") << 2.0;
    }

    void nothingIsCovered() {
        QFETCH(double, scale);
        m_desktop->settings.setScale(scale);
        m_desktop->window->resize(1280, 720);
        m_desktop->context.applyAppearance();
        QStringList findings;
        int looked = 0;
        for (const tests::VisitedPlace& place : m_places) {
            QVERIFY2(tests::visit(*m_desktop, place, m_person), place.name);
            QTest::qWait(50);
            const ScreenEntry* entry = findScreen(place.place.screen);
            QVERIFY(entry);
            const auto before = controlsAtRest(*m_desktop->window, nullptr);
            const bool told = hasToStay(*entry);
            m_desktop->context.messages().tell(
                {MessageKind::error,
                 QStringLiteral("The session was not changed. What was recorded is kept; try it again in a "
                                "moment, or ask an administrator."),
                 QStringLiteral("Undo"),
                 {}});
            const auto* bar = m_desktop->window->findChild<MessageBar*>();
            QVERIFY2(bar && bar->isVisible(), place.name);
            const QRect covered(bar->mapTo(m_desktop->window.get(), QPoint()), bar->size());
            QVERIFY2(m_desktop->window->rect().contains(covered), place.name);
            const auto after = controlsAtRest(*m_desktop->window, bar);
            for (const Control& control : after) {
                if (control.place.intersects(covered))
                    findings << QStringLiteral("%1: a message covers %2")
                                    .arg(QLatin1String(place.name), control.name);
                const auto was = std::find_if(before.begin(), before.end(), [&control](const Control& each) {
                    return each.widget == control.widget;
                });
                if (told && was != before.end() && was->place != control.place && !moves(*entry))
                    findings << QStringLiteral("%1: a message moves %2")
                                    .arg(QLatin1String(place.name), control.name);
            }
            looked += static_cast<int>(after.size());
            m_desktop->window->findChild<QPushButton*>(QStringLiteral("messages.action"))->click(); // goes
        }
        findings.removeDuplicates();
        QVERIFY2(findings.isEmpty(), qPrintable(QLatin1Char('\n') + findings.join(QLatin1Char('\n'))));
        QVERIFY(looked > 100);
    }

private:
    /// The login makes room with the first message; a sitting has none to make.
    static bool hasToStay(const ScreenEntry& entry) {
        return QLatin1String(entry.id) != QLatin1String("login");
    }
    /// Plays or measures by itself.
    static bool moves(const ScreenEntry& entry) {
        const QLatin1String id(entry.id);
        return entry.sitting || id == QLatin1String("playback") || id == QLatin1String("station");
    }

    std::unique_ptr<tests::DesktopFixture> m_desktop;
    std::vector<tests::VisitedPlace> m_places;
    std::string m_person;
};

QTEST_MAIN(TestMessageRoom)
#include "test_message_room.moc"
