// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/screen_catalogue.h"

#include "desktop/account/account_screen.h"
#include "desktop/debrief/debrief_screen.h"
#include "desktop/exercise_setup/exercise_setup_screen.h"
#include "desktop/first_start/first_start_screen.h"
#include "desktop/frame/screen.h"
#include "desktop/home/comments_screen.h"
#include "desktop/home/exercises_screen.h"
#include "desktop/home/home_screen.h"
#include "desktop/login/login_screen.h"
#include "desktop/people/people_screen.h"
#include "desktop/playback/playback_screen.h"
#include "desktop/progress/progress_screen.h"
#include "desktop/questionnaire/questionnaire_screen.h"
#include "desktop/restore/restore_screen.h"
#include "desktop/results/results_screen.h"
#include "desktop/sessions/sessions_screen.h"
#include "desktop/settings/settings_screen.h"
#include "desktop/station/station_screen.h"
#include "desktop/storage/storage_screen.h"
#include "desktop/studies/studies_screen.h"
#include "desktop/studies/study_screen.h"
#include "desktop/study_data/study_data_screen.h"
#include "desktop/study_run/run_screen.h"
#include "desktop/study_run/trials_screen.h"
#include "desktop/training/training_screen.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

template <class S> Screen* make(AppContext& context, const Place& place) {
    return new S(context, place);
}

} // namespace

