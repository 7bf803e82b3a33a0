// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how each scripted palpator does, as Markdown, through the whole stack: palpation_operator_table
// LEVEL [SEEDS] [FIRST] [TRIALS] [OPERATOR]; TRIALS 0: as many as the level has. Not a test: it asserts
// nothing.
#include "support/palpator_session.h"

#include <cstdio>
#include <cstdlib>

using namespace chiron;

namespace {

double meanOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return values.empty() ? std::nan("") : sum / static_cast<double>(values.size());
}

void printRow(const simulation::PalpationParameters& p, const std::string& level, const std::string& name,
              std::uint64_t first, int seeds) {
    support::Detection d;
    std::vector<double> coverage, searching, over, maximum;
    double pressing = 0.0, band = 0.0;
    int completed = 0;
    for (int i = 0; i < seeds; ++i) {
        const auto outcome = support::runPalpation(p, name, first + static_cast<std::uint64_t>(i));
        support::countSession(d, p, outcome);
        for (const support::PalpationTrialHeard& trial : outcome.trials) {
            coverage.push_back(100.0 * trial.coverage);
            searching.push_back(trial.searching_s);
            over.push_back(trial.over_s);
            maximum.push_back(trial.maximum_N);
            pressing += trial.pressing_s;
            band += trial.band_s;
            completed += trial.completed ? 1 : 0;
        }
    }
    char order[32] = "–";
    if (d.pairs > 0)
        std::snprintf(order, sizeof order, "%d of %d", d.ordered, d.pairs);
    std::printf("| %s | %s | %d of %zu | %d | %d | %d | %.2f ± %.2f | %.2f | %.1f | %.1f | %s | %.0f | %.0f "
                "| %.2f | %.1f | %.1f |\n",
                level.c_str(), name.c_str(), completed, coverage.size(), d.hits, d.misses, d.falseAlarms,
                d.dPrime(), 1.96 * d.dPrimeError(), d.criterion(), 1e3 * d.meanDistance_m(),
                1e3 * meanOf(d.sizeErrors_m), order, meanOf(coverage),
                100.0 * band / std::max(1e-9, pressing), meanOf(over), meanOf(maximum), meanOf(searching));
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "palpation_operator_table LEVEL [SEEDS] [FIRST] [TRIALS] [OPERATOR]\n");
        return 2;
    }
    const simulation::PalpationParameters p =
        support::palpationLevel(std::atoi(argv[1]), argc > 4 ? std::atoi(argv[4]) : 0);
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 20;
    const auto first = static_cast<std::uint64_t>(argc > 3 ? std::atoi(argv[3]) : 1);
    const std::string only = argc > 5 ? argv[5] : "";
    std::printf(
        "| level | operator | completed | hits | misses | false alarms | d′ | c | localisation, mm | size, "
        "mm | order | coverage, %% | in band, %% | over the limit, s | force max., N | time, s |\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const std::string_view name : operators::palpationOperatorNames())
        if (only.empty() || only == name)
            printRow(p, argv[1], std::string(name), first, seeds);
    return 0;
}
