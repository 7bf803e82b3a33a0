// SPDX-License-Identifier: GPL-3.0-or-later
// Prints, as Markdown, how a scripted palpator's detection depends on hardness, size and depth of a lump, on
// the bench of support/palpation_bench.h: palpation_detection_table [OPERATOR] [SEEDS] [FIRST] [TRIALS]. Not
// a test: it asserts nothing.
#include "support/palpation_bench.h"
#include "support/palpation_detection.h"

#include <cstdio>
#include <cstdlib>

using namespace chiron;
using support::Detection;

namespace {

struct Totals {
    Detection found;
    double coverage = 0.0, time_s = 0.0, maximum_N = 0.0, over_s = 0.0, band_s = 0.0, pressing_s = 0.0;
    int trials = 0, done = 0;
};

/// Half of the trials hold one lump, half none.
Totals measure(const simulation::PalpationParameters& p, const std::string& name,
               const simulation::LumpKind& kind, std::uint64_t first, int seeds, int trials) {
    Totals out;
    const auto settings = operators::palpationOperatorSettings(name);
    for (int s = 0; s < seeds; ++s) {
        const std::uint64_t seed = first + static_cast<std::uint64_t>(s);
        core::Random random = core::Random::stream(seed, "bench/lumps");
        support::PalpationBench bench(p, *settings, seed);
        for (int trial = 0; trial < trials; ++trial) {
            const auto lumps = support::drawLumps(p, kind, trial % 2 == 0 ? 1 : 0, random);
            const support::BenchOutcome o = bench.run({lumps, {}});
            support::countTrial(out.found, p, lumps, o.findings);
            out.coverage += o.coverage;
            out.time_s += o.time_s;
            out.maximum_N = std::max(out.maximum_N, o.maximum_N);
            out.over_s += o.over_s;
            out.band_s += o.band_s;
            out.pressing_s += o.pressing_s;
            out.done += o.done ? 1 : 0;
            ++out.trials;
        }
    }
    return out;
}

void row(const std::string& what, const Totals& t) {
    const Detection& d = t.found;
    std::printf(
        "| %s | %d of %d | %d | %.2f ± %.2f | %.2f | %.1f | %.0f | %.0f | %.2f | %.2f | %.1f | %d of %d |\n",
        what.c_str(), d.hits, d.hits + d.misses, d.falseAlarms, d.dPrime(), 1.96 * d.dPrimeError(),
        d.criterion(), 1e3 * d.meanDistance_m(), 100.0 * t.coverage / t.trials,
        100.0 * t.band_s / std::max(1e-9, t.pressing_s), t.maximum_N, t.over_s / t.trials,
        t.time_s / t.trials, t.done, t.trials);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const std::string name = argc > 1 ? argv[1] : "expert";
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 5;
    const auto first = static_cast<std::uint64_t>(argc > 3 ? std::atoi(argv[3]) : 1);
    const int trials = argc > 4 ? std::atoi(argv[4]) : 4;
    simulation::PalpationParameters p;
    std::printf("| %s | hits | false alarms | d′ | c | mm off | coverage, %% | in band, %% | N max. | s "
                "over | s | done |\n",
                name == "all" ? "operator" : "lump");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    const simulation::LumpKind usual{0.0075, 0.012, 10.0, 5};
    if (name == "all") {
        for (const std::string_view one : operators::palpationOperatorNames())
            row(std::string(one), measure(p, std::string(one), usual, first, seeds, trials));
        return 0;
    }
    for (const double ratio : {1.0, 2.0, 3.0, 10.0})
        row("R 7.5 mm, depth 12 mm, ratio " + std::to_string(static_cast<int>(ratio)),
            measure(p, name, {0.0075, 0.012, ratio, 5}, first, seeds, trials));
    for (const double radius : {0.004, 0.005, 0.006, 0.009})
        row("R " + std::to_string(static_cast<int>(1e3 * radius)) + " mm, depth 12 mm, ratio 10",
            measure(p, name, {radius, 0.012, 10.0, 5}, first, seeds, trials));
    for (const double depth : {0.010, 0.015, 0.018, 0.022})
        row("R 7.5 mm, depth " + std::to_string(static_cast<int>(1e3 * depth)) + " mm, ratio 10",
            measure(p, name, {0.0075, depth, 10.0, 5}, first, seeds, trials));
    return 0;
}
