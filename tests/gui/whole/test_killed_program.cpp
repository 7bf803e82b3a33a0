// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_reader.h"
#include "desktop/widgets/state_panel.h"
#include "session/replayer.h"
#include "session/site.h"
#include "support/desktop_fixture.h"
#include "support/every_place.h"
#include "support/patience.h"

#include <QDir>
#include <QProcess>

using chiron::tests::kPatience_ms;

using namespace chiron;

namespace {

constexpr int kTicks = 1500;

/// Runs the program until a session has recorded so many ticks, then kills it without a word. The database's
/// path.
QString killedInTheMiddle() {
    QProcess victim;
    victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    victim.start(QStringLiteral(CHIRON_BINARY_DIR "/tests/gui/whole/desktop_victim"),
                 {QString::number(kTicks)});
    QByteArray line;
    while (!line.endsWith('\n') && victim.waitForReadyRead(90000))
        line += victim.readLine();
    victim.kill(); // SIGKILL
    victim.waitForFinished(10000);
    return QString::fromUtf8(line).trimmed();
}

} // namespace

/// kill -9 of the program during a set: the next start lists the interrupted session and replays it.
class TestKilledProgram : public QObject {
    Q_OBJECT
private slots:
    void nextStartListsAndReplaysTheInterruptedSession() {
        const QString file = killedInTheMiddle();
        QVERIFY2(QFile::exists(file), qPrintable(file));
        {
            desktop::Settings settings(file + QStringLiteral(".ini"));
            desktop::DesktopSite site(file, tests::DesktopFixture::options());
            desktop::AppContext context(site, settings);
            desktop::MainWindow window(context);
            window.show();
            context.openSite(); // as the program does after its first paint
            QTRY_VERIFY_WITH_TIMEOUT(site.isOpen(), kPatience_ms);
            QCOMPARE(site.recovered().size(), std::size_t{1});
            QVERIFY2(site.recovered().front().problem.empty(), site.recovered().front().problem.c_str());
            const auto actor = database::AccountService(site.database()).login("tina", tests::kTestPassword);
            QVERIFY(actor);
            isListedAndReplays(site, *actor);
            showsInPlayback(context, window, *actor, site.recovered().front().session);
            context.background().cancelAndWait();
        }
        QDir(QFileInfo(file).path()).removeRecursively();
    }

private:
    static void isListedAndReplays(desktop::DesktopSite& site, const database::Actor& actor) {
        auto reader = site.database().openReader();
        QVERIFY(reader);
        const auto listed = database::SessionReader(**reader, actor).listSessions();
        QVERIFY(listed);
        QCOMPARE(listed->size(), std::size_t{1});
        QCOMPARE(listed->front().state, database::SessionState::interrupted);
        QVERIFY(listed->front().frames >= kTicks);
        auto stored = session::SessionView::open(**reader, actor, listed->front().id);
        QVERIFY(stored);
        const auto replay = session::replaySession(**stored);
        QVERIFY2(replay && replay->identical, replay ? replay->note.c_str() : replay.error().message.c_str());
    }

    static void showsInPlayback(desktop::AppContext& context, desktop::MainWindow& window,
                                const database::Actor& actor, database::SessionId session) {
        context.logIn(actor);
        context.navigator().go(QStringLiteral("playback"), {{QStringLiteral("session"), qlonglong(session)}});
        auto* panel = window.screen()->findChild<desktop::StatePanel*>();
        QVERIFY(panel);
        QTRY_COMPARE_WITH_TIMEOUT(panel->state(), desktop::StatePanel::State::content, kPatience_ms);
    }
};

QTEST_MAIN(TestKilledProgram)
#include "test_killed_program.moc"
