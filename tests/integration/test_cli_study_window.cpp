// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/patience.h"
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QtTest>

using chiron::tests::kPatience_ms;

/// `study run STUDY --person CODE` starts the window at that person's next trial. The program is copied into
/// a folder of its own, and a script beside it that writes down its arguments stands for the window.
class TestCliStudyWindow : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init() { QFile::remove(arguments()); }
    void theWindowIsToldWhoSitsDown();
    void withoutADisplayNothingStarts();
    void aPersonIsNotSimulated();
    void withoutTheWindowsProgramItIsTold();

private:
    struct Run {
        int exitCode = -1;
        QByteArray out, err;
    };
    QString arguments() const { return m_folder.filePath(QStringLiteral("arguments")); }
    Run run(const QStringList& arguments, const QString& platform,
            const QString& program = QStringLiteral("with"));

    QTemporaryDir m_folder;
};

void TestCliStudyWindow::initTestCase() {
    QVERIFY(m_folder.isValid());
    for (const char* place : {"with", "alone"}) {
        QVERIFY(QDir(m_folder.path()).mkdir(QLatin1String(place)));
        QVERIFY(QFile::copy(QStringLiteral(CHIRON_CLI),
                            m_folder.filePath(QLatin1String(place) + QStringLiteral("/chiron-cli"))));
    }
    QFile window(m_folder.filePath(QStringLiteral("with/chiron")));
    QVERIFY(window.open(QIODevice::WriteOnly));
    window.write("#!/bin/sh\nprintf '%s\\n' \"$@\" end > '" + QFile::encodeName(arguments()) +
                 "'\n"); // the shell alone: PATH leads nowhere
    QVERIFY(window.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
}

TestCliStudyWindow::Run TestCliStudyWindow::run(const QStringList& arguments, const QString& platform,
                                                const QString& program) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QLatin1String(name));
    if (!platform.isEmpty())
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), platform);
    environment.insert(QStringLiteral("PATH"), m_folder.filePath(QStringLiteral("nowhere")));
    process.setProcessEnvironment(environment);
    process.start(m_folder.filePath(program + QStringLiteral("/chiron-cli")),
                  QStringList{QStringLiteral("study"), QStringLiteral("run")} + arguments);
    process.waitForFinished(60000);
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

void TestCliStudyWindow::theWindowIsToldWhoSitsDown() {
    const QString database = m_folder.filePath(QStringLiteral("site.db"));
    const Run done = run({"stiffness elastic", "--person", "P07", "--database", database, "--json"},
                         QStringLiteral("offscreen"));
    QVERIFY2(done.exitCode == 0, done.err.constData());
    const auto told = [this] {
        QFile file(arguments());
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    };
    QTRY_VERIFY_WITH_TIMEOUT(told().endsWith(QStringLiteral("end\n")), kPatience_ms);
    QCOMPARE(told().split(QLatin1Char('\n'), Qt::SkipEmptyParts),
             (QStringList{"--database", database, "--study", "stiffness elastic", "--person", "P07", "end"}));
    const QJsonObject json = QJsonDocument::fromJson(done.out).object();
    QCOMPARE(json["person"].toString(), QStringLiteral("P07"));
    QVERIFY(json["process"].toInteger() > 0);
}

void TestCliStudyWindow::withoutADisplayNothingStarts() {
    const Run done = run({"apex", "--person", "P07"}, QString());
    QCOMPARE(done.exitCode, 2);
    QVERIFY2(done.err.contains("no display") && done.err.contains("P07") && done.out.isEmpty(),
             done.err.constData());
    QVERIFY(!QFile::exists(arguments()));
}

void TestCliStudyWindow::aPersonIsNotSimulated() {
    for (const QStringList& more :
         {QStringList{"--participant", "S01"}, QStringList{"--observer", "weber:0.1"}}) {
        const Run done = run(QStringList{"apex", "--person", "P07"} + more, QStringLiteral("offscreen"));
        QCOMPARE(done.exitCode, 2);
        QVERIFY2(done.err.contains("neither --participant nor --observer"), done.err.constData());
    }
    QVERIFY(!QFile::exists(arguments()));
}

void TestCliStudyWindow::withoutTheWindowsProgramItIsTold() {
    const Run done = run({"apex", "--person", "P07"}, QStringLiteral("offscreen"), QStringLiteral("alone"));
    QVERIFY(done.exitCode != 0);
    QVERIFY2(done.err.contains("the program chiron was not found"), done.err.constData());
}

QTEST_GUILESS_MAIN(TestCliStudyWindow)
#include "test_cli_study_window.moc"
