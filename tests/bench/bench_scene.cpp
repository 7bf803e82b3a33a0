// SPDX-License-Identifier: GPL-3.0-or-later
// First frame of the 3D scene against a bare Qt3D window (one process each, alternating), its frames a second
// with a moving tip at 1024x768, and those of the endoscope's view, without and with depth of field, beside
// P1's 26 and 13. Needs a display: xvfb-run -a -s "-screen 0 1280x1024x24" bench_scene
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "bench/alternating.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/laparoscopy_samples.h"
#include "gui/scene3d/palpation_samples.h"
#include "gui/scene3d/scene_samples.h"
#include "gui/scene3d/urethra_samples.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QPainter>
#include <QProcess>
#include <QScreen>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <utility>

using namespace chiron;

namespace {

constexpr int kRepeats = 9;
constexpr int kRateRepeats = 5;

/// What is shown, and how it moves.
struct Subject {
    scene3d::SceneSetup setup;
    std::function<scene3d::SceneState(double t_s)> at;
};

/// A tip that presses and wanders.
Subject sphereApex() {
    return {scene3d::samples::setup(), [](double t_s) {
                scene3d::SceneState state = scene3d::samples::pressed(2.5 + 2.0 * std::sin(3.0 * t_s));
                state.tool[0].p_WT.x() += 0.006 * std::sin(2.0 * t_s);
                return state;
            }};
}

/// A tip that goes in and out in the bend, off the middle, turning its head. Overview and marks are shown.
Subject urethra(bool depthOfField) {
    Subject subject;
    subject.setup = scene3d::samples::urethraSetup();
    subject.setup.depthOfField = depthOfField;
    subject.at = [setup = subject.setup](double t_s) {
        scene3d::SceneState state =
            scene3d::samples::urethraState(setup, {.s_m = 0.060 + 0.040 * std::sin(1.5 * t_s),
                                                   .ex_m = 0.001 * std::sin(2.0 * t_s),
                                                   .en_m = 0.001 * std::cos(2.0 * t_s),
                                                   .pitch_rad = 0.15 * std::sin(1.1 * t_s),
                                                   .yaw_rad = 0.10 * std::sin(1.7 * t_s)});
        state.tool[0].force_N = {0.4, -1.0 + 0.5 * std::sin(3.0 * t_s), 0.6};
        return state;
    };
    return subject;
}

/// Two graspers that pull at a tube: its triangles are made anew for every picture.
Subject tube() {
    return {scene3d::samples::tubeSetup(simulation::TubeTask::twoHanded),
            [](double t_s) { return scene3d::samples::twoHanded(0.055 + 0.018 * std::sin(2.0 * t_s)); }};
}

/// An ovary that is carried and squeezed.
Subject ovary() {
    return {scene3d::samples::handlingSetup(), [](double t_s) {
                scene3d::SceneState state = scene3d::samples::handlingState(true);
                state.exercise.own<core::LaparoscopyCues>().body[1].squeeze_m =
                    0.002 + 0.002 * std::sin(3.0 * t_s);
                state.exercise.own<core::LaparoscopyCues>().body[1].p_W[0] += 0.01 * std::sin(2.0 * t_s);
                return state;
            }};
}

/// Two fingers that press and wander on a curved tissue; the map on it changes with each picture.
Subject palpation() {
    Subject subject;
    subject.setup = scene3d::samples::palpationSetup(scene3d::samples::Tissue::breast, 1, 2);
    const auto map = std::make_shared<simulation::SurfaceMap>(scene3d::samples::searched(subject.setup, 0.3));
    subject.at = [setup = subject.setup, map](double t_s) {
        scene3d::SceneState state;
        for (std::size_t i = 0; i < 2; ++i) {
            const core::Vec2 at(0.018 * double(i) + 0.020 * std::sin(2.0 * t_s), 0.020 * std::cos(1.3 * t_s));
            scene3d::samples::pressFinger(state, setup, i, at, 0.004, {0.3, 0.2});
            map->press(at, 1.0 + std::sin(t_s));
        }
        state.overlay.own<scene3d::PalpationOverlay>().map = map.get();
        state.overlay.own<scene3d::PalpationOverlay>().mapStep = map->step();
        return state;
    };
    return subject;
}

class Window final : public QWidget {
public:
    std::function<void()> painted;

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter(this).fillRect(rect(), Qt::white);
        if (painted)
            QTimer::singleShot(0, this, std::exchange(painted, nullptr));
    }
};

/// Shows an empty window, then the scene in it once the window was painted.
struct Shown {
    Window window;
    scene3d::LoadedScene scene;
    double begun_s = 0.0;
    double made_s = 0.0;

