// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a session's states: training_pictures FOLDER [LOOK ...]. Needs a display; nothing is asserted.
#include "gui/training/training_bench.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "support/patience.h"

#include <QDir>
#include <QElapsedTimer>
#include <QScreen>
#include <cstdio>
#include <utility>

using namespace chiron;
using namespace chiron::tests;

namespace {

struct Look {
    const char* name;
    desktop::ThemeName theme;
    double scale;
    const char* language;
};

constexpr Look kLooks[] = {{"light", desktop::ThemeName::light, 1.0, "en"},
                           {"dark", desktop::ThemeName::dark, 1.0, "en"},
                           {"contrast", desktop::ThemeName::highContrast, 1.0, "en"},
                           {"large", desktop::ThemeName::light, 2.0, "en"},
                           {"large_de", desktop::ThemeName::light, 2.0, "de"}};

class Album {
public:
    Album(TrainingBench& bench, const QDir& folder, const char* look)
        : m_bench(bench), m_folder(folder), m_look(look) {}
    void take(const char* name, int wait_ms = 500) {
        QTest::qWait(wait_ms);
        const QString file =
            m_folder.filePath(QStringLiteral("%1_%2.png").arg(QLatin1String(name), QLatin1String(m_look)));
        QGuiApplication::primaryScreen()->grabWindow(0).save(file);
        std::printf("%s\n", qPrintable(file));
    }

private:
    TrainingBench& m_bench;
    QDir m_folder;
    const char* m_look;
};

void untilForce(TrainingBench& bench, core::ForceState force) {
    (void)QTest::qWaitFor([&] { return bench.state().force == force; }, kPatience_ms);
}

void takeMouse(TrainingBench& bench, Album& album) {
    bench.train();
    (void)QTest::qWaitFor([&] { return bench.runs(); }, kPatience_ms);
    for (int n = 0; n < 14; ++n) {
        bench.wheel(-240);
        bench.sweepTo({10 * (n % 5), 3 * n});
        QTest::qWait(120);
    }
    album.take("mouse_running");
    for (int n = 0; n < 20; ++n) {
        bench.wheel(-240);
        QTest::qWait(50);
    }
    album.take("mouse_over_limit", 1500);
    bench.key(Qt::Key_Space);
    album.take("mouse_paused");
    bench.key(Qt::Key_Escape);
    album.take("mouse_stopped");
}

void takeDemonstration(TrainingBench& bench, Album& album) {
    bench.train({{QStringLiteral("device"), QStringLiteral("demonstration")},
                 {QStringLiteral("operator"), QStringLiteral("expert")}});
    untilForce(bench, core::ForceState::ramping);
    album.take("demo_arming", 300);
    untilForce(bench, core::ForceState::on);
    const std::uint64_t frames = bench.screen()->scene()->framesDrawn();
    QElapsedTimer timer;
    timer.start();
    QTest::qWait(6000);
    std::printf("scene: %.1f frames a second\n",
                1e3 * double(bench.screen()->scene()->framesDrawn() - frames) / double(timer.elapsed()));
    album.take("demo_running");
    bench.key(Qt::Key_Escape);
    album.take("demo_stopped");
}

void takeUrethra(TrainingBench& bench, Album& album) {
    const auto train = [&bench](int level, const char* who) {
        bench.train({{QStringLiteral("exercise"), QStringLiteral("urethra_insertion")},
                     {QStringLiteral("level"), level},
                     {QStringLiteral("device"), QStringLiteral("demonstration")},
                     {QStringLiteral("operator"), QLatin1String(who)}});
    };
    const auto until = [&bench](simulation::ProcedureStage stage, double depth_m) {
        (void)QTest::qWaitFor(
            [&] {
                return bench.state().exercise.of<simulation::EndoscopeCues>().stage >= stage &&
                       bench.state().exercise.of<simulation::EndoscopeCues>().depth_m >= depth_m;
            },
            kPatience_ms);
    };
    train(3, "novice");
    until(simulation::ProcedureStage::insertion, 0.05);
    album.take("urethra_insertion", 100);
    bench.key(Qt::Key_F);
    album.take("urethra_depth_of_field", 300);
    until(simulation::ProcedureStage::inspection, 0.0);
    album.take("urethra_inspection", 1500);
    bench.key(Qt::Key_F5);
    album.take("urethra_again", 500);
}

void leave(TrainingBench& bench) {
    QTimer::singleShot(300, qApp, [] {
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* end = top->findChild<QPushButton*>(QStringLiteral("training.ask.end")))
                end->click();
    });
    bench.desktop.go(QStringLiteral("settings"));
    QTest::qWait(300);
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2) {
        std::fprintf(stderr, "usage: training_pictures FOLDER [LOOK ...]\n");
        return 2;
    }
    const QDir folder(arguments.at(1));
    folder.mkpath(QStringLiteral("."));
    const QStringList wanted = arguments.mid(2);
    TrainingBench bench(10, 60.0);
    for (const Look& look : kLooks) {
        if (!wanted.isEmpty() && !wanted.contains(QLatin1String(look.name)))
            continue;
        bench.desktop.settings.setTheme(look.theme);
        bench.desktop.settings.setScale(look.scale);
        bench.desktop.settings.setLanguage(QLatin1String(look.language));
        bench.desktop.context.applyAppearance();
        Album album(bench, folder, look.name);
        for (const auto& [exercise, name] :
             {std::pair{"sphere_apex", "setup"}, std::pair{"urethra_insertion", "setup_urethra"}}) {
            bench.desktop.go(QStringLiteral("exercise_setup"),
                             {{QStringLiteral("exercise"), QLatin1String(exercise)}});
            album.take(name, 800);
        }
        takeUrethra(bench, album);
        leave(bench);
        takeMouse(bench, album);
        leave(bench);
        takeDemonstration(bench, album);
        leave(bench);
        bench.train({{QStringLiteral("device"), QStringLiteral("trace")},
                     {QStringLiteral("trace"), QStringLiteral("/nowhere/trace.csv")}});
        album.take("error", 800);
    }
    return 0;
}