const std::vector<ScreenEntry>& screenCatalogue() {
    using enum database::Role;
    static const std::vector<database::Role> everybody{trainee, trainer, researcher, admin};
    // Parameters of the places: exercise_setup {exercise, level}, training {plan}, debrief {session,
    // just_ended}, playback {session, at_s, ghost}, comments {which}, restore {missing, detail}.
    static const std::vector<ScreenEntry> entries{
        {"first_start",
         QT_TRANSLATE_NOOP("Screens", "Welcome"),
         "list-add-user",
         {},
         false,
         &make<FirstStartScreen>},
        {"login",
         QT_TRANSLATE_NOOP("Screens", "Log in"),
         "system-switch-user",
         {},
         false,
         &make<LoginScreen>},
        {"restore",
         QT_TRANSLATE_NOOP("Screens", "Restore a backup"),
         "view-history",
         {},
         false,
         &make<RestoreScreen>},
        {"home", QT_TRANSLATE_NOOP("Screens", "Home"), "go-home", everybody, true, &make<HomeScreen>, false,
         QT_TRANSLATE_NOOP("CommandWords", "start page, dashboard, begin, what next, news")},
        {"exercises", QT_TRANSLATE_NOOP("Screens", "Exercises"), "view-list-icons", everybody, true,
         &make<ExercisesScreen>, false,
         QT_TRANSLATE_NOOP("CommandWords",
                           "train, practise, practice, task, lesson, level, choose an exercise, curriculum")},
        {"exercise_setup",
         QT_TRANSLATE_NOOP("Screens", "Exercise"),
         "media-playback-start",
         {},
         true,
         &make<ExerciseSetupScreen>},
        {"training",
         QT_TRANSLATE_NOOP("Screens", "Training"),
         "media-playback-start",
         {},
         false,
         &make<TrainingScreen>,
         true},
        {"studies",
         QT_TRANSLATE_NOOP("Screens", "Studies"),
         "view-task",
         {researcher, admin},
         true,
         &make<StudiesScreen>,
         false,
         QT_TRANSLATE_NOOP("CommandWords", "experiment, research, trial, participants, questionnaire")},
        {"study", QT_TRANSLATE_NOOP("Screens", "Study"), "view-task", {}, true, &make<StudyScreen>},
        {"study_run",
         QT_TRANSLATE_NOOP("Screens", "Run"),
         "media-playback-start",
         {researcher, admin},
         true,
         &make<RunScreen>},
        {"study_data",
         QT_TRANSLATE_NOOP("Screens", "Data"),
         "office-chart-line",
         {researcher, admin},
         true,
         &make<StudyDataScreen>,
         false,
         QT_TRANSLATE_NOOP("CommandWords", "analysis, statistics, export")},
        {"questionnaire",
         QT_TRANSLATE_NOOP("Screens", "Questionnaire"),
         "document-edit",
         {},
         true,
         &make<QuestionnaireScreen>},
        {"study_trials",
         QT_TRANSLATE_NOOP("Screens", "Trials"),
         "media-playback-start",
         {},
         false,
         &make<TrialsScreen>,
         true},
        {"sessions",
         QT_TRANSLATE_NOOP("Screens", "Sessions"),
         "view-list-details",
         {trainer, researcher, admin},
         true,
         &make<SessionsScreen>,
         false,
         QT_TRANSLATE_NOOP("CommandWords", "recordings, attempts, history, list, playback, debrief")},
        {"progress",
         QT_TRANSLATE_NOOP("Screens", "Progress"),
         "view-statistics",
         {trainer, admin},
         true,
         &make<ProgressScreen>,
         false,
         QT_TRANSLATE_NOOP("CommandWords", "group, class, course, cohort, overview, results, trainees, "
                                           "students, learners, passed, due, who has trained")},
        {"people",
         QT_TRANSLATE_NOOP("Screens", "People"),
         "system-users",
         {admin},
         true,
         &make<PeopleScreen>,
         false,
         QT_TRANSLATE_NOOP("CommandWords", "users, accounts, group, class, roster, trainees, students, "
                                           "names, passwords, roles, add a user")},
        {"storage",
         QT_TRANSLATE_NOOP("Screens", "Storage"),
         "drive-harddisk",
         {admin},
         true,
         &make<StorageScreen>,
         false,
         QT_TRANSLATE_NOOP("CommandWords",
                           "backup, back up, copy, restore, disk, space, database, verify, save")},
        {"station", QT_TRANSLATE_NOOP("Screens", "Station"), "computer", everybody, true,
         &make<StationScreen>, false,
         QT_TRANSLATE_NOOP("CommandWords",
                           "device, haptic, hardware, calibration, check, timing, computer, test")},
        {"results",
         QT_TRANSLATE_NOOP("Screens", "My results"),
         "office-chart-line",
         {trainee},
         true,
         &make<ResultsScreen>,
         false,
         QT_TRANSLATE_NOOP(
             "CommandWords",
             "progress, scores, marks, grades, curve, history, overview, review, export my data")},
        {"comments",
         QT_TRANSLATE_NOOP("Screens", "Comments"),
         "edit-comment",
         {},
         true,
         &make<CommentsScreen>},
        {"debrief",
         QT_TRANSLATE_NOOP("Screens", "Debrief"),
         "view-statistics",
         {},
         true,
         &make<DebriefScreen>},
        {"playback",
         QT_TRANSLATE_NOOP("Screens", "Playback"),
         "media-playback-start",
         {},
         true,
         &make<PlaybackScreen>},
        {"account",
         QT_TRANSLATE_NOOP("Screens", "My account"),
         "user-identity",
         {},
         true,
         &make<AccountScreen>},
        {"settings", QT_TRANSLATE_NOOP("Screens", "Settings"), "configure", everybody, true,
         &make<SettingsScreen>, false,
         QT_TRANSLATE_NOOP("CommandWords",
                           "options, preferences, language, theme, dark mode, text size, sound, volume")},
    };
    return entries;
}

bool finds(const database::RoleSet& roles, const ScreenEntry& entry) {
    return std::any_of(entry.roles.begin(), entry.roles.end(),
                       [&roles](database::Role role) { return roles.contains(role); });
}

const ScreenEntry* findScreen(const QString& id) {
    for (const ScreenEntry& entry : screenCatalogue())
        if (id == QLatin1String(entry.id))
            return &entry;
    return nullptr;
}

QString titleOf(const ScreenEntry& entry) {
    return QCoreApplication::translate("Screens", entry.title);
}

} // namespace chiron::desktop
