// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how each scripted trainee does, as Markdown: apex_operator_table [seeds] [level 1..4]. Not a test:
// it asserts nothing. The levels are those of models.md §2.3 in short form.
#include "support/apex_session.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace chiron;

namespace {

simulation::SphereApexParameters level(int number) {
    simulation::SphereApexParameters p;
    if (number == 1)
        p.cues = {"object"};
    if (number == 3) {
        p.stiffnessLow_N_per_m = 300.0;
        p.stiffnessHigh_N_per_m = 1200.0;
        p.frictionHigh = 0.4;
    }
    if (number == 4)
        p.dimpleDepth_m = 0.0015;
    return p;
}

} // namespace

int main(int argc, char** argv) {
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
    const int number = argc > 2 ? std::atoi(argv[2]) : 2;
    std::printf("| operator | mean abs. error, %% of R | SD over seeds | time, s | max. force, N: mean "
                "(largest) | marked | "
                "in contact |\n"
                "|---|---|---|---|---|---|---|\n");
    std::uint64_t ticks = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (const auto name : operators::sphereApexOperatorNames()) {
        double sum = 0.0, squares = 0.0, time = 0.0, force = 0.0, forces = 0.0;
        int trials = 0, marked = 0, touching = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            const auto outcome = support::runApexSession(
                {std::string(name), static_cast<std::uint64_t>(seed), level(number), {}});
            double mean = 0.0;
            for (const auto& trial : outcome.trials) {
                mean += trial.meanAbsoluteError_percent() / static_cast<double>(outcome.trials.size());
                time += trial.time_s;
                force = std::max(force, trial.maximumForce_N);
                forces += trial.maximumForce_N;
                ++trials;
                marked += trial.marked;
                touching += trial.touching;
            }
            sum += mean;
            squares += mean * mean;
            ticks += outcome.ticks;
        }
        const double mean = sum / seeds;
        std::printf("| %s | %.1f | %.1f | %.1f | %.1f (%.1f) | %d of %d | %d |\n", std::string(name).c_str(),
                    mean, std::sqrt(std::max(0.0, (squares - seeds * mean * mean) / std::max(1, seeds - 1))),
                    time / trials, forces / trials, force, marked, trials, touching);
    }
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::fprintf(stderr, "%.0f thousand ticks a second\n", 1e-3 * static_cast<double>(ticks) / wall);
    return 0;
}
