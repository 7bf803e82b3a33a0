// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how much damping each simulated mechanism carries before it shakes: damping_sweep [SEEDS] [SECONDS]
// [MECHANISM]. Not a test: it asserts nothing.
#include "damping/damping_bench.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

using namespace chiron::tests;

namespace {

void printCell(double force_N) {
    std::printf(" %s%.3f%s |", force_N > 0.1 ? "**" : "", force_N, force_N > 0.1 ? "**" : "");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 2;
    const double seconds = argc > 2 ? std::atof(argv[2]) : 12.0;
    const double dampings[] = {10, 20, 25, 30, 35, 40, 45, 50, 60, 75, 100};
    std::printf("Commanded force above 20 Hz, N rms of the worst half second, over %d seeds and %d poses.\n| "
                "mechanism | hand | load |",
                seeds, kBenchPoses);
    for (const double b : dampings)
        std::printf(" %g |", b);
    std::printf("\n|---|---|---|");
    for (std::size_t i = 0; i < std::size(dampings); ++i)
        std::printf("---|");
    std::printf("\n");
    const std::vector<std::string> mechanisms =
        argc > 3 ? std::vector<std::string>{argv[3]} : benchMechanisms();
    for (const std::string& mechanism : mechanisms)
        for (const std::string& hand : benchHands()) {
            std::array<double, std::size(dampings)> worstOfAll{};
            for (const BenchLoad load : benchLoads()) {
                std::printf("| %s | %s | %s |", mechanism.c_str(), hand.c_str(), nameOf(load).c_str());
                for (std::size_t i = 0; i < std::size(dampings); ++i) {
                    const double b = dampings[i];
                    double worst = 0.0;
                    for (int seed = 1; seed <= seeds; ++seed)
                        for (int pose = 0; pose < kBenchPoses; ++pose)
                            worst = std::max(worst, runBench({mechanism, hand, load, pose, b, b,
                                                              static_cast<std::uint64_t>(seed), seconds})
                                                        .fast_N);
                    worstOfAll[i] = std::max(worstOfAll[i], worst);
                    printCell(worst);
                }
                std::printf("\n");
            }
            std::printf("| %s | %s | the worst of all |", mechanism.c_str(), hand.c_str());
            for (const double worst : worstOfAll)
                printCell(worst);
            std::printf("\n");
        }
    return 0;
}
