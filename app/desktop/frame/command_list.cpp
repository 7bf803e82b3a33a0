// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/command_list.h"

#include "desktop/frame/app_context.h"
#include "desktop/frame/interface_language.h"
#include "desktop/screen_catalogue.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("Commands", text);
}

std::vector<ScreenCommand> places(AppContext& context) {
    std::vector<ScreenCommand> list;
    int number = 0;
    for (const ScreenEntry& entry : screenCatalogue()) {
        if (!finds(context.roles(), entry))
            continue;
        ++number;
        const QKeySequence keys =
            number <= 9 ? QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + number)) : QKeySequence();
        list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Go to: %1")).arg(titleOf(entry)), keys,
                        [&context, id = QLatin1String(entry.id)] { context.navigator().go(QString(id)); }});
    }
    if (context.has(database::Role::trainer))
        list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Sessions to review")), {}, [&context] {
                            context.navigator().go(QStringLiteral("sessions"),
                                                   {{QStringLiteral("review"), QStringLiteral("to_review")}});
                        }});
    if (context.has(database::Role::trainer) || context.has(database::Role::trainee))
        list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Comments")), {}, [&context] {
                            context.navigator().go(QStringLiteral("comments"));
                        }});
    return list;
}

void addLook(AppContext& context, std::vector<ScreenCommand>& list) {
    const auto theme = [&context](ThemeName name) {
        return [&context, name] {
            context.settings().setTheme(name);
            context.applyAppearance();
        };
    };
    list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Colours: light")), {}, theme(ThemeName::light)});
    list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Colours: dark")), {}, theme(ThemeName::dark)});
    list.push_back(
        {words(QT_TRANSLATE_NOOP("Commands", "Colours: high contrast")), {}, theme(ThemeName::highContrast)});
    const auto scaleBy = [&context](double step) {
        return [&context, step] {
            context.settings().setScale(context.settings().scale() + step);
            context.applyAppearance();
        };
    };
    list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Larger text and controls")), QKeySequence::ZoomIn,
                    scaleBy(0.25)});
    list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Smaller text and controls")), QKeySequence::ZoomOut,
                    scaleBy(-0.25)});
    // Each language is named in that language.
    for (const auto& [id, name] : languageChoices())
        list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Language: %1")).arg(name),
                        {},
                        [&context, language = id] { context.setStationLanguage(language); }});
}

std::vector<ScreenCommand> program(AppContext& context, const WindowActions& window) {
    std::vector<ScreenCommand> list{
        {words(QT_TRANSLATE_NOOP("Commands", "Find a command")), QKeySequence(Qt::CTRL | Qt::Key_K),
         window.palette},
        {words(QT_TRANSLATE_NOOP("Commands", "Keyboard shortcuts")), QKeySequence(Qt::Key_Question),
         window.shortcuts},
        {words(QT_TRANSLATE_NOOP("Commands", "Help for this screen")), QKeySequence(Qt::Key_F1), window.help},
        {words(QT_TRANSLATE_NOOP("Commands", "About Chiron")), {}, window.about},
        {words(QT_TRANSLATE_NOOP("Commands", "Back")), QKeySequence(Qt::ALT | Qt::Key_Left),
         [&context] { context.navigator().back(); }}};
    if (context.loggedIn()) {
        list.push_back({words(QT_TRANSLATE_NOOP("Commands", "My account")), {}, [&context] {
                            context.navigator().go(QStringLiteral("account"));
                        }});
        list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Lock")), QKeySequence(Qt::CTRL | Qt::Key_L),
                        [&context] { emit context.lockAsked(); }});
        list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Log out")),
                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L), [&context] { context.logOut(); }});
    }
    addLook(context, list);
    list.push_back({words(QT_TRANSLATE_NOOP("Commands", "Close Chiron")), QKeySequence(Qt::CTRL | Qt::Key_Q),
                    window.close});
    return list;
}

} // namespace

std::vector<CommandGroup> commandsNow(AppContext& context, Screen* screen, const WindowActions& window) {
    std::vector<CommandGroup> groups;
    if (screen && !screen->commands().empty())
        groups.push_back({screen->title(), screen->commands()});
    if (context.loggedIn())
        groups.push_back({words(QT_TRANSLATE_NOOP("Commands", "Screens")), places(context)});
    groups.push_back({words(QT_TRANSLATE_NOOP("Commands", "Program")), program(context, window)});
    return groups;
}

} // namespace chiron::desktop
