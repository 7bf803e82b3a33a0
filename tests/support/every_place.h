// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/widgets/state_panel.h"
#include "support/grasp_session.h"
#include "support/insertion_session.h"

#include <QCoreApplication>
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
    database::SessionId tube = 0;      ///< an elastic tube, and below objects that were lifted; 0 without them
    database::SessionId tubeTwoHanded = 0;
    database::SessionId handling = 0;
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
    return sessions;
}

/// Every screen of the program, empty and failed ones too.
inline std::vector<VisitedPlace> everyPlace(const VisitedSessions& sessions) {
    const auto place = [](const char* screen, const QVariantMap& parameters = {}) { return desktop::Place{QLatin1String(screen), parameters}; };
    const QVariantMap good{{"session", qlonglong(sessions.good)}};
    const QVariantMap bad{{"session", qlonglong(sessions.bad)}};
    const QVariantMap insertion{{"session", qlonglong(sessions.insertion)}};
    const auto urethra = [](int level) { return QVariantMap{{"exercise", "urethra_insertion"}, {"level", level}}; };
    const QVariantMap apex{{"exercise", "sphere_apex"}, {"level", 1}};
    std::vector<VisitedPlace> places{{"first_start", "", place("first_start")},
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
            {"people", "ada", place("people")},
            {"storage", "ada", place("storage")},
            {"station", "ada", place("station")},
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
        places.push_back({"exercise_setup_handling", "tina", place("exercise_setup", {{"exercise", "object_handling"}, {"level", 1}})});
    return places;
}

/// Until nothing on the screen is loading any more; false after ten seconds.
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
        10000);
}

/// Goes there as that person ("" for nobody) and waits for what is loaded.
inline bool visit(DesktopFixture& desktop, const VisitedPlace& visited, std::string& present) {
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
