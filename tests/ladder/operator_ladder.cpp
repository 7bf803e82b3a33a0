// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how every scripted operator fares on every level, through recording and scoring:
//   operator_ladder [EXERCISE|all] [LEVEL|0] [SEEDS] [FIRST] [CHECK_EVERY] [BUDGET] [OPTIONS]
//   operator_ladder table FOLDER [EXERCISE|all] [LEVEL|0] [OPTIONS]
// FIRST: the first seed, 0: drawn. CHECK_EVERY: of the sessions, replayed and scored again, 0: none. BUDGET:
// of damping, N·s/m, instead of what the devices say they carry (0: theirs). Options: --hand light|usual|firm
// (else each operator's own), --mechanism ID (else the exercise's usual one), --operator NAME (else all
// four),
// --store FOLDER (keeps every session there; what it has of these sources is not run again). `table` prints
// the table from a store and runs nothing: of each level the sources of its last session. Not a test: it
// asserts nothing.
#include "ladder/ladder.h"
#include "ladder/ladder_store.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>
#include <set>

using namespace chiron;

namespace {

/// "7, 100–119": in ascending order.
std::string seedsOf(const tests::LadderLevel& level) {
    std::set<std::uint64_t> seeds;
    for (const auto& [name, sessions] : level.byOperator)
        for (const tests::LadderSession& session : sessions)
            seeds.insert(session.seed);
    std::string text;
    for (auto it = seeds.begin(); it != seeds.end();) {
        const std::uint64_t first = *it;
        std::uint64_t last = first;
        while (++it != seeds.end() && *it == last + 1)
            ++last;
        text += (text.empty() ? "" : ", ") + std::to_string(first) +
                (last == first ? "" : "–" + std::to_string(last));
    }
    return text;
}

void print(const tests::LadderLevel& level) {
    std::printf("%s", tests::lines(level).c_str());
    std::fflush(stdout);
    for (const std::string& line : tests::inverted(level))
        std::fprintf(stderr, "  inverted: %s\n", line.c_str());
    for (const std::string& line : tests::unfounded(level))
        std::fprintf(stderr, "  unfounded: %s\n", line.c_str());
    if (!level.byOperator.empty())
        std::fprintf(stderr, "%s\n%s", level.level.c_str(), tests::metricLines(level).c_str());
}

struct Chosen {
    std::string exercise = "all";
    int number = 0; ///< 0: all
    bool has(const catalogue::ExerciseLevel& level) const {
        return (exercise == "all" || exercise == level.exercise) && (number == 0 || number == level.number);
    }
};

void printStored(const std::vector<const catalogue::ExerciseLevel*>& levels, const std::string& folder,
                 tests::LadderSettings settings) {
    std::vector<tests::LadderLevel> found;
    for (const catalogue::ExerciseLevel* level : levels) {
        const auto sources = tests::LadderStore::last(folder, *level);
        if (!sources)
            continue;
        tests::LadderStore store(folder, *sources);
        settings.store = &store;
        found.push_back(tests::recalled(*level, settings));
        if (found.back().byOperator.empty())
            continue;
        std::printf("- %s: seeds %s; commit %s, models %s\n", found.back().level.c_str(),
                    seedsOf(found.back()).c_str(), sources->commit.c_str(), sources->models.c_str());
    }
    std::printf("\n%s", tests::heading().c_str());
    for (const tests::LadderLevel& level : found)
        print(level);
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions(
        {{QStringLiteral("hand"), QStringLiteral("light, usual or firm"), QStringLiteral("name")},
         {QStringLiteral("mechanism"), QStringLiteral("kinematics id"), QStringLiteral("id")},
         {QStringLiteral("operator"), QStringLiteral("one operator"), QStringLiteral("name")},
         {QStringLiteral("store"), QStringLiteral("keeps sessions"), QStringLiteral("folder")}});
    parser.process(application);
    QStringList words = parser.positionalArguments();
    std::string folder = parser.value(QStringLiteral("store")).toStdString();
    const bool table = !words.isEmpty() && words.first() == QLatin1String("table");
    if (table) {
        if (words.size() < 2) {
            std::fprintf(stderr, "operator_ladder table: say in which folder the sessions are kept\n");
            return 2;
        }
        folder = words[1].toStdString();
        words = words.mid(2);
    }
    Chosen chosen;
    if (!words.isEmpty())
        chosen.exercise = words[0].toStdString();
    if (words.size() > 1)
        chosen.number = words[1].toInt();
    tests::LadderSettings settings;
    settings.seeds = words.size() > 2 ? words[2].toInt() : 20;
    settings.first = words.size() > 3 ? words[3].toULongLong() : 0;
    if (settings.first == 0)
        settings.first = 1 + std::random_device{}() % 1000000;
    settings.checkEvery = words.size() > 4 ? words[4].toInt() : 1;
    settings.budget_Ns_per_m = words.size() > 5 ? words[5].toDouble() : 0.0;
    settings.hand = parser.value(QStringLiteral("hand")).toStdString();
    settings.mechanism = parser.value(QStringLiteral("mechanism")).toStdString();
    if (parser.isSet(QStringLiteral("operator")))
        settings.operators = {parser.value(QStringLiteral("operator")).toStdString()};
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue) {
        std::fprintf(stderr, "%s\n", catalogue.error().message.c_str());
        return 2;
    }
    std::vector<const catalogue::ExerciseLevel*> levels;
    for (const catalogue::Exercise& one : catalogue->exercises())
        for (const catalogue::ExerciseLevel& level : one.levels)
            if (chosen.has(level))
                levels.push_back(&level);
    if (table) {
        printStored(levels, folder, settings);
        return 0;
    }
    std::optional<tests::LadderStore> store;
    if (!folder.empty())
        settings.store = &store.emplace(folder);
    std::printf("Seeds from %llu, %d a level and operator.\n\n%s",
                static_cast<unsigned long long>(settings.first), settings.seeds, tests::heading().c_str());
    for (const catalogue::ExerciseLevel* level : levels)
        print(tests::climb(*level, settings));
    return 0;
}
