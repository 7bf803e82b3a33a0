// SPDX-License-Identifier: GPL-3.0-or-later
// Peak force and path length of 5,000 ten-minute sessions from the per-second summaries of the product's
// database, beside the same question to rows of samples. Twenty sessions are really recorded (samples kept);
// their summaries are copied into the others'. Usage: bench_queries [FOLDER with 2 GB of room]
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "bench/sample_rows.h"
#include "bench/summary_site.h"

#include <QCoreApplication>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace chiron;
using namespace chiron::bench;

namespace {
constexpr int kRecorded = 20;
constexpr int kSessions = 5'000;
constexpr int kRepeats = 5;
constexpr double kGoal = 1000.0;

template <class Value> Value orExit(core::Result<Value> value) {
    if (!value) {
        std::fprintf(stderr, "%s\n", value.error().message.c_str());
        std::exit(1);
    }
    return std::move(*value);
}

/// How far the two answers are apart, at most, over the recorded sessions: both come from the stored samples,
/// added up in another order.
struct Agreement {
    double force_N = 0.0;
    double path_relative = 0.0;
    void add(const Totals& rows, const Totals& summaries) {
        force_N = std::max(force_N, std::abs(rows.peakForce_N - summaries.peakForce_N));
        path_relative = std::max(path_relative, std::abs(rows.path_m / summaries.path_m - 1.0));
    }
};
} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv); // Qt loads the SQLite driver as a plugin
    const std::filesystem::path folder =
        std::filesystem::path(argc > 1 ? argv[1] : ".") / "chiron-bench-queries";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    printHeading("Peak force and path length of 5,000 ten-minute sessions");

    SummarySite site(folder / "site.db");
    for (int n = 0; n < kRecorded; ++n)
        orExit(site.record(100 + static_cast<std::uint64_t>(n)));
    orExit(site.replicate(kSessions));

    std::vector<double> rowsTime, oneTime, allTime;
    Agreement agreement;
    for (int n = 0; n < kRecorded; ++n) { // rows of one session at a time: twenty of them would be 3 GB
        SampleRows rows(folder / "rows.db", orExit(site.samples(n)));
        for (int r = 0; r < 2; ++r) {
            Totals fromRows, fromSummaries;
            rowsTime.push_back(cpuSeconds([&] { fromRows = rows.ask(); }));
            oneTime.push_back(cpuSeconds([&] { fromSummaries = orExit(site.ask(n)); }));
            agreement.add(fromRows, fromSummaries);
        }
        if (n % (kRecorded / kRepeats) == 0)
            allTime.push_back(cpuSeconds([&] {
                                  if (orExit(site.askAll()).size() != kSessions)
                                      std::exit(1);
                              }) /
                              kSessions);
    }

    BenchRow all{
        .work = "all 5,000 sessions in one question, each", .peer = "SQLite row a sample", .unit = "us"};
    all.peerMedian = 1e6 * median(rowsTime);
    all.oursMedian = 1e6 * median(allTime);
    all.agreement = text("force within %.1e N, path within %.1e", agreement.force_N, agreement.path_relative);
    all.goal = "ratio ≥ 1000";
    all.reached = verdict(*all.ratio() >= kGoal);
    BenchRow one{.work = "one session by its id", .peer = "SQLite row a sample", .unit = "us"};
    one.peerMedian = all.peerMedian;
    one.oursMedian = 1e6 * median(oneTime);
    one.agreement = all.agreement;
    printTable({all, one});
    std::printf("CPU time. %d recorded sessions, %.1f MB of samples kept; 5,000 sessions have %lld summary "
                "rows; database %.0f MB.\n",
                kRecorded, 1e-6 * static_cast<double>(site.sampleBytes()),
                static_cast<long long>(site.summaryRows()),
                1e-6 * static_cast<double>(std::filesystem::file_size(folder / "site.db")));
    std::filesystem::remove_all(folder);
    return 0;
}
