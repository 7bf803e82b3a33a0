// SPDX-License-Identifier: GPL-3.0-or-later
// The peer of bench_start: a program with nothing but an empty QMainWindow. Says when it has painted itself
// for the first time.
#include "desktop/frame/start_trace.h"

#include <QApplication>
#include <QMainWindow>

namespace {

class EmptyWindow final : public QMainWindow {
protected:
    bool event(QEvent* event) override {
        const bool handled = QMainWindow::event(event);
        if (event->type() == QEvent::UpdateRequest)
            chiron::desktop::traceStart("first_paint");
        return handled;
    }
};

} // namespace

int main(int argc, char** argv) {
    chiron::desktop::traceStart("main");
    QApplication application(argc, argv);
    chiron::desktop::traceStart("application");
    EmptyWindow window;
    window.resize(1280, 720);
    window.show();
    return QApplication::exec();
}
