// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/program.h"
#include "desktop/frame/start_trace.h"

#include <QStyleFactory>

int main(int argc, char** argv) {
    chiron::desktop::traceStart("main");
    qputenv("QT3D_RENDERER", "opengl"); // faster than the other back end with a software rasteriser
    QCoreApplication::setApplicationName(QStringLiteral("chiron"));
    QCoreApplication::setApplicationVersion(QStringLiteral(CHIRON_VERSION));
    if (chiron::desktop::asksForText(argc, argv)) {
        const QCoreApplication application(argc, argv);
        return chiron::desktop::tellText(QCoreApplication::arguments());
    }
    QApplication application(argc, argv);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    return chiron::desktop::runProgram(application);
}
