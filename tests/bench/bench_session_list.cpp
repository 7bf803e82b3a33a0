// SPDX-License-Identifier: GPL-3.0-or-later
// The list of 5,000 sessions, from asking for it to its first paint with rows, beside making, showing and
// first painting an empty QMainWindow in the same process, in turn; then how long a filter takes. Needs a
// display; starts itself under xvfb-run where there is none.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "desktop/sessions/session_table_model.h"
#include "desktop/sessions/sessions_screen.h"
#include "gui/lists/many_sessions.h"
#include "support/desktop_fixture.h"

#include <QTableView>
#include <cstdio>
#include <unistd.h>

using namespace chiron;
using namespace chiron::bench;

namespace {

constexpr int kSessions = 5'000;
constexpr int kRepeats = 15;
constexpr double kGoal = 1.3;

double now_ms() {
    return seconds(CLOCK_MONOTONIC) * 1e3;
}

/// All threads of the process: what it costs, whoever else runs.
double cpu_ms() {
    return seconds(CLOCK_PROCESS_CPUTIME_ID) * 1e3;
}

/// How long something took, and what it cost.
struct Took {
    double wall_ms = 0.0;
    double cpu_ms = 0.0;
};

class EmptyWindow final : public QMainWindow {
public:
    bool painted = false;

protected:
    bool event(QEvent* event) override {
        const bool handled = QMainWindow::event(event);
        painted = painted || event->type() == QEvent::UpdateRequest;
        return handled;
    }
};

Took emptyWindow() {
    const double begin = now_ms();
    const double cpuBegin = cpu_ms();
    EmptyWindow window;
    window.resize(1280, 720);
    window.show();
    while (!window.painted)
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return {now_ms() - begin, cpu_ms() - cpuBegin};
}

/// Sees when a table has painted rows.
class PaintedRows final : public QObject {
public:
    explicit PaintedRows(QTableView& table) : m_table(table) { table.viewport()->installEventFilter(this); }
    bool painted = false;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint && m_table.model()->rowCount() > 0)
            QTimer::singleShot(0, this, [this] { painted = true; }); // once this paint is over
        return false;
    }

private:
    QTableView& m_table;
};

struct ListTimes {
    Took firstPaint;
    double complete_ms = 0.0;
};

ListTimes showList(tests::DesktopFixture& desktop) {
    const double begin = now_ms();
    const double cpuBegin = cpu_ms();
    desktop.go(QStringLiteral("sessions"));
    auto* screen = desktop.screen<desktop::SessionsScreen>();
    PaintedRows rows(*screen->findChild<QTableView*>());
    ListTimes times;
    while (!rows.painted)
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    times.firstPaint = {now_ms() - begin, cpu_ms() - cpuBegin};
    while (!screen->isComplete())
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    times.complete_ms = now_ms() - begin;
    desktop.go(QStringLiteral("settings"));
    QTest::qWait(50);
    return times;
}

double filter_ms(tests::DesktopFixture& desktop) {
    desktop.go(QStringLiteral("sessions"));
    auto* screen = desktop.screen<desktop::SessionsScreen>();
    while (!screen->isComplete())
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    desktop::SessionListFilter filter;
    filter.text = QStringLiteral("tina apex 4");
    const double begin = now_ms();
    screen->model().setFilter(filter);
    return now_ms() - begin;
}

BenchRow rowOf(const char* work, const std::vector<double>& ours, const std::vector<double>& peer) {
    BenchRow row{.work = work, .peer = "empty QMainWindow", .unit = "ms"};
    row.peerMedian = median(peer);
    row.oursMedian = median(ours);
    row.p99 = percentile(ours, 0.99);
    row.goal = "ours <= 1.3 x peer";
    row.reached = verdict(*row.oursMedian <= kGoal * *row.peerMedian);
    return row;
}

} // namespace

int main(int argc, char** argv) {
    if (!std::getenv("DISPLAY")) {
        execlp("xvfb-run", "xvfb-run", "-a", "-s", "-screen 0 1280x720x24", argv[0], nullptr);
        std::fprintf(stderr, "there is no display, and xvfb-run is not installed: not measured\n");
        return 1;
    }
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    printHeading("The list of 5,000 sessions");
    tests::DesktopFixture desktop;
    tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, kSessions,
                             true);
    desktop.logIn("tom");
    QTest::qWait(500);
    showList(desktop); // the icons and fonts that the rest of the program has loaded by then
    emptyWindow();
    std::vector<double> peer, peerCpu, ours, oursCpu, whole, filter;
    for (int n = 0; n < kRepeats; ++n) {
        const Took empty = emptyWindow();
        peer.push_back(empty.wall_ms);
        peerCpu.push_back(empty.cpu_ms);
        const ListTimes times = showList(desktop);
        ours.push_back(times.firstPaint.wall_ms);
        oursCpu.push_back(times.firstPaint.cpu_ms);
        whole.push_back(times.complete_ms);
        filter.push_back(filter_ms(desktop));
    }
    BenchRow all{.work = "all 5,000 in the list", .unit = "ms"};
    all.oursMedian = median(whole);
    BenchRow narrow{.work = "a filter of three words", .unit = "ms"};
    narrow.oursMedian = median(filter);
    printTable({rowOf("first paint with rows, by the wall clock", ours, peer),
                rowOf("the same, processor time", oursCpu, peerCpu), all, narrow});
    std::printf("ours / peer: %.2f by the wall clock, %.2f in processor time\n", median(ours) / median(peer),
                median(oursCpu) / median(peerCpu));
    return 0;
}
