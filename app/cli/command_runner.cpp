// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_runner.h"

#include "cli/arguments.h"
#include "cli/cli_errors.h"
#include "cli/command_table.h"
#include "cli/help_text.h"
#include "core/fp_environment.h"

#include <QApplication>
#include <QJsonObject>
#include <cstdio>
#include <memory>

namespace chiron::cli {

namespace {

int fail(const QString& place, const core::Error& error) {
    const QString message = printable(QString::fromStdString(error.message)).trimmed();
    const QByteArray line = QStringLiteral("chiron-cli: %1%2\n").arg(place, message).toUtf8();
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
    return exitCodeOf(error.code);
}

// Either all bytes are written, or the caller gets an error (a full disk, a closed pipe).
int print(const QByteArray& bytes, int exitCode) {
    const auto size = static_cast<std::size_t>(bytes.size());
    if (std::fwrite(bytes.constData(), 1, size, stdout) != size || std::fflush(stdout) != 0)
        return fail({}, stdoutBroke().value());
    return exitCode;
}

int printHelp(const QString& text, bool json) {
    return print(json ? QJsonDocument(QJsonObject{{QStringLiteral("help"), text}}).toJson() : text.toUtf8(),
                 0);
}

/// Prints the version of the program and its build id, which identifies the compiler and the models id.
int printVersion(bool json) {
    const QString build = QString::fromStdString(core::buildId()), version = build.section(u' ', 0, 0);
    return print(json ? QJsonDocument(QJsonObject{{QStringLiteral("program"),
                                                   QJsonObject{{QStringLiteral("version"), version},
                                                               {QStringLiteral("build"), build}}}})
                            .toJson()
                      : QStringLiteral("chiron-cli %1 (%2)\n").arg(version, build).toUtf8(),
                 0);
}

int printOutput(const CommandOutput& output, bool json) {
    if (!json)
        return print(output.text.toUtf8(), output.exitCode);
    return print(output.json.toJson(QJsonDocument::Indented), output.exitCode);
}

// "--database F user list" is equivalent to "user list --database F": this function moves leading common
// options behind the words.
QStringList wordsFirst(QStringList arguments) {
    QStringList moved;
    while (!arguments.isEmpty() && arguments[0].startsWith(QLatin1String("--")) && arguments[0].size() > 2) {
        const QString option = arguments.takeFirst();
        moved << option;
        for (const OptionSpec& common : commonOptions()) {
            if (option.mid(2) == common.name && !common.valueName.isEmpty() && !arguments.isEmpty())
                moved << arguments.takeFirst();
        }
    }
    return arguments + moved;
}

// Without a runtime folder from a session manager (a server, a container), Qt prints a note about the folder
// that it uses instead. The note is of no use to somebody who asked for a report, so this handler drops it.
void withoutPlatformNotes(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (message.startsWith(QLatin1String("QStandardPaths: ")))
        return;
    const QByteArray line = qFormatLogMessage(type, context, message).toUtf8() + '\n';
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
}

// Drawing pictures needs a QApplication but no screen; the offscreen platform always starts.
std::unique_ptr<QCoreApplication> makeApplication(bool draws) {
    static int count = 1;
    static char name[] = "chiron-cli";
    static char* values[] = {name,
                             // Qt's own options are not passed on: -platform with a bad name would abort the
                             // program.
                             nullptr};
    if (draws) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        qInstallMessageHandler(withoutPlatformNotes);
        return std::make_unique<QApplication>(count, values);
    }
    return std::make_unique<QCoreApplication>(count, values);
}

bool isGroup(const QString& word) {
    for (const CommandSpec& command : commandTable()) {
        if (command.group == word && !command.verb.isEmpty())
            return true;
    }
    return false;
}

} // namespace

int runProgram(const QStringList& given) {
    if (auto allowed = refusePasswordArgument(given); !allowed)
        return fail({}, allowed.error());
    const QStringList arguments = wordsFirst(given);
    const bool json = arguments.contains(QStringLiteral("--json"));
    const QString first = arguments.value(0);
    if (first == QLatin1String("--help") || first == QLatin1String("-h") || first == QLatin1String("help") ||
        (first == QLatin1String("--json") && arguments.value(1) == QLatin1String("--help")))
        return printHelp(overallHelp(), json);
    if (first == QLatin1String("--version") || first == QLatin1String("version") ||
        (first == QLatin1String("--json") && arguments.value(1) == QLatin1String("--version")))
        return printVersion(json);
    if (isGroup(first) &&
        (arguments.value(1) == QLatin1String("--help") || arguments.value(1) == QLatin1String("-h")))
        return printHelp(groupHelp(first), json);
    QStringList words = arguments;
    if (!words.isEmpty() && words[0].startsWith(QLatin1String("--")))
        words.clear(); // only options, no command
    const auto found = findCommand(words);
    if (!found)
        return fail({}, found.error());
    const CommandSpec& command = *found->command;
    const auto parsed = Arguments::parse(command, arguments.mid(found->words));
    if (!parsed)
        return fail({}, parsed.error());
    if (parsed->has(QStringLiteral("help")))
        return printHelp(commandHelp(command), json);
    const auto application = makeApplication(command.draws);
    const auto output = command.run(*parsed);
    if (!output) {
        // A typed getter has already put it at the start of the message.
        const QString place = command.name() + QStringLiteral(": ");
        return fail(QString::fromStdString(output.error().message).startsWith(place) ? QString() : place,
                    output.error());
    }
    return printOutput(*output, json);
}

} // namespace chiron::cli
