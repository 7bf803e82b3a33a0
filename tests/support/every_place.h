// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/widgets/state_panel.h"
#include "support/grasp_session.h"
#include "support/insertion_session.h"
#include "support/made_study.h"
#include "support/palpation_session.h"
#include "support/patience.h"

#include <QCoreApplication>
#include <QPushButton>
#include <QTimer>
#include <vector>

namespace chiron::tests {

/// A screen with something on it, and who can see it.
struct VisitedPlace {
    const char* name; ///< of findings and pictures
    const char* person;
    desktop::Place place;
};

/// Sessions to look at: one that passed, one that failed its gates, both tina's. Theo has none.
struct VisitedSessions {
    database::SessionId good = 0;
    database::SessionId bad = 0;
    database::SessionId insertion = 0; ///< a urethra insertion
    database::SessionId tube = 0; ///< an elastic tube, and below objects that were lifted; 0 without them
    database::SessionId tubeTwoHanded = 0;
    database::SessionId handling = 0;
    database::SessionId palpation = 0; ///< 0 without it
};

inline VisitedSessions addVisitedSessions(DesktopFixture& desktop) {
    VisitedSessions sessions;
    sessions.good = desktop.addSession("tina", 1, "expert", 1, 2, 20.0);
    sessions.bad = desktop.addSession("tina", 1, "unsafe", 2, 2, 20.0);
    desktop.addSession("tom", 1, "novice", 3, 1, 20.0);
    sessions.insertion = addInsertion(desktop, "tina");
    sessions.tube = addGrasping(desktop, "tina", "elastic_tube", 1);
    sessions.tubeTwoHanded = addGrasping(desktop, "tina", "elastic_tube", 4);
    sessions.handling = addGrasping(desktop, "tina", "object_handling", 1);
    sessions.palpation = addPalpation(desktop, "tina");
    return sessions;
}

/// The researcher's screens, with studies on them and without.
inline void addStudyPlaces(std::vector<VisitedPlace>& places, const VisitedStudies& studies) {
    const auto add = [&](const char* name, const char* screen, const QVariantMap& parameters) {
        places.push_back({name, "rhea", {QLatin1String(screen), parameters}});
    };
    const auto of = [](database::StudyNumber study, int tab) {
        return QVariantMap{{"study", qlonglong(study)}, {"tab", tab}};
    };
    add("studies", "studies", {});
    add("study_about", "study", of(studies.draft, 0));
    add("study_conditions", "study", of(studies.draft, 1));
    add("study_trials", "study", of(studies.draft, 2));
    add("study_questions", "study", of(studies.draft, 3));
    add("study_preview", "study", of(studies.draft, 4));
    add("study_check", "study", of(studies.draft, 5));
    add("study_participants", "study", of(studies.data, 5));
    add("study_error", "study", of(9999, 0));
    add("run", "study_run", {{"study", qlonglong(studies.data)}, {"participant", studies.waiting}});
    add("run_blind", "study_run", {{"study", qlonglong(studies.blind)}});
    add("data_group", "study_data", of(studies.data, 0));
    add("data_person", "study_data", of(studies.data, 1));
    add("data_trials", "study_data", of(studies.data, 2));
    add("data_questions", "study_data", of(studies.data, 3));
    add("data_comparison", "study_data", of(studies.data, 4));
    add("data_blind", "study_data", of(studies.blind, 0));
    add("questionnaire", "questionnaire",
        {{"study", qlonglong(studies.data)},
         {"participant", studies.waiting},
         {"questionnaire", "validity"}});
}

/// Every screen of the program, empty and failed ones too.
inline std::vector<VisitedPlace> everyPlace(const VisitedSessions& sessions,
                                            const VisitedStudies& studies = {}) {
    const auto place = [](const char* screen, const QVariantMap& parameters = {}) {
        return desktop::Place{QLatin1String(screen), parameters};
    };
    const QVariantMap good{{"session", qlonglong(sessions.good)}};
    const QVariantMap bad{{"session", qlonglong(sessions.bad)}};
    const QVariantMap insertion{{"session", qlonglong(sessions.insertion)}};
    const auto urethra = [](int level) {
        return QVariantMap{{"exercise", "urethra_insertion"}, {"level", level}};
    };
    const QVariantMap apex{{"exercise", "sphere_apex"}, {"level", 1}};
    std::vector<VisitedPlace> places{
        {"first_start", "", place("first_start")},
        {"login", "", place("login")},
        {"home_trainee", "tina", place("home")},
        {"home_trainee_empty", "theo", place("home")},
        {"home_trainer", "tom", place("home")},
        {"home_administrator", "ada", place("home")},
        {"home_researcher", "rhea", place("home")},
        {"exercise_setup", "tina", place("exercise_setup", apex)},
        {"exercise_setup_urethra", "tina", place("exercise_setup", urethra(1))},
        {"exercise_setup_unguided", "tina", place("exercise_setup", urethra(5))},
        {"exercises", "tina", place("exercises")},
        {"debrief_urethra", "tina", place("debrief", insertion)},
        {"playback_urethra", "tina", place("playback", insertion)},
        {"debrief_passed", "tina", place("debrief", good)},
        {"debrief_failed", "tina", place("debrief", bad)},
        {"playback", "tina", place("playback", good)},
        {"playback_trainer", "tom", place("playback", bad)},
        {"debrief_error", "tina", place("debrief", {{"session", 9999}})},
        {"playback_error", "tina", place("playback", {{"session", 9999}})},
        {"exercise_setup_error", "tina", place("exercise_setup", {{"exercise", "no_such_exercise"}})},
        {"results", "tina", place("results")},
        {"results_empty", "theo", place("results")},
        {"sessions", "tom", place("sessions")},
        {"progress", "tom", place("progress")},
        {"comments_empty", "theo", place("comments")},
        {"people", "ada", place("people")},
        {"storage", "ada", place("storage")},
        {"station", "ada", place("station")},
        {"account", "tina", place("account")},
        {"settings", "tina", place("settings")}};
    const auto add = [&](const char* name, database::SessionId session, const char* screen) {
        if (session != 0)
            places.push_back({name, "tina", place(screen, {{"session", qlonglong(session)}})});
    };
    add("debrief_tube", sessions.tube, "debrief");
    add("playback_tube", sessions.tube, "playback");
    add("playback_two_handed", sessions.tubeTwoHanded, "playback");
    add("debrief_handling", sessions.handling, "debrief");
    add("playback_handling", sessions.handling, "playback");
    if (sessions.tube != 0)
        for (const int level : {1, 4})
            places.push_back({level == 1 ? "exercise_setup_tube" : "exercise_setup_two_handed", "tina",
                              place("exercise_setup", {{"exercise", "elastic_tube"}, {"level", level}})});
    if (sessions.handling != 0)
        places.push_back({"exercise_setup_handling", "tina",
                          place("exercise_setup", {{"exercise", "object_handling"}, {"level", 1}})});
    if (sessions.palpation != 0) {
        add("debrief_palpation", sessions.palpation, "debrief");
        add("playback_palpation", sessions.palpation, "playback");
        places.push_back({"exercise_setup_palpation", "tina",
                          place("exercise_setup", {{"exercise", "palpation"}, {"level", 1}})});
        places.push_back(
            {"training_ready", "tina",
             place("training", {{"exercise", "palpation"}, {"level", 4}})}); // the card with the most words
        places.push_back(
            {"training_palpation_hidden", "tina",
             place("training", {{"exercise", "palpation"}, {"level", 4}, {"at_once", true}})}); // two hands
        places.push_back(
            {"results_palpation", "tina", place("results", {{"exercise", "palpation"}, {"level", 1}})});
    }
    if (studies.data != 0)
        addStudyPlaces(places, studies);
    return places;
}

/// Until nothing on the screen is loading any more; false where it never ends.
inline bool waitUntilLoaded(DesktopFixture& desktop) {
    return QTest::qWaitFor(
        [&desktop] {
            if (!desktop.window->screen() || !desktop.context.background().idle())
                return false;
            for (const auto* panel : desktop.window->findChildren<desktop::StatePanel*>())
                if (panel->isVisible() && panel->state() == desktop::StatePanel::State::loading)
                    return false;
            return true;
        },
        kPatience_ms);
}

/// Out of a running session, which is kept as stopped; false if it would not end.
inline bool leaveTraining(DesktopFixture& desktop) {
    if (!desktop.context.trialRuns())
        return true;
    QTimer::singleShot(600, qApp, [&desktop] {
        if (auto* end = desktop.find<QPushButton>(QStringLiteral("training.ask.end")))
            end->click();
    });
    desktop.find<QPushButton>(QStringLiteral("training.end"))->click();
    return QTest::qWaitFor([&desktop] { return !desktop.context.trialRuns(); }, kPatience_ms) &&
           waitUntilLoaded(desktop);
}

/// Goes there as that person ("" for nobody) and waits for what is loaded.
inline bool visit(DesktopFixture& desktop, const VisitedPlace& visited, std::string& present) {
    if (!leaveTraining(desktop))
        return false;
    if (present != visited.person) {
        present = visited.person;
        if (present.empty())
            desktop.context.logOut();
        else
            desktop.logIn(present);
        waitUntilLoaded(desktop);
    }
    desktop.context.navigator().replace(visited.place);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return waitUntilLoaded(desktop);
}

} // namespace chiron::tests
