// SPDX-License-Identifier: GPL-3.0-or-later
// A bare Qt3D window, the peer of bench_scene: prints the monotonic time at which its first frame can be
// seen, and the processor time it took.
#include "bench/alternating.h"

#include <QGuiApplication>
#include <QScreen>
#include <QTimer>
#include <Qt3DCore/QEntity>
#include <Qt3DExtras/QForwardRenderer>
#include <Qt3DExtras/Qt3DWindow>
#include <Qt3DRender/QCamera>
#include <cstdio>

int main(int argc, char** argv) {
    QGuiApplication app(argc, argv);
    Qt3DExtras::Qt3DWindow window;
    window.resize(1024, 768);
    window.setPosition(0, 0);
    window.defaultFrameGraph()->setClearColor(QColor(0, 200, 0));
    window.setRootEntity(new Qt3DCore::QEntity);
    window.show();
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
        const QImage seen = window.screen()->grabWindow(window.winId(), 512, 384, 1, 1).toImage();
        if (seen.isNull() || seen.pixelColor(0, 0).green() < 150 || seen.pixelColor(0, 0).red() > 50)
            return;
        std::printf("%.6f %.6f\n", chiron::bench::seconds(CLOCK_MONOTONIC),
                    chiron::bench::seconds(CLOCK_PROCESS_CPUTIME_ID));
        std::fflush(stdout);
        std::_Exit(0); // taking Qt3D down is not measured
    });
    timer.start(1);
    return app.exec();
}
