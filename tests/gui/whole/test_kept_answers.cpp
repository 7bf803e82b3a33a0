// SPDX-License-Identifier: GPL-3.0-or-later
// What the desktop answers: every control of every screen is touched, one after another, and every dialog that comes is filled in and
// accepted. Kept is where that leads, what is said, what a dialog asks, and what has changed on the screen. The places follow each other:
// what was archived stays archived. A change that is meant is kept anew, and the difference is read in review:
// CHIRON_STORE_OUTLINES=1 QT_QPA_PLATFORM=offscreen build/release/tests/gui/whole/test_kept_answers
#include "desktop/screen_catalogue.h"
#include "support/every_place.h"
#include "support/kept_text.h"
#include "support/screen_outline.h"
#include "support/touching_hand.h"

#include <QFileDialog>
#include <QMessageBox>

using namespace chiron;
using tests::TouchingHand;

namespace {

/// What is of the machine or of this moment, takes minutes, or is looked at elsewhere with a running session (gui/training, gui/studies).
bool isLeftAlone(const QString& name) {
    static const QSet<QString> alone{QStringLiteral("setup.start"), QStringLiteral("station.self_test"), QStringLiteral("first_start.demonstration"),
                                     QStringLiteral("playback.play"), QStringLiteral("preview.start"), QStringLiteral("nav.lock"), QStringLiteral("messages.action"), QStringLiteral("Close this message")};
    return alone.contains(name);
}

/// Controls that are alike: levels, sessions, conditions, items.
QString kindOf(const QString& name) {
    static const QRegularExpression number(QStringLiteral("[0-9]+")), exercise(QStringLiteral("^exercise\\.[a-z_]+"));
    return QString(name).replace(number, QStringLiteral("0")).replace(exercise, QStringLiteral("exercise"));
}

/// Passwords and codes that are drawn, moments in names of files.
QString withoutDrawn(QString line) {
    static const QRegularExpression drawn(QStringLiteral("(#(handed\\.password|recovery\\.code|enrol\\.code) )\"[^\"]*\"")),
        password(QStringLiteral("(Recovery code: )[^\"]*")), sealed(QStringLiteral("\"[0-9A-Z]{3}\"")), moment(QStringLiteral("-[0-9]{6}\\b"));
    return line.replace(drawn, QStringLiteral("\\1\"…\"")).replace(password, QStringLiteral("\\1…")).replace(sealed, QStringLiteral("\"…\"")).replace(moment, QStringLiteral("-0"));
}

} // namespace

class TestKeptAnswers : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_desktop = std::make_unique<tests::DesktopFixture>();
        const tests::VisitedSessions sessions = tests::addVisitedSessions(*m_desktop);
        m_places = tests::everyPlace(sessions, tests::addVisitedStudies(*m_desktop));
        m_desktop->window->resize(1280, 720);
        connect(&m_desktop->context.messages(), &desktop::Messages::told, this, [this](const desktop::Message& message) {
            say(QStringLiteral("says %1 \"%2\"%3").arg(static_cast<int>(message.kind)).arg(said(message.text), message.actionText.isEmpty() ? QString() : QStringLiteral(" [%1]").arg(message.actionText)));
            m_undo = message.action;
        });
        // A session begins when its screen is painted: not here.
        connect(&m_desktop->context.navigator(), &desktop::Navigator::moved, this, [this](const desktop::Place& place) {
            if (m_inPlace)
                say(QStringLiteral("goes to %1 %2").arg(place.screen, parameters(place)));
            if (place.screen == QLatin1String("training") || place.screen == QLatin1String("study_trials"))
                m_desktop->context.navigator().replaceNow({QStringLiteral("settings"), {}});
        });
        m_asked.setInterval(5);
        connect(&m_asked, &QTimer::timeout, this, &TestKeptAnswers::answerQuestion);
        m_asked.start();
    }
    void answersAsItDid_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < m_places.size(); ++i)
            if (m_places[i].place.screen != QLatin1String("training") && !QByteArray(m_places[i].name).endsWith("_blind"))
                QTest::newRow(m_places[i].name) << static_cast<int>(i);
    }
    void answersAsItDid() {
        QFETCH(int, index);
        m_place = &m_places[static_cast<std::size_t>(index)];
        m_now = {QStringLiteral("-- there")};
        m_desktop->settings.setTheme(desktop::ThemeName::light);
        m_desktop->settings.setScale(1.0);
        m_desktop->settings.setLanguage(QStringLiteral("en"));
        m_desktop->context.applyAppearance();
        QVERIFY2(goThere(), m_place->name);
        for (std::size_t i = 0; i < m_desktop->screen<desktop::Screen>()->commands().size(); ++i)
            command(i);
        QSet<QString> done;
        for (bool more = true; more;) { // what is touched may bring others
            more = false;
            QVERIFY2(isThere() || goThere(), m_place->name);
            for (const auto& [name, control] : controls()) {
                if (done.contains(name) || isLeftAlone(name) || wouldFreeze(name) || !isNew(name, control))
                    continue;
                done << name;
                more = true;
                const auto* combo = qobject_cast<QComboBox*>(control);
                for (int i = 0, times = combo ? std::clamp(combo->count(), 1, 4) : 1; i < times; ++i) // a choice, some of the way round
                    step(QStringLiteral("touch ") + name, [name = name, this] {
                        if (QWidget* found = find(name))
                            TouchingHand::touch(*found);
                    });
                if (QWidget* found = find(name); found && qobject_cast<QAbstractItemView*>(found))
                    step(QStringLiteral("touch twice ") + name, [found] { TouchingHand::touchTwice(*found); });
                break; // what there is may be another screen now
            }
        }
        m_inPlace = false;
        const QString differs = m_kept.differs(QLatin1String(m_place->name), m_now);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        ++m_held;
    }
    /// What nobody asks for again is no longer kept.
    void keepsNothingOfNoScreen() {
        if (m_held > 1) // not of one row alone
            QCOMPARE(m_kept.unseen(), QStringList());
    }
    void cleanupTestCase() {
        m_asked.stop();
        m_desktop.reset();
    }

