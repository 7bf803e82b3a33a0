// SPDX-License-Identifier: GPL-3.0-or-later
// From exec to the first paint: the program at its login, beside a program with an empty QMainWindow, in
// turn. Needs a display; starts itself under xvfb-run where there is none. Usage: bench_start FOLDER
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "bench/started_process.h"
#include "catalogue/catalogue.h"
#include "database/accounts/account_service.h"

#include <QCoreApplication>
#include <cstdio>
#include <filesystem>
#include <unistd.h>

using namespace chiron;
using namespace chiron::bench;

namespace {

constexpr int kRepeats = 21;
constexpr double kGoal = 1.3;

void giveUp(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(1);
}

/// A site with somebody who could log in.
std::string makeSite(const std::filesystem::path& folder) {
    const std::string file = (folder / "site.db").string();
    database::DatabaseOptions options;
    options.passwordCost = database::PasswordCost::minimalForTests();
    auto database = database::Database::create(file, options);
    if (!database)
        giveUp(database.error().message);
    if (auto made =
            database::AccountService(**database).createFirstAdministrator("ada", "eleven-fine-horses", "Ada");
        !made)
        giveUp(made.error().message);
    return file;
}

/// What one program's starts took, step by step.
struct Starts {
    std::map<std::string, std::vector<double>> wall_ms;
    std::map<std::string, std::vector<double>> cpu_ms;

    void add(const std::map<std::string, StartStep>& steps) {
        if (steps.empty())
            giveUp("a program did not paint itself within ten seconds");
        for (const auto& [what, step] : steps) {
            wall_ms[what].push_back(step.wall_ms);
            cpu_ms[what].push_back(step.cpu_ms);
        }
    }
    void print(const char* program) {
        for (const auto& [what, times] : wall_ms)
            std::printf("  %-13s exec to %-14s %7.1f ms, processor %6.1f ms\n", program, what.c_str(),
                        median(times), median(cpu_ms[what]));
    }
};

BenchRow rowOf(const char* work, std::map<std::string, std::vector<double>>& ours,
               std::map<std::string, std::vector<double>>& peer) {
    BenchRow row{.work = work, .peer = "empty QMainWindow", .unit = "ms"};
    row.peerMedian = median(peer["first_paint"]);
    row.oursMedian = median(ours["first_paint"]);
    row.p99 = percentile(ours["first_paint"], 0.99);
    row.goal = "ours <= 1.3 x peer";
    row.reached = verdict(*row.oursMedian <= kGoal * *row.peerMedian);
    return row;
}

} // namespace

int main(int argc, char** argv) {
    if (!std::getenv("DISPLAY")) {
        execlp("xvfb-run", "xvfb-run", "-a", "-s", "-screen 0 1280x720x24", argv[0], argc > 1 ? argv[1] : ".",
               nullptr);
        giveUp("there is no display, and xvfb-run is not installed: not measured");
    }
    const QCoreApplication application(argc, argv); // Qt loads the SQLite driver as a plugin
    const auto folder = std::filesystem::absolute(argc > 1 ? argv[1] : ".") / "chiron-bench-start";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::string file = makeSite(folder);
    const std::vector<std::string> ours{CHIRON_PROGRAM, "--database", file, "--settings",
                                        (folder / "desktop.ini").string()};
    const std::vector<std::string> peer{CHIRON_EMPTY_WINDOW};
    printHeading("From exec to first paint");
    startUntil(ours, "first_paint"); // files into the page cache
    startUntil(peer, "first_paint");
    Starts starts;
    Starts empty;
    for (int n = 0; n < kRepeats; ++n) {
        empty.add(startUntil(peer, "first_paint"));
        starts.add(startUntil(ours, "first_paint"));
    }
    printTable({rowOf("login, by the wall clock", starts.wall_ms, empty.wall_ms),
                rowOf("login, processor time of the process", starts.cpu_ms, empty.cpu_ms)});
    std::printf("ours / peer: %.2f by the wall clock, %.2f in processor time\n",
                median(starts.wall_ms["first_paint"]) / median(empty.wall_ms["first_paint"]),
                median(starts.cpu_ms["first_paint"]) / median(empty.cpu_ms["first_paint"]));
    starts.print("chiron");
    empty.print("empty window");
    std::filesystem::remove_all(folder);
    return 0;
}
