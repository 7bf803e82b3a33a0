// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how each scripted endoscopist does, as Markdown: urethra_operator_table [seeds]
// [standard|unguided|stricture|tight] [operator] [seed]; with a seed, what happens in that session every half
// second. Not a test: it asserts nothing.
#include "support/urethra_session.h"

#include <cstdio>
#include <cstdlib>

using namespace chiron;
using support::UrethraOutcome;

namespace {

simulation::UrethraInsertionParameters level(const std::string& name) {
    simulation::UrethraInsertionParameters p = support::standardInsertion();
    if (name == "unguided")
        p.cues = {"object", "tool", "sound"};
    if (name == "stricture") {
        p.anatomy.changeCount = 1;
        p.anatomy.changes[0].centre_m = 0.075;
        p.anatomy.changes[0].stiffnessFactor = 15.0;
        p.trialLimit_s = 300.0;
    }
    if (name == "tight") {
        p.anatomy.radius_m = 0.0022;
        p.anatomy.wallStiffness_N_per_m3 = 4.0e6;
        p.anatomy.friction = 0.13;
    }
    return p;
}

struct Spread {
    double sum = 0.0, squares = 0.0, most = 0.0;
    int n = 0;
    void add(double x) {
        sum += x;
        squares += x * x;
        most = std::max(most, x);
        ++n;
    }
    double mean() const { return sum / n; }
    double sd() const { return n > 1 ? std::sqrt(std::max(0.0, (squares - sum * sum / n) / (n - 1))) : 0.0; }
};

void tell(const std::string& name, const std::string& levelName, std::uint64_t seed) {
    std::vector<std::array<double, 8>> story;
    support::runUrethraSession({name, seed, level(levelName), {}}, &story);
    std::printf("   t s   s mm   e mm  phiX deg phiY deg  lateral N torque mNm axial N stage\n");
    for (std::size_t i = 0; i < story.size(); i += 500)
        std::printf("%6.1f %6.1f %6.2f %8.1f %8.1f %9.2f %9.1f %8.2f %5.0f\n", 1e-3 * static_cast<double>(i),
                    1e3 * story[i][0], 1e3 * story[i][1], core::degFromRad(story[i][2]),
                    core::degFromRad(story[i][3]), story[i][4], 1e3 * story[i][5], story[i][7], story[i][6]);
}

/// One line of the table.
void printRow(const std::string& name, const std::string& levelName, int seeds) {
    int completed = 0, landmarks = 0;
    Spread time, offset, largest, alignment, bend, trauma, reversals, force, torque, overForce, overTorque,
        mostForce, mostTorque;
    for (int seed = 1; seed <= seeds; ++seed) {
        const UrethraOutcome o =
            support::runUrethraSession({name, static_cast<std::uint64_t>(seed), level(levelName), {}});
        completed += o.completed;
        landmarks += o.landmarks;
        time.add(o.time_s);
        offset.add(o.offsetRms_mm);
        largest.add(o.offsetMax_mm);
        alignment.add(o.alignmentRms_deg);
        bend.add(o.bendAlignment_deg);
        trauma.add(static_cast<double>(o.trauma));
        reversals.add(static_cast<double>(o.reversals));
        force.add(o.forceP95_N);
        mostForce.add(o.forceMax_N);
        torque.add(o.torqueP95_mNm);
        mostTorque.add(o.torqueMax_mNm);
        overForce.add(o.overForce_percent);
        overTorque.add(o.overTorque_percent);
    }
    std::printf("| %s | %d of %d | %d of %d | %.0f | %.2f ± %.2f | %.1f | %.1f° | %.1f° ± %.1f | %.1f ± %.1f "
                "| %.1f | %.2f (%.1f) | "
                "%.0f (%.0f) | %.1f %% | %.1f %% |\n",
                name.c_str(), completed, seeds, landmarks, 5 * seeds, time.mean(), offset.mean(), offset.sd(),
                largest.mean(), alignment.mean(), bend.mean(), bend.sd(), trauma.mean(), trauma.sd(),
                reversals.mean(), force.mean(), mostForce.most, torque.mean(), mostTorque.most,
                overForce.mean(), overTorque.mean());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
    const std::string levelName = argc > 2 ? argv[2] : "standard";
    const std::string only = argc > 3 ? argv[3] : "";
    if (!only.empty() && argc > 4) {
        tell(only, levelName, static_cast<std::uint64_t>(std::atoi(argv[4])));
        return 0;
    }
    std::printf("| operator | completed | landmarks | time, s | offset RMS, mm | offset max, mm | alignment "
                "RMS | at the bend | trauma | "
                "reversals | force p95 (largest), N | torque p95 (largest), mN·m | over 60 %% of 4.5 N | of "
                "150 mN·m |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto name : operators::urethraInsertionOperatorNames())
        if (only.empty() || only == name)
            printRow(std::string(name), levelName, seeds);
    return 0;
}
