// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of every screen: desktop_pictures FOLDER [LOOK ...] [PLACE ...]; a place by the beginning of its
// name ("playback"). Needs a display (Xvfb will do), because the 3D scene is only on the screen, not in the
// widgets. Makes its own site; the sessions in it are scripted.
#include "desktop/screen_catalogue.h"
#include "desktop/training/training_screen.h"
#include "study_pictures.h"
#include "support/every_place.h"
#include "support/patience.h"

#include <QDir>
#include <QMouseEvent>
#include <QScreen>
#include <QWheelEvent>
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <utility>

using chiron::tests::kPatience_ms;

using namespace chiron;

namespace {

struct Look {
    const char* name;
    desktop::ThemeName theme;
    double scale;
    const char* language;
    int height =
        720; ///< of the window; a page that scrolls is seen whole in a high one, which needs a screen as high
    bool asked = false; ///< only where it is asked for
};

/// Which places are taken: all, or those whose names begin so.
class Wanted {
public:
    explicit Wanted(QStringList places) : m_places(std::move(places)) {}
    bool has(const char* name) const {
        return m_places.isEmpty() ||
               std::any_of(m_places.begin(), m_places.end(),
                           [name](const QString& place) { return QLatin1String(name).startsWith(place); });
    }

private:
    QStringList m_places;
};

constexpr Look kLooks[] = {{"light", desktop::ThemeName::light, 1.0, "en"},
                           {"dark", desktop::ThemeName::dark, 1.0, "en"},
                           {"contrast", desktop::ThemeName::highContrast, 1.0, "en"},
                           {"de", desktop::ThemeName::light, 1.0, "de"},
                           {"el", desktop::ThemeName::light, 1.0, "el"},
                           {"large_de", desktop::ThemeName::light, 2.0, "de"},
                           {"large", desktop::ThemeName::light, 2.0, "en", 720, true},
                           {"large_el", desktop::ThemeName::light, 2.0, "el", 720, true},
                           {"dark_de", desktop::ThemeName::dark, 1.0, "de", 720, true},
                           {"dark_el", desktop::ThemeName::dark, 1.0, "el", 720, true},
                           {"large_dark", desktop::ThemeName::dark, 2.0, "en", 720, true},
                           {"large_dark_de", desktop::ThemeName::dark, 2.0, "de", 720, true},
                           {"large_dark_el", desktop::ThemeName::dark, 2.0, "el", 720, true},
                           {"whole", desktop::ThemeName::light, 1.0, "en", 2400, true},
                           {"whole_dark", desktop::ThemeName::dark, 1.0, "de", 2400, true}};

void take(const tests::DesktopFixture& desktop, const QString& file) {
    QTest::qWait(700); // scenes draw their first frames
    const QPixmap picture =
        desktop.window->screen()->window()->windowHandle()->screen()->grabWindow(desktop.window->winId());
    if (!picture.save(file))
        std::fprintf(stderr, "could not write %s\n", qPrintable(file));
    std::printf("%s\n", qPrintable(file));
}

/// Out of the session, or the next look waits for its end.
void leave(tests::DesktopFixture& desktop) {
    if (!tests::leaveTraining(desktop))
        std::fprintf(stderr, "the session did not end\n");
}

/// A demonstration running for some seconds, then paused.
void takeTraining(tests::DesktopFixture& desktop, const QDir& folder, const Look& look, std::string& person) {
    const tests::VisitedPlace setup{"training",
                                    "tina",
                                    {QStringLiteral("training"),
                                     {{"exercise", "sphere_apex"},
                                      {"level", 1},
                                      {"device", "demonstration"},
                                      {"operator", "intermediate"}}}};
    tests::visit(desktop, setup, person);
    QTest::qWait(9000);
    take(desktop, folder.filePath(QStringLiteral("training_%1.png").arg(QLatin1String(look.name))));
    QTest::keyClick(desktop.window.get(), Qt::Key_Space);
    QTest::qWait(900);
    take(desktop, folder.filePath(QStringLiteral("training_paused_%1.png").arg(QLatin1String(look.name))));
    QTest::keyClick(desktop.window.get(), Qt::Key_Escape);
    QTest::qWait(300);
    take(desktop, folder.filePath(QStringLiteral("training_stopped_%1.png").arg(QLatin1String(look.name))));
    leave(desktop);
}

/// P1's screen: a scripted endoscopist on the way through the urethra.
void takeInsertion(tests::DesktopFixture& desktop, const QDir& folder, const Look& look,
                   std::string& person) {
    const tests::VisitedPlace setup{"training_urethra",
                                    "tina",
                                    {QStringLiteral("training"),
                                     {{"exercise", "urethra_insertion"},
                                      {"level", 3},
                                      {"device", "demonstration"},
                                      {"operator", "expert"}}}};
    tests::visit(desktop, setup, person);
    QTest::qWait(17000);
    take(desktop, folder.filePath(QStringLiteral("training_urethra_%1.png").arg(QLatin1String(look.name))));
    leave(desktop);
}

/// Scripted laparoscopists at the tube and at the ovaries, some seconds into a trial; what the catalogue
/// lacks is left out.
void takeGrasping(tests::DesktopFixture& desktop, const QDir& folder, const Look& look, std::string& person,
                  const Wanted& wanted) {
    struct Taken {
        const char* name;
        const char* exercise;
        int level;
        int after_ms;
    };
    for (const Taken& taken :
         {Taken{"training_tube", "elastic_tube", 1, 7000}, Taken{"training_mark", "elastic_tube", 2, 7000},
          Taken{"training_two_handed", "elastic_tube", 4, 16000},
          Taken{"training_transfer", "elastic_tube", 5, 11000},
          Taken{"training_handling", "object_handling", 1, 12000},
          Taken{"training_weighing", "object_handling", 3, 10000}}) {
        if (!wanted.has(taken.name) || !desktop.context.site().catalogue().find(taken.exercise, taken.level))
            continue;
        const tests::VisitedPlace setup{taken.name,
                                        "tina",
                                        {QStringLiteral("training"),
                                         {{"exercise", taken.exercise},
                                          {"level", taken.level},
                                          {"device", "demonstration"},
                                          {"operator", "expert"}}}};
        tests::visit(desktop, setup, person);
        QTest::qWait(taken.after_ms);
        take(desktop,
             folder.filePath(
                 QStringLiteral("%1_%2.png").arg(QLatin1String(taken.name), QLatin1String(look.name))));
        leave(desktop);
    }
}

/// A hand of one's own on the tissue, by mouse and wheel, with a finding: every level of palpation.
void takePalpation(tests::DesktopFixture& desktop, const QDir& folder, const Look& look, std::string& person,
                   const Wanted& wanted) {
    for (const auto& [name, level] : {std::pair{"training_palpation", 1},
                                      {"training_palpation_single", 2},
                                      {"training_palpation_rated", 3},
                                      {"training_palpation_hands", 4},
                                      {"training_palpation_pattern", 5}}) {
        if (!wanted.has(name) || !desktop.context.site().catalogue().find("palpation", level))
            continue;
        tests::visit(
            desktop,
            {name, "tina", {QStringLiteral("training"), {{"exercise", "palpation"}, {"level", level}}}},
            person);
        tests::pressGo(desktop);
        auto* screen = desktop.screen<desktop::TrainingScreen>();
        const auto state = [screen] {
            return screen->feed() ? screen->feed()->state() : haptics::DisplayState{};
        };
        if (!QTest::qWaitFor([&] { return state().phase == core::TrialPhase::running; }, kPatience_ms))
            std::fprintf(stderr, "%s: the trial did not begin\n", name);
        QObject* scene = screen->scene()->inputSource();
        QWidget* widget = screen->scene()->widget();
        const QPoint middle = widget->rect().center();
        const auto mouse = [&](QEvent::Type type, QPoint at, Qt::MouseButton button) {
            QMouseEvent event(type, at, widget->mapToGlobal(at), button,
                              type == QEvent::MouseButtonPress ? button : Qt::NoButton, Qt::NoModifier);
            QApplication::sendEvent(scene, &event);
        };
        const auto press = [&](double force_N) {
            for (int i = 0; i < 120 && state().tool[0].tissue[2] < force_N; ++i) {
                QWheelEvent event(middle, widget->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton,
                                  Qt::NoModifier, Qt::NoScrollPhase, false);
                QApplication::sendEvent(scene, &event);
                QTest::qWait(30);
            }
        };
        press(0.8);
        for (int i = 1; i <= 40; ++i) { // a stroke
            mouse(QEvent::MouseMove, middle + QPoint(2 * i, i), Qt::NoButton);
            QTest::qWait(25);
        }
        press(0.8);
        mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton);
        mouse(QEvent::MouseButtonRelease, middle, Qt::LeftButton);
        take(desktop,
             folder.filePath(QStringLiteral("%1_%2.png").arg(QLatin1String(name), QLatin1String(look.name))));
        leave(desktop);
    }
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT3D_RENDERER", "opengl");
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2) {
        std::fprintf(stderr, "usage: desktop_pictures FOLDER [NAME ...]\n");
        return 2;
    }
    const QDir folder(arguments.at(1));
    folder.mkpath(QStringLiteral("."));
    QStringList looks;
    QStringList names;
    for (const QString& argument : arguments.mid(2))
        (std::any_of(std::begin(kLooks), std::end(kLooks),
                     [&](const Look& look) { return argument == QLatin1String(look.name); })
             ? looks
             : names)
            << argument;
    const Wanted wanted(names);
    tests::DesktopFixture desktop;
    const bool onlyStudies =
        !names.isEmpty() && std::all_of(names.begin(), names.end(), [](const QString& name) {
            const QStringList of{QStringLiteral("stud"), QStringLiteral("run"), QStringLiteral("data"),
                                 QStringLiteral("questionnaire"), QStringLiteral("home_researcher")};
            return std::any_of(of.begin(), of.end(),
                               [&name](const QString& beginning) { return name.startsWith(beginning); });
        });
    const tests::VisitedSessions sessions =
        onlyStudies ? tests::VisitedSessions() : tests::addVisitedSessions(desktop); // they take a while
    const tests::VisitedStudies studies = tests::addVisitedStudies(desktop);
    const tests::MoreStudies more = studies.data != 0 ? tests::addMoreStudies(desktop) : tests::MoreStudies();
    auto places = tests::everyPlace(sessions, studies);
    if (studies.data != 0)
        tests::addMorePlaces(places, studies, more);
    std::string person;
    for (const Look& look : kLooks) {
        if (looks.isEmpty() ? look.asked : !looks.contains(QLatin1String(look.name)))
            continue;
        desktop.window->resize(1280, look.height);
        desktop.settings.setTheme(look.theme);
        desktop.settings.setScale(look.scale);
        desktop.settings.setLanguage(QLatin1String(look.language));
        desktop.context.applyAppearance();
        for (const tests::VisitedPlace& place : places) {
            if (!desktop::findScreen(place.place.screen) || !wanted.has(place.name))
                continue;
            tests::visit(desktop, place, person);
            take(desktop,
                 folder.filePath(
                     QStringLiteral("%1_%2.png").arg(QLatin1String(place.name), QLatin1String(look.name))));
        }
        const auto picture = [&](const char* name) {
            take(desktop,
                 folder.filePath(
                     QStringLiteral("%1_%2.png").arg(QLatin1String(name), QLatin1String(look.name))));
        };
        const auto dialog = [&](const char* name, QWidget& shown) {
            QTest::qWait(300);
            shown.grab().save(folder.filePath(
                QStringLiteral("%1_%2.png").arg(QLatin1String(name), QLatin1String(look.name))));
        };
        if (studies.data != 0 && desktop::findScreen(QStringLiteral("study_trials"))) {
            tests::StudyPictures pictures{desktop, studies, more, person, picture, dialog};
            if (wanted.has("run_trials"))
                pictures.trials();
            if (wanted.has("run_apex"))
                pictures.apexTrials();
            if (wanted.has("study_dialog"))
                pictures.dialogs();
            if (wanted.has("study_preview_done"))
                pictures.preview();
        }
        if (wanted.has("training"))
            takeTraining(desktop, folder, look, person);
        if (wanted.has("training_urethra"))
            takeInsertion(desktop, folder, look, person);
        takeGrasping(desktop, folder, look, person, wanted);
        takePalpation(desktop, folder, look, person, wanted);
    }
    return 0;
}