private:
    static QString said(const QString& text) { return withoutDrawn(tests::withoutToday(text).replace(QLatin1Char('\n'), QLatin1Char('|')).simplified()); }
    static QString parameters(const desktop::Place& place) {
        QStringList all;
        for (auto it = place.parameters.begin(); it != place.parameters.end(); ++it)
            all << it.key() + QLatin1Char('=') + said(it.value().toString());
        return all.join(QLatin1Char(' '));
    }
    void say(const QString& line) { m_now << line; }

    QStringList outline() const {
        QStringList lines;
        for (const QString& line : tests::ScreenOutline::of(*m_desktop->window->screen(), true, true))
            lines << withoutDrawn(line);
        return lines;
    }
    /// Of the screen; once of the whole window, with the way to other places.
    std::vector<std::pair<QString, QWidget*>> controls() const {
        QWidget* screen = m_desktop->window->screen();
        return TouchingHand::controlsOn(m_place->name == std::string_view("home_researcher") ? *m_desktop->window : *screen);
    }
    bool isThere() const { return m_desktop->window->screen() && m_desktop->context.navigator().current().screen == m_place->place.screen; }
    bool goThere() {
        m_inPlace = false;
        closeDialogs();
        if (!m_desktop->context.loggedIn())
            m_person.clear();
        if (!tests::visit(*m_desktop, *m_place, m_person))
            return false;
        settle();
        m_before = outline();
        m_inPlace = true;
        return true;
    }
    QWidget* find(const QString& name) {
        for (const auto& [is, control] : controls())
            if (is == name)
                return control;
        return nullptr;
    }
    /// Each kind of control once on a kind of screen; where there is an error or nothing, its one button each time.
    bool isNew(const QString& name, const QWidget* control) {
        const QString key = m_place->place.screen + QLatin1Char(' ') + (name == QLatin1String("state.action") ? QLatin1String(m_place->name) : kindOf(name));
        if (m_place->place.screen == QLatin1String("settings") && qobject_cast<const QAbstractButton*>(control))
            return true;
        if (m_touched.contains(key))
            return false;
        m_touched << key;
        return true;
    }

    /// A design is frozen last, since nothing of it can be changed then.
    bool wouldFreeze(const QString& what) const { return what.contains(QLatin1String("freeze"), Qt::CaseInsensitive) && m_place->name != std::string_view("study_preview"); }

    void command(std::size_t index) {
        if (!isThere() && !goThere())
            return;
        const auto commands = m_desktop->screen<desktop::Screen>()->commands();
        if (index >= commands.size())
            return;
        const desktop::ScreenCommand& command = commands[index];
        const QString key = m_place->place.screen + QStringLiteral(" command ") + command.text;
        if (m_touched.contains(key) || wouldFreeze(command.text) || command.text.startsWith(QLatin1String("Play or")) || command.text.contains(QLatin1String("test")) || command.text.contains(QLatin1String("preview")))
            return;
        m_touched << key;
        step(QStringLiteral("command %1 (%2)%3").arg(said(command.text), command.keys.toString(), command.registersKeys ? QString() : QStringLiteral(" by the screen")), command.act);
    }

    /// Something is done, and all that comes of it is taken down.
    void step(const QString& what, const std::function<void()>& act) {
        say(QStringLiteral("-- ") + what);
        m_undo = {};
        m_inPlace = true;
        act();
        settle();
        for (int i = 0; i < 3; ++i) // a dialog may be followed by another one
            if (QDialog* dialog = openDialog()) {
                answer(*dialog);
                settle();
            }
        closeDialogs();
        sayChanges();
        if (const auto undo = std::exchange(m_undo, {})) {
            say(QStringLiteral("then back"));
            undo();
            settle();
            sayChanges();
        }
        if (!isThere())
            goThere();
    }
    void sayChanges() {
        if (!isThere())
            return;
        const QStringList now = outline();
        for (const QString& line : now)
            if (!m_before.contains(line))
                say(line);
        for (const QString& line : m_before)
            if (!now.contains(line))
                say(QStringLiteral("no more ") + line.trimmed().left(80));
        m_before = now;
    }
    /// Until workers are done and what they brought is laid out.
    void settle() {
        for (int quiet = 0, looks = 0; quiet < 2 && looks < 2000; ++looks) {
            for (auto* timer : m_desktop->window->screen()->findChildren<QTimer*>())
                if (timer->isActive() && timer->isSingleShot())
                    timer->start(0); // what waits until nothing more is typed
            QTest::qWait(1);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            quiet = tests::waitUntilLoaded(*m_desktop) ? quiet + 1 : 0;
        }
    }

    QDialog* openDialog() const {
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* dialog = qobject_cast<QDialog*>(top); dialog && dialog->isVisible() && !qobject_cast<QMessageBox*>(dialog))
                return dialog;
        return nullptr;
    }
    void closeDialogs() {
        for (int i = 0; i < 20 && openDialog(); ++i) {
            openDialog()->reject();
            settle();
        }
    }
    /// A dialog is read, filled in from top to bottom, and accepted.
    void answer(QDialog& dialog) {
        if (auto* files = qobject_cast<QFileDialog*>(&dialog))
            return chooseFile(*files);
        const QPointer<QDialog> still(&dialog);
        QStringList before = tests::ScreenOutline::of(dialog, true, true);
        say(QStringLiteral("dialog \"%1\"%2").arg(said(dialog.windowTitle()), dialog.isModal() ? QStringLiteral(" modal") : QString()));
        for (const QString& line : before)
            say(QLatin1Char(' ') + withoutDrawn(line));
        const auto changes = [&] {
            if (!still)
                return say(QStringLiteral("dialog is gone"));
            const QStringList now = tests::ScreenOutline::of(dialog, true, true);
            for (const QString& line : now)
                if (!before.contains(line))
                    say(QLatin1Char(' ') + withoutDrawn(line));
            before = now;
        };
        QString accept;
        QStringList names;
        for (const auto& [name, control] : TouchingHand::controlsOn(dialog))
            names << name;
        for (const auto* button : dialog.findChildren<QPushButton*>())
            if (button->objectName().endsWith(QLatin1String(".accept")) || button->objectName().endsWith(QLatin1String(".confirm")))
                accept = button->objectName();
        names.removeAll(accept);
        for (const QString& name : names + QStringList{accept}) {
            if (!still || name.isEmpty() || name.endsWith(QLatin1String(".cancel")))
                continue;
            for (const auto& [is, control] : TouchingHand::controlsOn(dialog))
                if (is == name) {
                    say(QStringLiteral(" - in it ") + name);
                    TouchingHand::touch(*control);
                    settle();
                    changes();
                    break;
                }
        }
    }
    void chooseFile(QFileDialog& files) {
        const bool saves = files.acceptMode() == QFileDialog::AcceptSave;
        const QString name = files.selectedFiles().isEmpty() ? QString() : QFileInfo(files.selectedFiles().front()).fileName();
        say(QStringLiteral("file dialog \"%1\" %2 %3 \"%4\" suffix \"%5\" filters %6").arg(said(files.windowTitle())).arg(files.acceptMode()).arg(files.fileMode())
                .arg(saves ? said(name) : QString(), files.defaultSuffix(), files.nameFilters().join(QLatin1Char('/'))));
        QDir(m_desktop->folder()).mkpath(QStringLiteral("chosen"));
        const QString chosen = m_desktop->folder() + QStringLiteral("/chosen");
        emit files.fileSelected(files.fileMode() == QFileDialog::Directory ? chosen : chosen + QStringLiteral("/file") + QString::number(++m_files));
        files.reject();
    }
    /// Questions stop the program until they are answered, so this comes by a timer: first it stays, the next time it goes on.
    void answerQuestion() {
        for (QWidget* top : QApplication::topLevelWidgets()) {
            auto* box = qobject_cast<QMessageBox*>(top);
            if (!box || !box->isVisible())
                continue;
            QStringList buttons;
            for (const QAbstractButton* button : box->buttons())
                buttons << QStringLiteral("%1 %2%3").arg(button->text()).arg(box->buttonRole(const_cast<QAbstractButton*>(button))).arg(button == box->defaultButton() ? QStringLiteral("*") : QString());
            say(QStringLiteral("question \"%1\" \"%2\" \"%3\" %4").arg(said(box->windowTitle()), said(box->text()), said(box->informativeText()), buttons.join(QLatin1Char('/'))));
            if (box->defaultButton())
                box->defaultButton()->click();
            else
                box->reject();
            return;
        }
    }

    std::unique_ptr<tests::DesktopFixture> m_desktop;
    std::vector<tests::VisitedPlace> m_places;
    const tests::VisitedPlace* m_place = nullptr;
    std::string m_person;
    QSet<QString> m_touched;
    QStringList m_now, m_before;
    std::function<void()> m_undo;
    QTimer m_asked;
    bool m_inPlace = false;
    int m_files = 0, m_held = 0;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/whole/kept_answers.txt")};
};

QTEST_MAIN(TestKeptAnswers)
#include "test_kept_answers.moc"
