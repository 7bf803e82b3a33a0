// SPDX-License-Identifier: GPL-3.0-or-later
// The frame around the screens is compared, as lines of text, with what was read and kept: the side bar of
// each role, the banner of a demonstration site, messages, the command palette and the help windows; and so
// is what each command of the program does. To keep an intended change, run this and read the difference in
// review: CHIRON_STORE_OUTLINES=1 xvfb-run -a build/release/tests/gui/frame/test_kept_frame
#include "desktop/frame/command_list.h"
#include "desktop/frame/message_bar.h"
#include "support/desktop_fixture.h"
#include "support/kept_text.h"
#include "support/patience.h"
#include "support/screen_outline.h"

#include <QDialog>
#include <QLineEdit>
#include <QTimer>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::desktop;

namespace {

constexpr const char* kEverybody[] = {"", "ada", "rhea", "tina", "tom"}; // "": nobody is logged in

void addEverybody() {
    QTest::addColumn<QByteArray>("person");
    for (const char* person : kEverybody)
        QTest::newRow(*person ? person : "nobody") << QByteArray(person);
}

/// A desktop on which that person has logged in, so large that nothing scrolls.
std::unique_ptr<tests::DesktopFixture> desktopOf(const QByteArray& person, bool demonstration = false) {
    auto desktop = std::make_unique<tests::DesktopFixture>(demonstration);
    desktop->window->resize(1600, 1100);
    if (person.isEmpty())
        desktop->go(QStringLiteral("login"));
    else
        desktop->logIn(person.toStdString());
    return desktop;
}

/// Where the program is, and how it looks.
QString stateOf(tests::DesktopFixture& desktop) {
    AppContext& context = desktop.context;
    return QStringLiteral("at %1 \"%2\", colours %3, scale %4, language %5%6%7")
        .arg(context.navigator().current().screen, desktop.window->windowTitle())
        .arg(static_cast<int>(context.theme().name()))
        .arg(desktop.settings.scale())
        .arg(desktop.settings.language())
        .arg(context.loggedIn() ? QString() : QStringLiteral(", nobody is logged in"),
             desktop.window->isVisible() ? QString() : QStringLiteral(", closed"));
}

/// The open dialog, or null.
QDialog* openDialog() {
    for (QWidget* top : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<QDialog*>(top); dialog && dialog->isVisible())
            return dialog;
    return nullptr;
}

/// Once the frame before it, which is deleted later, has gone.
QStringList frameOf(tests::DesktopFixture& desktop) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return tests::ScreenOutline::of(*desktop.window);
}

} // namespace

class TestKeptFrame : public QObject {
    Q_OBJECT
private slots:
    void frameIsMadeAsItWas_data() { addEverybody(); }
    void frameIsMadeAsItWas() {
        QFETCH(QByteArray, person);
        const auto desktop = desktopOf(person);
        hold(QStringLiteral("frame"), frameOf(*desktop));
    }

    /// On the screens that take the whole window, too.
    void demonstrationIsSaidEverywhere() {
        const auto desktop = desktopOf("tina", true);
        hold(QStringLiteral("home"), frameOf(*desktop));
        desktop->go(QStringLiteral("exercise_setup"), {{"exercise", "sphere_apex"}, {"level", 1}});
        hold(QStringLiteral("setup"), frameOf(*desktop));
        desktop->context.logOut();
        hold(QStringLiteral("login"), frameOf(*desktop));
    }

    void messagesLookAsTheyDid() {
        const auto desktop = desktopOf("tina");
        bool acted = false;
        for (const MessageKind kind :
             {MessageKind::done, MessageKind::information, MessageKind::warning, MessageKind::error}) {
            const bool asks = kind == MessageKind::done;
            desktop->context.messages().tell({kind, QStringLiteral("What happened."),
                                              asks ? QStringLiteral("Undo") : QString(),
                                              [&] { acted = true; }});
            const auto* bar = desktop->window->findChild<MessageBar*>();
            QVERIFY(bar);
            hold(QString::number(static_cast<int>(kind)), tests::ScreenOutline::of(*bar));
            const auto* timer = bar->findChild<QTimer*>();
            QVERIFY(timer);
            hold(QStringLiteral("%1 stays").arg(static_cast<int>(kind)),
                 {timer->isActive() ? QStringLiteral("for %1 ms").arg(timer->interval())
                                    : QStringLiteral("until it is closed")});
            if (auto* undo = bar->findChild<QPushButton*>(QStringLiteral("messages.action")); asks) {
                undo->click();
                QVERIFY(acted);
                QVERIFY(bar->isHidden());
            }
        }
    }