    Shown(const Subject& subject, std::function<void()> then) {
        window.resize(1024, 768);
        window.move(0, 0);
        auto* layout = new QVBoxLayout(&window);
        layout->setContentsMargins(0, 0, 0, 0);
        window.painted = [this, subject, layout, then] {
            begun_s = bench::seconds(CLOCK_MONOTONIC);
            scene = scene3d::makeSceneView(subject.setup, &window);
            made_s = bench::seconds(CLOCK_MONOTONIC);
            layout->addWidget(scene.view->widget());
            scene.view->show(subject.at(0.0));
            then();
        };
        window.show();
    }
};

/// Prints three times: the scene's load began, its first frame was reported, it could be seen;
/// the processor time
/// until then; when it was made; the longest time in which the window did not answer.
int firstFrame(QApplication& app) {
    double told_s = 0.0;
    double beat_s = 0.0;
    double stall_s = 0.0; // longest time in which the event loop did not come round
    QTimer timer;
    Shown* shown = nullptr;
    Shown holder(sphereApex(), [&] {
        beat_s = shown->begun_s;
        if (!shown->scene.whyFlat.isEmpty()) {
            std::printf("flat: %s\n", qPrintable(shown->scene.whyFlat));
            std::fflush(stdout);
            std::_Exit(1);
        }
        shown->scene.view->onFirstFrame([&] { told_s = bench::seconds(CLOCK_MONOTONIC); });
        timer.start(1);
    });
    shown = &holder;
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
        const double now_s = bench::seconds(CLOCK_MONOTONIC);
        stall_s = std::max(stall_s, now_s - std::exchange(beat_s, now_s));
        if (told_s == 0.0)
            return;
        const QImage seen =
            holder.window.screen()->grabWindow(holder.window.winId(), 400, 600, 1, 1).toImage();
        if (seen.isNull() || seen.pixelColor(0, 0).red() < 90 || seen.pixelColor(0, 0).blue() > 150)
            return; // not yet tissue
        std::printf("%.6f %.6f %.6f %.6f %.6f %.6f\n", holder.begun_s, told_s, now_s,
                    bench::seconds(CLOCK_PROCESS_CPUTIME_ID), holder.made_s, stall_s);
        std::fflush(stdout);
        std::_Exit(0);
    });
    return app.exec();
}

/// Prints frames a second and processor milliseconds a frame (all threads; this one).
int frames(QApplication& app, const Subject& subject) {
    QElapsedTimer clock;
    QTimer timer;
    Shown* shown = nullptr;
    std::uint64_t before = 0;
    double cpu_s = 0.0;
    double own_s = 0.0;
    Shown holder(subject, [&] {
        shown->scene.view->onFirstFrame([&] {
            clock.start();
            cpu_s = bench::seconds(CLOCK_PROCESS_CPUTIME_ID);
            own_s = bench::seconds(CLOCK_THREAD_CPUTIME_ID);
            before = shown->scene.view->framesDrawn();
            timer.start(1);
        });
    });
    shown = &holder;
    std::uint64_t last = 0;
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
        if (clock.elapsed() > 5000) {
            const double drawn = double(holder.scene.view->framesDrawn() - before);
            std::printf("%.1f %.2f %.2f\n", drawn * 1000.0 / double(clock.elapsed()),
                        (bench::seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_s) * 1e3 / drawn,
                        (bench::seconds(CLOCK_THREAD_CPUTIME_ID) - own_s) * 1e3 / drawn);
            std::fflush(stdout);
            std::_Exit(0);
        }
        if (holder.scene.view->framesDrawn() == last)
            return; // the frame before has not been drawn
        last = holder.scene.view->framesDrawn();
        holder.scene.view->show(subject.at(0.001 * double(clock.elapsed())));
    });
    return app.exec();
}

std::vector<double> child(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(program, arguments);
    process.waitForFinished(60000);
    std::vector<double> numbers;
    for (const QByteArray& word : process.readAllStandardOutput().simplified().split(' ')) {
        bool number = false;
        const double value = word.toDouble(&number);
        if (number)
            numbers.push_back(value);
    }
    return numbers;
}

struct Rate {
    std::vector<double> perSecond, cpu_ms, own_ms;
};

void addRate(const QString& self, const QString& what, Rate& rate) {
    const auto c = child(self, {QStringLiteral("--frames"), what});
    if (c.size() != 3)
        return;
    rate.perSecond.push_back(c[0]);
    rate.cpu_ms.push_back(c[1]);
    rate.own_ms.push_back(c[2]);
}

void printRate(const char* what, double goal, const Rate& rate) {
    if (rate.perSecond.empty())
        return void(std::printf("%s: not measured\n", what));
    std::printf("%s: median %.1f of %zu runs (goal %.0f)\n", what, bench::median(rate.perSecond),
                rate.perSecond.size(), goal);
    std::printf("  processor time a frame        %7.1f ms, of which the window's own thread %.1f ms\n",
                bench::median(rate.cpu_ms), bench::median(rate.own_ms));
}

