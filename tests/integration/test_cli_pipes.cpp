// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"
#include "core/random.h"

#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <QThread>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace chiron;

namespace {

const QByteArray kStaircase =
    R"({"kind":"staircase","start":-0.5,"up":1,"down":2,"steps_up":[0.2,0.1],"minimum":-2,"maximum":0,"stop":{"trials":12}})";

/// Rows that a pipe carries; the long run sends a million.
int rowCount() {
    bool given = false;
    const int rows = qEnvironmentVariableIntValue("CHIRON_ROWS", &given);
    return given ? std::max(1, rows) : 4000;
}

QByteArray table(int rows, core::Random& random) {
    QByteArray csv = "px_m,py_m,pz_m,vx_m_per_s,vy_m_per_s,vz_m_per_s\n";
    for (int i = 0; i < rows; ++i) {
        for (int column = 0; column < 6; ++column)
            csv += QByteArray::number(random.uniform(-0.02, 0.02), 'g', 17) + (column < 5 ? ',' : '\n');
    }
    return csv;
}

CliRun ended(QProcess& process) {
    CliRun run;
    run.ended = process.waitForFinished(600'000) && process.exitStatus() == QProcess::NormalExit;
    run.exitCode = process.exitCode();
    run.out = process.readAllStandardOutput();
    run.err = process.readAllStandardError();
    return run;
}

/// The input straight from a file, as a shell's `<` does it.
CliRun fromFile(const QStringList& arguments, const QString& path) {
    QProcess process;
    process.setStandardInputFile(path);
    process.start(QStringLiteral(CHIRON_CLI), arguments);
    return ended(process);
}

/// The input through a pipe, in pieces of random sizes with random waits between.
CliRun throughPipe(const QStringList& arguments, const QByteArray& input, core::Random& random, int waits) {
    QProcess process;
    process.start(QStringLiteral(CHIRON_CLI), arguments);
    process.waitForStarted();
    const double waitShare = waits * 4096.0 / std::max<double>(4096.0, double(input.size()));
    for (qsizetype at = 0; at < input.size();) {
        const auto size = static_cast<qsizetype>(std::pow(2.0, random.uniform(0.0, 16.0)));
        process.write(input.mid(at, size));
        at += size;
        while (process.bytesToWrite() > 0 && process.waitForBytesWritten(60'000)) {
        }
        if (random.uniform(0.0, 1.0) < waitShare)
            QThread::usleep(static_cast<unsigned long>(random.uniform(0.0, 3000.0)));
    }
    process.closeWriteChannel();
    return ended(process);
}

} // namespace

// What comes through a pipe, at whatever pace and in whatever pieces, is what a file would have given; what
// ends within a row is refused.
class TestCliPipes : public QObject {
    Q_OBJECT
private slots:
    void piecesAreTheFile();
    void cutAnywhere();
    void passwordInPieces();
    void answersInPieces();
    void lastAnswerCutOff();

private:
    QString file(const QString& name, const QByteArray& content) {
        const QString path = m_folder.filePath(name);
        QFile out(path);
        if (!out.open(QIODevice::WriteOnly) || out.write(content) != content.size())
            qFatal("a test file");
        return path;
    }

    QTemporaryDir m_folder;
    const std::uint64_t m_seed = std::random_device{}();
    core::Random m_random{m_seed};
};

void TestCliPipes::piecesAreTheFile() {
    qInfo("seed %llu", static_cast<unsigned long long>(m_seed));
    const int rows = rowCount();
    const QByteArray csv = table(rows, m_random);
    const CliRun whole = fromFile({"evaluate", "hemisphere"}, file("in.csv", csv));
    QCOMPARE(whole.exitCode, 0);
    QCOMPARE(whole.out.count('\n'), rows + 1);
    for (int turn = 0; turn < 3; ++turn) {
        const CliRun run = throughPipe({"evaluate", "hemisphere"}, csv, m_random, 10 * turn);
        QVERIFY2(run.ended && run.exitCode == 0, run.err.constData());
        QVERIFY(run.out == whole.out);
    }
}

void TestCliPipes::cutAnywhere() {
    qInfo("seed %llu", static_cast<unsigned long long>(m_seed));
    const QByteArray csv = table(60, m_random);
    const CliRun whole = fromFile({"evaluate", "hemisphere"}, file("in.csv", csv));
    for (int turn = 0; turn < 60; ++turn) {
        const auto at = static_cast<qsizetype>(m_random.uniform(0.0, double(csv.size())));
        const QByteArray part = csv.left(at);
        const CliRun run = throughPipe({"evaluate", "hemisphere"}, part, m_random, 2);
        if (part.endsWith('\n')) {
            QVERIFY(run.exitCode == 0 && whole.out.startsWith(run.out) &&
                    run.out.count('\n') == part.count('\n'));
            continue;
        }
        const QString fault = refusalFault(run, 3, {QStringLiteral("stdin:%1").arg(part.count('\n') + 1)});
        QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("cut at %1: %2").arg(at).arg(fault)));
    }
    // A number that loses its last digits is still a number.
    const CliRun run = runCli({"evaluate", "hemisphere"},
                              "px_m,py_m,pz_m,vx_m_per_s,vy_m_per_s,vz_m_per_s\n0,0,0.019,0,0,0.1");
    const QString fault = refusalFault(run, 3, {"stdin:2", "line feed"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void TestCliPipes::passwordInPieces() {
    const QString database = m_folder.filePath("site.db");
    const CliRun made = throughPipe({"init", "--admin", "admin", "--database", database, "--password-stdin"},
                                    "a long enough password 1\n", m_random, 0);
    QVERIFY2(made.exitCode == 0, made.err.constData());
    QProcess process;
    process.start(QStringLiteral(CHIRON_CLI),
                  {"user", "list", "--database", database, "--as", "admin", "--password-stdin"});
    QVERIFY(process.waitForStarted());
    for (const char* piece : {"a long en", "ough pass", "word 1", "\n"}) {
        process.write(piece);
        QVERIFY(process.waitForBytesWritten(10'000));
        QThread::msleep(30);
    }
    process.closeWriteChannel();
    const CliRun run = ended(process);
    QVERIFY2(run.exitCode == 0 && run.out.contains("admin"), run.err.constData());
}

void TestCliPipes::answersInPieces() {
    const QString procedure = file("staircase.json", kStaircase);
    const QByteArray answers = "1\n1\n0\n1\n1\n1\n0\n";
    const CliRun whole = runCli({"psychophysics", "adaptive", "--procedure", procedure}, answers);
    const CliRun pieces =
        throughPipe({"psychophysics", "adaptive", "--procedure", procedure}, answers, m_random, 50);
    QCOMPARE(whole.exitCode, 0);
    QVERIFY(whole.out == pieces.out && pieces.exitCode == 0);
}

void TestCliPipes::lastAnswerCutOff() {
    const QString procedure = file("staircase.json", kStaircase);
    const CliRun run =
        runCli({"psychophysics", "adaptive", "--procedure", procedure}, "1\n1 -0.4"); // of -0.45
    QVERIFY2(run.exitCode == 3 && run.err.contains("stdin line 2") && run.err.contains("line feed"),
             run.err.constData());
}

QTEST_GUILESS_MAIN(TestCliPipes)
#include "test_cli_pipes.moc"
