// SPDX-License-Identifier: GPL-3.0-or-later
// A session of about ten minutes: reading and scoring its recording, and the debrief from asking for it to
// the first paint of its verdict and to its last detail. No peer does this work: tests/bench/against runs
// this program in turn with another version's. Needs a display; starts itself under xvfb-run where there is
// none.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "desktop/frame/background.h"
#include "session/integrity_check.h"
#include "support/desktop_fixture.h"

#include <QLabel>
#include <QTableView>
#include <cstdio>
#include <unistd.h>

using namespace chiron;
using namespace chiron::bench;

namespace {

constexpr int kTrials = 60;
constexpr double kTrialLimit_s = 60.0;
constexpr int kRepeats = 9;

double now_ms() {
    return seconds(CLOCK_MONOTONIC) * 1e3;
}

/// Notes the first paint of a widget.
class FirstPaint final : public QObject {
public:
    explicit FirstPaint(QWidget& widget) { widget.installEventFilter(this); }
    bool painted = false;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint)
            QTimer::singleShot(0, this, [this] { painted = true; }); // once this paint is over
        return false;
    }
};

struct DebriefTimes {
    double verdict_ms = 0.0;
    double complete_ms = 0.0;
};

DebriefTimes showDebrief(tests::DesktopFixture& desktop, database::SessionId session) {
    const double begin = now_ms();
    desktop.go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(session)}});
    QLabel* verdict = nullptr;
    while (!(verdict = desktop.find<QLabel>(QStringLiteral("debrief.verdict"))))
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    FirstPaint paint(*verdict);
    while (!paint.painted)
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    DebriefTimes times;
    times.verdict_ms = now_ms() - begin;
    while (!desktop.context.background().idle())
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    times.complete_ms = now_ms() - begin;
    desktop.go(QStringLiteral("settings"));
    QTest::qWait(50);
    return times;
}

double score_ms(database::Database& database, database::SessionId session) {
    auto connection = database.openReader();
    if (!connection)
        qFatal("%s", connection.error().message.c_str());
    const double begin = now_ms();
    if (!session::checkScores(**connection, session).empty())
        qFatal("the scores differ from the stored ones");
    return now_ms() - begin;
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
    printHeading("A session of ten minutes: score and debrief");
    tests::DesktopFixture desktop;
    const database::SessionId session = desktop.addSession("tina", 1, "expert", 1, kTrials, kTrialLimit_s);
    desktop.logIn("tina");
    QTest::qWait(500);
    showDebrief(desktop, session); // the icons and fonts that the rest of the program has loaded by then
    std::vector<double> score, verdict, complete;
    for (int n = 0; n < kRepeats; ++n) {
        score.push_back(score_ms(desktop.database(), session));
        const DebriefTimes times = showDebrief(desktop, session);
        verdict.push_back(times.verdict_ms);
        complete.push_back(times.complete_ms);
    }
    std::vector<BenchRow> rows;
    for (const auto& [work, times] : {std::pair{"read and score the recording", &score},
                                      std::pair{"debrief, asked to first paint of the verdict", &verdict},
                                      std::pair{"debrief, asked to its last detail", &complete}}) {
        BenchRow row{.work = work, .unit = "ms"};
        row.oursMedian = median(*times);
        row.p99 = percentile(*times, 0.99);
        rows.push_back(row);
    }
    printTable(rows);
    return 0;
}
