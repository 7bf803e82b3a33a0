// SPDX-License-Identifier: GPL-3.0-or-later
// coverage_table [RUNS [SEED [PART]]]: prints, for observers a third as steep, as steep and three times as
// steep as expected, how often the 95 % intervals of each procedure and fit hold the truth. Default: 200 runs
// each, seed 20261125; with PART only the rows that have it in their name.
#include "coverage_runs.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::atoi(argv[1]) : 200;
    const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 20261125ULL;
    if (runs < 1 || argc > 4) {
        std::fprintf(stderr,
                     "coverage_table [RUNS [SEED [PART]]]: expected a number of runs of at least 1\n");
        return 2;
    }
    coverage_runs::print(
        coverage_runs::coverageTable(runs, seed, argc > 3 ? QString::fromLocal8Bit(argv[3]) : QString()));
    return 0;
}
