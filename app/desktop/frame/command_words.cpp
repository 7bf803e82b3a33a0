// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/command_words.h"

#include "desktop/frame/palette_search.h"
#include "desktop/screen_catalogue.h"

#include <QCoreApplication>
#include <QStringList>

namespace chiron::desktop {

namespace {

struct OfCommand {
    const char* command; ///< as in command_list.cpp
    const char* words;
};

// Like ScreenEntry::furtherWords, for commands that do not open a screen of the navigation.
constexpr OfCommand kOfCommands[] = {
    {QT_TRANSLATE_NOOP("Commands", "Sessions to review"),
     QT_TRANSLATE_NOOP("CommandWords", "assess, feedback, look at, mark, grade, inbox, to do")},
    {QT_TRANSLATE_NOOP("Commands", "Comments"),
     QT_TRANSLATE_NOOP("CommandWords", "feedback, notes, remarks, messages, answers, replies, review")},
    {QT_TRANSLATE_NOOP("Commands", "Log out"),
     QT_TRANSLATE_NOOP("CommandWords", "switch user, logout, log off, sign out, change user, leave")},
    {QT_TRANSLATE_NOOP("Commands", "My account"),
     QT_TRANSLATE_NOOP("CommandWords", "password, profile, name, recovery code")},
    {QT_TRANSLATE_NOOP("Commands", "Close Chiron"),
     QT_TRANSLATE_NOOP("CommandWords", "quit, exit, end the program, shut down")},
    {QT_TRANSLATE_NOOP("Commands", "Help for this screen"),
     QT_TRANSLATE_NOOP("CommandWords", "manual, guide, how do I, what is this")},
    {QT_TRANSLATE_NOOP("Commands", "Keyboard shortcuts"), QT_TRANSLATE_NOOP("CommandWords", "keys, hotkeys")},
    {QT_TRANSLATE_NOOP("Commands", "Lock"), QT_TRANSLATE_NOOP("CommandWords", "pause, away, screen lock")},
};

QString words(const char* context, const char* text) {
    return QCoreApplication::translate(context, text);
}

} // namespace

QString furtherWordsOf(const QString& command) {
    for (const OfCommand& each : kOfCommands)
        if (command == words("Commands", each.command))
            return words("CommandWords", each.words);
    for (const ScreenEntry& entry : screenCatalogue())
        if (*entry.furtherWords && command == words("Commands", "Go to: %1").arg(titleOf(entry)))
            return words("CommandWords", entry.furtherWords);
    return {};
}

QString furtherWordThatFits(const QString& typed, const QString& command) {
    const QString wanted = forSearch(typed.simplified());
    if (wanted.isEmpty())
        return {};
    for (const QString& word : furtherWordsOf(command).split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const QString folded = forSearch(word.trimmed());
        const qsizetype at = folded.indexOf(wanted);
        if (at == 0 || (at > 0 && folded.at(at - 1).isSpace()))
            return word.trimmed();
    }
    return {};
}

} // namespace chiron::desktop
