// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/database.h"
#include "desktop/frame/instance_link.h"
#include "support/desktop_fixture.h"
#include "support/patience.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>

using chiron::tests::kPatience_ms;

using namespace chiron;

namespace {

/// The real program on a database, without a screen.
class Program {
public:
    Program(const QString& database, const QString& settings) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        environment.insert(QStringLiteral("CHIRON_CONTENT"),
                           QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content"));
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QStringLiteral(CHIRON_BINARY_DIR "/app/desktop/chiron"),
                      {QStringLiteral("--database"), database, QStringLiteral("--settings"), settings});
    }
    ~Program() {
        process.terminate();
        if (!process.waitForFinished(5000))
            process.kill();
        process.waitForFinished(5000);
    }
    QProcess process;
};

} // namespace

/// Two programs on one database: one writes, the other steps back (data.md, Writing).
class TestTwoDesktops : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("site.db"));
        auto made = database::Database::create(m_file.toStdString(), tests::DesktopFixture::options());
        QVERIFY(made);
    }

    void secondDesktopRaisesTheFirstAndEnds() {
        Program first(m_file, m_folder->filePath(QStringLiteral("a.ini")));
        QVERIFY(first.process.waitForStarted());
        // It listens once it holds the database.
        QVERIFY2(QTest::qWaitFor([&] { return desktop::InstanceLink::raiseOther(m_file); }, kPatience_ms),
                 first.process.readAll().constData());
        Program second(m_file, m_folder->filePath(QStringLiteral("b.ini")));
        QVERIFY2(second.process.waitForFinished(20000), "the second program stayed");
        QCOMPARE(second.process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(second.process.exitCode(), 0);
        QCOMPARE(first.process.state(), QProcess::Running);
    }

    void desktopStaysWhereAnotherProgramWrites() {
        const auto other =
            database::Database::openForWriting(m_file.toStdString(), tests::DesktopFixture::options());
        QVERIFY(other);
        Program late(m_file, m_folder->filePath(QStringLiteral("a.ini")));
        QVERIFY(late.process.waitForStarted());
        QVERIFY2(!late.process.waitForFinished(3000),
                 "it says on the screen who writes, and waits"); // no desktop to raise
        QCOMPARE(late.process.state(), QProcess::Running);
    }

    void aSecondDesktopInTheSameProcessIsRefusedNamingTheHolder() {
        const auto first =
            database::Database::openForWriting(m_file.toStdString(), tests::DesktopFixture::options());
        QVERIFY(first);
        desktop::Settings settings(m_folder->filePath(QStringLiteral("c.ini")));
        desktop::DesktopSite site(m_file, tests::DesktopFixture::options());
        desktop::AppContext context(site, settings);
        core::Error refused;
        connect(&context, &desktop::AppContext::siteFailed, this,
                [&](const core::Error& error) { refused = error; });
        context.openSite();
        QTRY_VERIFY_WITH_TIMEOUT(!refused.message.empty(), kPatience_ms);
        QCOMPARE(refused.code, core::ErrorCode::locked);
        QVERIFY2(QString::fromStdString(refused.message)
                     .contains(QString::number(QCoreApplication::applicationPid())),
                 refused.message.c_str());
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;
};

QTEST_MAIN(TestTwoDesktops)
#include "test_two_desktops.moc"
