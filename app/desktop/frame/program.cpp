// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/program.h"

#include "desktop/backups/exit_backup.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/instance_link.h"
#include "desktop/frame/interface_language.h"
#include "desktop/frame/main_window.h"
#include "desktop/frame/start_trace.h"
#include "desktop/restore/restore_screen.h"
#include "desktop/study_run/asked_sitting.h"
#include "desktop/widgets/logo.h"

#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <cstring>

namespace chiron::desktop {

namespace {

void describe(QCommandLineParser& arguments) {
    arguments.setApplicationDescription(QStringLiteral("Chiron: learn by touch"));
    arguments.addHelpOption();
    arguments.addVersionOption();
    arguments.addOption({QStringLiteral("database"),
                         QStringLiteral("The database to work on (default: the user's own)."),
                         QStringLiteral("FILE")});
    arguments.addOption({QStringLiteral("settings"),
                         QStringLiteral("Where look and language are remembered (default: the user's own)."),
                         QStringLiteral("FILE")});
    arguments.addOption(
        {QStringLiteral("study"),
         QStringLiteral("With --person: open this study, by its id or number, after the login."),
         QStringLiteral("STUDY")});
    arguments.addOption(
        {QStringLiteral("person"),
         QStringLiteral("With --study: go to the next trial of the participant with this code."),
         QStringLiteral("CODE")});
}

QString databaseFile(const QCommandLineParser& arguments) {
    const QString given = arguments.value(QStringLiteral("database"));
    if (!given.isEmpty())
        return QFileInfo(given).absoluteFilePath();
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation))
        .filePath(QStringLiteral("chiron/chiron.db"));
}

/// A second desktop on this database raises this window. If this is the second one, it raises the first and
/// exits.
void connectInstances(AppContext& context, MainWindow& window, InstanceLink& link,
                      QApplication& application) {
    QObject::connect(&context, &AppContext::siteOpened, &link, [&context, &link] {
        if (const auto listens = link.listen(); !listens)
            qWarning("A second program on this database could not raise this window: %s",
                     listens.error().message.c_str());
    });
    QObject::connect(&link, &InstanceLink::raiseAsked, &window, [&window] {
        window.setWindowState(window.windowState() & ~Qt::WindowMinimized);
        window.raise();
        window.activateWindow();
    });
    QObject::connect(
        &context, &AppContext::siteFailed, &application, [&context, &application](const core::Error& error) {
            if (error.code == core::ErrorCode::locked && InstanceLink::raiseOther(context.site().file()))
                application.quit();
        });
}

} // namespace

void applyAppearance(QApplication& application, AppContext& context) {
    installLanguage(application, context.language());
    QLocale::setDefault(context.locale());
    QApplication::setWindowIcon(logoIcon());
    application.setFont(context.theme().font(TextStyle::body));
    application.setPalette(context.theme().palette());
    application.setStyleSheet(context.theme().styleSheet());
}

Place firstPlace(const DesktopSite& site) {
    const std::string folder = database::siteFolderFor(site.file().toStdString(), site.options());
    if (site.exists())
        return {QStringLiteral("login"), {}};
    if (QFileInfo::exists(QString::fromStdString(folder) + QStringLiteral("/site.key")))
        return RestoreScreen::placeFor({database::FileHealth::missing, {}});
    return {QStringLiteral("first_start"), {}};
}

bool asksForText(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i)
        for (const char* word : {"-h", "--help", "--help-all", "-v", "--version"})
            if (std::strcmp(argv[i], word) == 0)
                return true;
    return false;
}

int tellText(const QStringList& arguments) {
    QCommandLineParser parser;
    describe(parser);
    parser.process(arguments); // prints the text and ends the program
    return 0;
}

int runProgram(QApplication& application) {
    QCommandLineParser arguments;
    describe(arguments);
    arguments.process(application);
    traceStart("application");

    Settings settings(arguments.value(QStringLiteral("settings")));
    DesktopSite site(databaseFile(arguments));
    AppContext context(site, settings);
    applyAppearance(application, context);
    traceStart("appearance");
    QObject::connect(&context, &AppContext::appearanceChanged, &application,
                     [&] { applyAppearance(application, context); });
    MainWindow window(context); // after the connection above, so that the window is rebuilt in the new look
    context.navigator().replace(firstPlace(site));
    QObject::connect(&window, &MainWindow::firstPainted, &context, [&] {
        traceStart("first_paint");
        if (site.exists())
            context.openSite();
    });
    if (arguments.isSet(QStringLiteral("study")) && arguments.isSet(QStringLiteral("person")))
        followAskedSitting(
            context, {arguments.value(QStringLiteral("study")), arguments.value(QStringLiteral("person"))});
    InstanceLink link(site.file());
    connectInstances(context, window, link, application);
    traceStart("window_made");
    window.show();
    traceStart("window_shown");
    const int status = QApplication::exec();
    backUpAtExit(context);
    context.background().cancelAndWait();
    return status;
}

} // namespace chiron::desktop