    void windowsOfTheProgramAreMadeAsTheyWere_data() { addEverybody(); }
    void windowsOfTheProgramAreMadeAsTheyWere() {
        QFETCH(QByteArray, person);
        const auto desktop = desktopOf(person);
        // The buttons of a screen, which appear with what it reads in the background, are commands, too.
        QTRY_VERIFY_WITH_TIMEOUT(desktop->context.background().idle(), kPatience_ms);
        const auto opened = [&](const char* name, Qt::Key key, Qt::KeyboardModifiers with) {
            desktop->window->activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(desktop->window.get()));
            QTest::keyClick(desktop->window.get(), key, with);
            QTRY_VERIFY2_WITH_TIMEOUT(openDialog(), name, kPatience_ms);
            hold(QLatin1String(name), tests::ScreenOutline::of(*openDialog()));
            if (auto* field = openDialog()->findChild<QLineEdit*>(QStringLiteral("palette.field")))
                for (const char* typed : {"lo", "no such thing"}) {
                    field->setText(QLatin1String(typed));
                    hold(QLatin1String(name) + QStringLiteral(" with ") + QLatin1String(typed),
                         tests::ScreenOutline::of(*openDialog()));
                }
            openDialog()->close();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        };
        opened("palette", Qt::Key_K, Qt::ControlModifier);
        if (!person.isEmpty()) // else it is written into the name
            opened("shortcuts", Qt::Key_Question, Qt::NoModifier);
        opened("help", Qt::Key_F1, Qt::NoModifier);
    }

    /// Each command runs on a fresh desktop. Two cases are enough: what the other roles can reach is in their
    /// side bars.
    void commandsDoWhatTheyDid_data() {
        QTest::addColumn<QByteArray>("person");
        QTest::newRow("nobody") << QByteArray();
        QTest::newRow("ada") << QByteArray("ada");
    }
    void commandsDoWhatTheyDid() {
        QFETCH(QByteArray, person);
        QStringList all;
        for (std::size_t at = 0;; ++at) {
            const auto desktop = desktopOf(person);
            if (!person.isEmpty())
                desktop->go(QStringLiteral("settings")); // so that there is a way back
            QString asked;
            const WindowActions window{
                [&] { asked = QStringLiteral("palette"); }, [&] { asked = QStringLiteral("shortcuts"); },
                [&] { asked = QStringLiteral("help"); }, [&] { asked = QStringLiteral("about"); },
                [&] { asked = QStringLiteral("close"); }};
            std::vector<ScreenCommand> commands;
            for (const CommandGroup& group : commandsNow(desktop->context, nullptr, window))
                commands.insert(commands.end(), group.commands.begin(), group.commands.end());
            if (at >= commands.size())
                break;
            QObject::connect(&desktop->context, &AppContext::lockAsked, &desktop->context,
                             [&] { asked = QStringLiteral("lock"); });
            commands[at].act();
            QTRY_VERIFY_WITH_TIMEOUT(desktop->context.background().idle(), kPatience_ms);
            all << QStringLiteral("%1 [%2]: %3%4")
                       .arg(commands[at].text, commands[at].keys.toString(), stateOf(*desktop),
                            asked.isEmpty() ? QString() : QStringLiteral(", asks for ") + asked);
        }
        hold(QStringLiteral("commands"), all);
    }

    void nothingElseIsKept() {
        if (m_held > 20) // not one test alone
            QCOMPARE(m_kept.unseen(), QStringList());
    }

private:
    void hold(const QString& what, const QStringList& lines) {
        ++m_held;
        QString name = QLatin1String(QTest::currentTestFunction()) + QLatin1Char(' ') + what;
        if (const char* row = QTest::currentDataTag())
            name += QStringLiteral(" of ") + QLatin1String(row);
        const QString differs = m_kept.differs(name, lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }

    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/frame/kept_frame.txt")};
    int m_held = 0;
};

QTEST_MAIN(TestKeptFrame)
#include "test_kept_frame.moc"
