// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>

namespace {
constexpr int kPatience_ms = 120000; // never asserted, only to end a hanging run
}

namespace {

/// Starts it with an environment of its own.
void start(QProcess& process, const QStringList& arguments, const QByteArray& input,
           const QMap<QString, QString>& variables) {
    static const QTemporaryDir home; // nothing of the person who runs the tests is read or written
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name :
         {"CHIRON_PASSWORD", "CHIRON_NEW_PASSWORD", "CHIRON_RECOVERY_CODE", "CHIRON_CONTENT"})
        environment.remove(QLatin1String(name));
    environment.insert(QStringLiteral("HOME"), home.path());
    environment.insert(QStringLiteral("XDG_DATA_HOME"), home.path());
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    for (auto it = variables.begin(); it != variables.end(); ++it)
        environment.insert(it.key(), it.value());
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(CHIRON_CLI), arguments);
    process.write(input);
    process.closeWriteChannel();
}

} // namespace

CliRun runCli(const QStringList& arguments, const QByteArray& input,
              const QMap<QString, QString>& variables) {
    QProcess process;
    start(process, arguments, input, variables);
    CliRun run;
    run.ended = process.waitForFinished(kPatience_ms) && process.exitStatus() == QProcess::NormalExit;
    run.exitCode = process.exitCode();
    run.out = process.readAllStandardOutput();
    run.err = process.readAllStandardError();
    return run;
}

bool killCli(const QStringList& arguments, int after_ms) {
    QProcess process;
    start(process, arguments, {}, {});
    if (process.waitForFinished(after_ms))
        return false;
    process.kill();
    process.waitForFinished(kPatience_ms);
    return process.exitStatus() == QProcess::CrashExit;
}

QString refusalFault(const CliRun& run, int exitCode, const QStringList& mentions) {
    const QString words = QString::fromUtf8(run.err);
    if (!run.ended)
        return QStringLiteral("ended by a signal or not at all");
    if (run.exitCode != exitCode)
        return QStringLiteral("exit status %1, expected %2: %3").arg(run.exitCode).arg(exitCode).arg(words);
    if (!run.out.isEmpty())
        return QStringLiteral("something on stdout: ") + QString::fromUtf8(run.out);
    if (!words.startsWith("chiron-cli: ") || !words.endsWith(QLatin1Char('\n')) ||
        words.count(QLatin1Char('\n')) != 1)
        return QStringLiteral("not one line: ") + words;
    for (const QString& mention : mentions) {
        if (!words.contains(mention))
            return mention + QStringLiteral(" is not in: ") + words;
    }
    return {};
}

QStringList cliCommands() {
    QStringList names;
    bool inside = false;
    for (const QString& line :
         QString::fromUtf8(runCli({QStringLiteral("--help")}).out).split(QLatin1Char('\n'))) {
        if (line == QLatin1String("Commands:"))
            inside = true;
        else if (inside && line.isEmpty())
            break;
        else if (inside)
            names << line.trimmed().section(QStringLiteral("  "), 0, 0);
    }
    return names;
}
