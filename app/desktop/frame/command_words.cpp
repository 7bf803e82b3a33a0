// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/command_words.h"

#include "desktop/frame/palette_search.h"
#include "desktop/screen_catalogue.h"

#include <QCoreApplication>
#include <QStringList>

namespace chiron::desktop {

namespace {

struct OfScreen {
    const char* screen;
    const char* words;
};

struct OfCommand {
    const char* command; ///< as command_list.cpp says it
    const char* words;
};

// Each language has words of its own: they need not say the same ones.
constexpr OfScreen kOfScreens[] = {
    {"home", QT_TRANSLATE_NOOP("CommandWords", "start page, dashboard, begin, what next, news")},
    {"exercises", QT_TRANSLATE_NOOP("CommandWords", "train, practise, practice, task, lesson, level, choose an exercise, curriculum")},
    {"studies", QT_TRANSLATE_NOOP("CommandWords", "experiment, research, trial, participants, questionnaire")},
    {"study_data", QT_TRANSLATE_NOOP("CommandWords", "analysis, statistics, export")},
    {"sessions", QT_TRANSLATE_NOOP("CommandWords", "recordings, attempts, history, list, playback, debrief")},
    {"progress", QT_TRANSLATE_NOOP("CommandWords", "group, class, course, cohort, overview, results, trainees, students, learners, passed, due, who has trained")},
    {"people", QT_TRANSLATE_NOOP("CommandWords", "users, accounts, group, class, roster, trainees, students, names, passwords, roles, add a user")},
    {"storage", QT_TRANSLATE_NOOP("CommandWords", "backup, back up, copy, restore, disk, space, database, verify, save")},
    {"station", QT_TRANSLATE_NOOP("CommandWords", "device, haptic, hardware, calibration, check, timing, computer, test")},
    {"results", QT_TRANSLATE_NOOP("CommandWords", "progress, scores, marks, grades, curve, history, overview, review, export my data")},
    {"settings", QT_TRANSLATE_NOOP("CommandWords", "options, preferences, language, theme, dark mode, text size, sound, volume")},
};

constexpr OfCommand kOfCommands[] = {
    {QT_TRANSLATE_NOOP("Commands", "Sessions to review"), QT_TRANSLATE_NOOP("CommandWords", "assess, feedback, look at, mark, grade, inbox, to do")},
    {QT_TRANSLATE_NOOP("Commands", "Comments"), QT_TRANSLATE_NOOP("CommandWords", "feedback, notes, remarks, messages, answers, replies, review")},
    {QT_TRANSLATE_NOOP("Commands", "Switch user"), QT_TRANSLATE_NOOP("CommandWords", "log out, logout, log off, sign out, change user, leave")},
    {QT_TRANSLATE_NOOP("Commands", "My account"), QT_TRANSLATE_NOOP("CommandWords", "password, profile, name, recovery code")},
    {QT_TRANSLATE_NOOP("Commands", "Close Chiron"), QT_TRANSLATE_NOOP("CommandWords", "quit, exit, end the program, shut down")},
    {QT_TRANSLATE_NOOP("Commands", "Help for this screen"), QT_TRANSLATE_NOOP("CommandWords", "manual, guide, how do I, what is this")},
    {QT_TRANSLATE_NOOP("Commands", "Keyboard shortcuts"), QT_TRANSLATE_NOOP("CommandWords", "keys, hotkeys")},
    {QT_TRANSLATE_NOOP("Commands", "Lock"), QT_TRANSLATE_NOOP("CommandWords", "pause, away, screen lock")},
};

QString words(const char* context, const char* text) { return QCoreApplication::translate(context, text); }

} // namespace

QString furtherWordsOf(const QString& command) {
    for (const OfCommand& each : kOfCommands)
        if (command == words("Commands", each.command))
            return words("CommandWords", each.words);
    for (const OfScreen& each : kOfScreens)
        if (const ScreenEntry* entry = findScreen(QLatin1String(each.screen)); entry && command == words("Commands", "Go to: %1").arg(titleOf(*entry)))
            return words("CommandWords", each.words);
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
