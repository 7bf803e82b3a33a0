// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how much damping each simulated mechanism carries before it shakes: damping_sweep [SEEDS] [SECONDS]
// [MECHANISM]. On stdout the table of docs/results/damping_sweep.md, the worst of all loads; on stderr each
// load by itself. Not a test: it asserts nothing.
#include "damping/damping_bench.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace chiron::tests;

namespace {

constexpr double kQuiet_N = 0.1;
constexpr double kDampings_Ns_per_m[] = {10, 20, 25, 30, 35, 40, 45, 50, 60, 75, 100};

/// Three digits while it is quiet; bold where it shakes.
std::string cell(double fast_N) {
    char text[40];
    std::snprintf(text, sizeof text, fast_N > kQuiet_N ? " **%.3g** |" : " %.3f |", fast_N);
    return text;
}

void printHeading(std::FILE* file, const char* first, const char* rule) {
    std::fprintf(file, "%s", first);
    for (const double b : kDampings_Ns_per_m)
        std::fprintf(file, " %g |", b);
    std::fprintf(file, "\n%s", rule);
    for (std::size_t i = 0; i < std::size(kDampings_Ns_per_m); ++i)
        std::fprintf(file, "---|");
    std::fprintf(file, "\n");
}

std::string titleOf(const std::string& mechanism) {
    return mechanism == "five_bar_spherical" ? "five-bar"
           : mechanism == "gimbal_hprd"      ? "gimbal"
           : mechanism == "fingertip_arm"    ? "fingertip arm"
                                             : mechanism;
}

double worstOf(const std::string& mechanism, const std::string& hand, BenchLoad load, double b, int seeds,
               double seconds) {
    double worst_N = 0.0;
    for (int seed = 1; seed <= seeds; ++seed)
        for (int pose = 0; pose < kBenchPoses; ++pose)
            worst_N = std::max(worst_N, runBench({mechanism, hand, load, pose, b, b,
                                                  static_cast<std::uint64_t>(seed), seconds})
                                            .fast_N);
    return worst_N;
}

} // namespace

int main(int argc, char** argv) {
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 2;
    const double seconds = argc > 2 ? std::atof(argv[2]) : 12.0;
    const std::vector<std::string> mechanisms =
        argc > 3 ? std::vector<std::string>{argv[3]} : benchMechanisms();
    std::fprintf(stderr,
                 "Commanded force above 20 Hz, N rms of the worst half second, over %d seeds and %d poses.\n",
                 seeds, kBenchPoses);
    printHeading(stderr, "| mechanism, hand, load; b, N·s/m |", "|---|");
    printHeading(stdout, "| b, N·s/m |", "|---|");
    for (const std::string& mechanism : mechanisms)
        for (const std::string& hand : benchHands()) {
            std::vector<double> worst_N(std::size(kDampings_Ns_per_m), 0.0);
            for (const BenchLoad load : benchLoads()) {
                std::fprintf(stderr, "| %s, %s, %s |", titleOf(mechanism).c_str(), hand.c_str(),
                             nameOf(load).c_str());
                for (std::size_t i = 0; i < worst_N.size(); ++i) {
                    const double fast_N =
                        worstOf(mechanism, hand, load, kDampings_Ns_per_m[i], seeds, seconds);
                    worst_N[i] = std::max(worst_N[i], fast_N);
                    std::fprintf(stderr, "%s", cell(fast_N).c_str());
                }
                std::fprintf(stderr, "\n");
            }
            std::printf("| %s, %s |", titleOf(mechanism).c_str(), hand.c_str());
            for (const double fast_N : worst_N)
                std::printf("%s", cell(fast_N).c_str());
            std::printf("\n");
            std::fflush(stdout);
        }
    return 0;
}
