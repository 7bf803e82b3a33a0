// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how every scripted operator fares on every level, through recording and scoring: operator_ladder
// [EXERCISE|all] [LEVEL|0] [SEEDS] [FIRST] [CHECK_EVERY] [BUDGET]. FIRST: the first seed, 0: drawn. BUDGET:
// of damping, N·s/m, instead of what the devices say they carry (0: theirs). Not a test: it asserts nothing.
#include "ladder/ladder.h"

#include <QCoreApplication>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace chiron;

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    const std::string exercise = argc > 1 ? argv[1] : "all";
    const int number = argc > 2 ? std::atoi(argv[2]) : 0;
    tests::LadderSettings settings;
    settings.seeds = argc > 3 ? std::atoi(argv[3]) : 20;
    settings.first = argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 0;
    if (settings.first == 0)
        settings.first = 1 + std::random_device{}() % 1000000;
    settings.checkEvery = argc > 5 ? std::atoi(argv[5]) : 0;
    settings.budget_Ns_per_m = argc > 6 ? std::atof(argv[6]) : 0.0;
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue) {
        std::fprintf(stderr, "%s\n", catalogue.error().message.c_str());
        return 2;
    }
    std::printf("Seeds from %llu, %d a level and operator.\n\n%s",
                static_cast<unsigned long long>(settings.first), settings.seeds, tests::heading().c_str());
    for (const catalogue::Exercise& one : catalogue->exercises())
        for (const catalogue::ExerciseLevel& level : one.levels) {
            if ((exercise != "all" && exercise != one.id) || (number > 0 && number != level.number))
                continue;
            const tests::LadderLevel climbed = tests::climb(level, settings);
            std::printf("%s", tests::lines(climbed).c_str());
            for (const std::string& line : tests::inverted(climbed))
                std::printf("  inverted: %s\n", line.c_str());
            std::fprintf(stderr, "%s\n%s", climbed.level.c_str(), tests::metricLines(climbed).c_str());
            std::fflush(stdout);
        }
    return 0;
}
