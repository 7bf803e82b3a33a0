// SPDX-License-Identifier: GPL-3.0-or-later
// `study run STUDY --person CODE`: opens the desktop program at that person's trial.
#include "cli/cli_errors.h"
#include "cli/study/study_to_run.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>

namespace chiron::cli {

namespace {

bool hasDisplay() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (!qEnvironmentVariable(name).isEmpty())
            return true;
    return false;
}

/// Looks beside this program, as it is installed or built, and then in the search path for programs.
QString windowProgram() {
    const QString here = QCoreApplication::applicationDirPath();
    for (const QString& place :
         {here + QStringLiteral("/chiron"), here + QStringLiteral("/../desktop/chiron")})
        if (QFileInfo(place).isExecutable() && QFileInfo(place).isFile())
            return QFileInfo(place).absoluteFilePath();
    return QStandardPaths::findExecutable(QStringLiteral("chiron"));
}

} // namespace

core::Result<CommandOutput> openSitting(const QString& database, const QString& study,
                                        const QString& person) {
    if (!hasDisplay())
        return wrongUse(
            QStringLiteral("--person %1: there is no display to open the window on; expected DISPLAY or "
                           "WAYLAND_DISPLAY, or --participant and --observer for a simulated participant")
                .arg(quoted(person)));
    const QString program = windowProgram();
    if (program.isEmpty())
        return core::fail(
            core::ErrorCode::notFound,
            "--person: the program chiron was not found; expected it beside chiron-cli or in PATH");
    qint64 id = 0;
    if (!QProcess::startDetached(program,
                                 {QStringLiteral("--database"), database, QStringLiteral("--study"), study,
                                  QStringLiteral("--person"), person},
                                 {}, &id))
        return core::fail(core::ErrorCode::storage,
                          program.toStdString() +
                              ": the window could not be started; expected a program that may be executed");
    return CommandOutput{
        QJsonDocument(
            QJsonObject{{"study", study}, {"person", person}, {"window", program}, {"process", id}}),
        QStringLiteral("The window opens. After the login it goes to the next trial of %1.\n").arg(person),
        0};
}

} // namespace chiron::cli