/// Without and with depth of field in turn, so that both meet the same machine.
void measureUrethra(const QString& self) {
    Rate off, on;
    for (int i = 0; i < kRateRepeats; ++i) {
        addRate(self, QStringLiteral("urethra"), off);
        addRate(self, QStringLiteral("focus"), on);
    }
    printRate("endoscope's view (P1: 26)", 40.0, off);
    printRate("endoscope's view with depth of field (P1: 13)", 30.0, on);
    if (!off.perSecond.empty() && !on.perSecond.empty())
        std::printf("  ratio of frame rates %.2f, of processor times %.2f (P1: 2.0, goal 1.25)\n",
                    bench::median(off.perSecond) / bench::median(on.perSecond),
                    bench::median(on.cpu_ms) / bench::median(off.cpu_ms));
}

int measure(const QString& self) {
    qputenv("QT3D_RENDERER", "opengl"); // the same back end for both
    const QString bare = QFileInfo(self).dir().filePath(QStringLiteral("bench_scene_bare"));
    std::vector<double> peer_s, exec_s, load_s, peerCpu_s, cpu_s, make_s, stall_s;
    for (int i = 0; i < kRepeats; ++i) {
        double start_s = bench::seconds(CLOCK_MONOTONIC);
        const auto a = child(bare, {});
        if (a.size() == 2) {
            peer_s.push_back(a[0] - start_s);
            peerCpu_s.push_back(a[1]);
        }
        start_s = bench::seconds(CLOCK_MONOTONIC);
        const auto b = child(self, {QStringLiteral("--first")});
        if (b.size() == 6) {
            cpu_s.push_back(b[3]);
            make_s.push_back(b[4] - b[0]);
            stall_s.push_back(b[5]);
            exec_s.push_back(b[2] - start_s);
            load_s.push_back(b[2] - b[0]);
        }
    }
    if (peer_s.empty() || exec_s.empty()) {
        std::printf(
            "not measured: no display, no OpenGL, or chiron_scene3d.so is not where CHIRON_PLUGINS says\n");
        return 1;
    }
    std::printf("first frame, exec to seen, medians of %zu\n", exec_s.size());
    std::printf("  bare Qt3D window              %7.1f ms\n", bench::median(peer_s) * 1e3);
    std::printf("  scene after its window        %7.1f ms  ratio %.2f (goal 1.2)\n",
                bench::median(exec_s) * 1e3, bench::median(exec_s) / bench::median(peer_s));
    std::printf("  processor time until then     %7.1f ms and %.1f ms  ratio %.2f\n",
                bench::median(peerCpu_s) * 1e3, bench::median(cpu_s) * 1e3,
                bench::median(cpu_s) / bench::median(peerCpu_s));
    std::printf("  of which making the scene     %7.1f ms\n", bench::median(load_s) * 1e3);
    std::printf("  makeSceneView() itself        %7.1f ms, longest time without an answer %.1f ms\n",
                bench::median(make_s) * 1e3, bench::median(stall_s) * 1e3);
    Rate apex;
    for (int i = 0; i < kRateRepeats; ++i)
        addRate(self, QStringLiteral("apex"), apex);
    printRate("frames a second, 1024x768, moving tip", 40.0, apex);
    Rate pulled, carried, felt;
    for (int i = 0; i < kRateRepeats; ++i) {
        addRate(self, QStringLiteral("tube"), pulled);
        addRate(self, QStringLiteral("ovary"), carried);
        addRate(self, QStringLiteral("palpation"), felt);
    }
    printRate("abdomen, a tube between two graspers", 40.0, pulled);
    printRate("abdomen, an ovary that is carried", 40.0, carried);
    printRate("breast, two fingers, coverage map", 40.0, felt);
    measureUrethra(self);
    double load = 0.0;
    getloadavg(&load, 1);
    std::printf("the machine's load was %.1f\n", load);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    const QString mode = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QString();
    if (mode.isEmpty()) {
        QCoreApplication app(argc, argv);
        return measure(QCoreApplication::applicationFilePath());
    }
    QApplication app(argc, argv);
    if (mode != QStringLiteral("--frames"))
        return firstFrame(app);
    const QString what = argc > 2 ? QString::fromLocal8Bit(argv[2]) : QString();
    if (what == QStringLiteral("palpation"))
        return frames(app, palpation());
    if (what == QStringLiteral("tube") || what == QStringLiteral("ovary"))
        return frames(app, what == QStringLiteral("tube") ? tube() : ovary());
    const bool focus = what == QStringLiteral("focus");
    return frames(app, focus || what == QStringLiteral("urethra") ? urethra(focus) : sphereApex());
}
