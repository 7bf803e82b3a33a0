// SPDX-License-Identifier: GPL-3.0-or-later
// From exec to the first paint: the program at its login, beside a program with an empty QMainWindow, in turn. Needs a display;
// starts itself under xvfb-run where there is none. Usage: bench_start FOLDER
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
    if (auto made = database::AccountService(**database).createFirstAdministrator("ada", "eleven-fine-horses", "Ada"); !made)
        giveUp(made.error().message);
    return file;
}

} // namespace

int main(int argc, char** argv) {
    if (!std::getenv("DISPLAY")) {
        execlp("xvfb-run", "xvfb-run", "-a", "-s", "-screen 0 1280x720x24", argv[0], argc > 1 ? argv[1] : ".", nullptr);
        giveUp("there is no display, and xvfb-run is not installed: not measured");
    }
    const QCoreApplication application(argc, argv); // Qt loads the SQLite driver as a plugin
    const auto folder = std::filesystem::absolute(argc > 1 ? argv[1] : ".") / "chiron-bench-start";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::string file = makeSite(folder);
    const std::vector<std::string> ours{CHIRON_PROGRAM, "--database", file, "--settings", (folder / "desktop.ini").string()};
    const std::vector<std::string> peer{CHIRON_EMPTY_WINDOW};
    printHeading("From exec to first paint");
    startUntil(ours, "first_paint"); // files into the page cache
    startUntil(peer, "first_paint");
    std::vector<double> oursTimes, peerTimes;
    std::map<std::string, std::vector<double>> steps;
    for (int n = 0; n < kRepeats; ++n) {
        const auto empty = startUntil(peer, "first_paint");
        const auto login = startUntil(ours, "first_paint");
        if (empty.empty() || login.empty())
            giveUp("a program did not paint itself within ten seconds");
        peerTimes.push_back(empty.at("first_paint"));
        oursTimes.push_back(login.at("first_paint"));
        for (const auto& [what, time_ms] : login)
            steps[what].push_back(time_ms);
    }
    BenchRow row{.work = "login", .peer = "empty QMainWindow", .unit = "ms"};
    row.peerMedian = median(peerTimes);
    row.oursMedian = median(oursTimes);
    row.p99 = percentile(oursTimes, 0.99);
    row.goal = "ours <= 1.3 x peer";
    row.reached = verdict(*row.oursMedian <= kGoal * *row.peerMedian);
    printTable({row});
    std::printf("ours / peer: %.2f\n", *row.oursMedian / *row.peerMedian);
    for (const auto& [what, times] : steps)
        std::printf("  exec to %-18s %7.1f ms\n", what.c_str(), median(times));
    std::filesystem::remove_all(folder);
    return 0;
}
