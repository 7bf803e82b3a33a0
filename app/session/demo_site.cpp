// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/demo_site.h"

#include "database/accounts/account_service.h"
#include "database/repositories/score_repository.h"
#include "session/replayer.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace chiron::session {

namespace {

struct DemoPerson {
    const char* name;
    const char* displayName;
    database::Role role;
    const char* operatorName; ///< operator that acts as the trainee's hand; empty: the person does not train
    /// For a trainee who learns: the operators of successive attempts, with growing skill.
    std::vector<const char*> learns{};
};

constexpr const char* kAdministrator = "amalia";

const DemoPerson kPeople[] = {
    {"theo", "Theo Trainer", database::Role::trainer, ""},
    {kDemoResearcher, "Rhea Researcher", database::Role::researcher, ""},
    {"nikos",
     "Nikos Newcomer",
     database::Role::trainee,
     "novice",
     {"novice", "novice", "novice", "intermediate"}},
    {"ines",
     "Ines Improving",
     database::Role::trainee,
     "intermediate",
     {"novice", "novice", "intermediate", "intermediate", "expert"}},
    {"eva", "Eva Expert", database::Role::trainee, "expert"},
};

/// One planned session and the person on whose behalf it runs.
struct Planned {
    std::string person;
    database::Actor actor;
    ScriptedSession session;
    std::string displayName{}; ///< full name of a person
    int attempt = 1;
    int attempts = 1;
};

bool hasOperator(const std::string& exercise, const std::string& name) {
    const auto kind = exerciseKind(exercise);
    if (!kind)
        return false;
    const std::vector<std::string> names = (*kind)->operatorNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The part of an exercise that does not exist is empty.
DemoPart demoPartOf(const std::string& exercise, int level) {
    const auto kind = exerciseKind(exercise);
    return kind ? (*kind)->demoPart(level) : DemoPart{};
}

/// The operators that act as the person's hand at a level, one per attempt.
std::vector<std::string> handsAt(const DemoPerson& person, const std::string& exercise, int level) {
    const DemoPart part = demoPartOf(exercise, level);
    if (!(person.learns.empty() ? part.ofWhoCan : part.ofWhoLearns))
        return {};
    std::vector<std::string> hands;
    if (part.learned)
        hands.assign(person.learns.begin(), person.learns.end());
    if (hands.empty())
        hands.emplace_back(person.operatorName);
    std::erase_if(hands, [&](const std::string& name) { return !hasOperator(exercise, name); });
    return hands;
}

std::string wordsFor(const Planned& plan) {
    const std::string what = plan.session.exercise + " level " + std::to_string(plan.session.level) + ", ";
    if (plan.displayName.empty())
        return what + plan.session.operatorName;
    return what + plan.displayName +
           (plan.attempts > 1
                ? ", attempt " + std::to_string(plan.attempt) + " of " + std::to_string(plan.attempts)
                : std::string());
}

core::Result<std::vector<Planned>> makePeople(database::Database& database,
                                              const catalogue::Catalogue& catalogue, std::uint64_t seed) {
    database::AccountService accounts(database);
    auto administrator =
        accounts.createFirstAdministrator(kAdministrator, kDemoPassword, "Amalia Administrator");
    CHIRON_TRY(administrator);
    auto admin = accounts.login(kAdministrator, kDemoPassword);
    CHIRON_TRY(admin);
    std::vector<Planned> planned;
    for (const DemoPerson& person : kPeople) {
        auto id = accounts.createPerson(
            *admin, {person.name, person.displayName, {person.role}, kDemoPassword, false});
        CHIRON_TRY(id);
        if (*person.operatorName == '\0')
            continue;
        auto actor = accounts.login(person.name, kDemoPassword);
        CHIRON_TRY(actor);
        for (const catalogue::Exercise& exercise : catalogue.exercises())
            for (const catalogue::ExerciseLevel& level : exercise.levels) {
                const std::vector<std::string> hands = handsAt(person, exercise.id, level.number);
                for (std::size_t i = 0; i < hands.size(); ++i)
                    planned.push_back({person.name,
                                       *actor,
                                       {exercise.id, level.number, hands[i], seed + planned.size() + 100},
                                       person.displayName,
                                       static_cast<int>(i) + 1,
                                       static_cast<int>(hands.size())});
            }
    }
    return planned;
}

core::Result<std::vector<Planned>> planOperators(const catalogue::Catalogue& catalogue, std::uint64_t seed) {
    std::vector<Planned> planned;
    for (const catalogue::Exercise& exercise : catalogue.exercises()) {
        auto kind = exerciseKind(exercise.id);
        CHIRON_TRY(kind);
        for (const catalogue::ExerciseLevel& level : exercise.levels) {
            if (!(*kind)->demoPart(level.number).ofOperators)
                continue;
            for (const std::string& name : (*kind)->operatorNames())
                planned.push_back(
                    {"simulated", database::Actor::simulated(), {exercise.id, level.number, name, seed}});
        }
    }
    return planned;
}

core::Result<void> checkAgain(database::Database& database, const database::Actor& actor,
                              DemoResult& result) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    auto stored = SessionView::open(**connection, actor, result.result.session);
    CHIRON_TRY(stored);
    auto replay = replaySession(**stored);
    CHIRON_TRY(replay);
    result.replayIdentical = replay->identical;
    auto kept = database::ScoreRepository(**connection, actor).scores(result.result.session);
    auto again = (*stored)->computeScores();
    CHIRON_TRY(kept);
    CHIRON_TRY(again);
    result.scoreSame = sameScores(*kept, *again) && sameScores(*kept, result.result.scores);
    return {};
}

} // namespace

bool DemoSite::holds() const {
    return study.replayIdentical &&
           std::all_of(sessions.begin(), sessions.end(),
                       [](const DemoResult& each) { return each.replayIdentical && each.scoreSame; }) &&
           std::all_of(study.runs.begin(), study.runs.end(),
                       [](const DemoStudyRun& each) { return each.choicesSame; });
}

core::Result<DemoSite> makeDemoSite(database::Database& database, const catalogue::Catalogue& catalogue,
                                    std::uint64_t seed,
                                    const std::function<void(const DemoProgress&)>& progress,
                                    const std::atomic<bool>* cancel) {
    auto planned = planOperators(catalogue, seed);
    CHIRON_TRY(planned);
    auto people = makePeople(database, catalogue, seed);
    CHIRON_TRY(people);
    planned->insert(planned->end(), people->begin(), people->end());
    DemoSite made;
    int step = 0;
    const int steps = static_cast<int>(planned->size()) + demoStudyParticipants();
    for (const Planned& plan : *planned) {
        if (cancel != nullptr && cancel->load(std::memory_order_relaxed))
            return core::fail(core::ErrorCode::cancelled,
                              "the demonstration was stopped before it was complete");
        progress({++step, steps, wordsFor(plan), plan.session.exercise, plan.session.level, plan.displayName,
                  plan.attempt, plan.attempts});
        auto result = runScripted(database, plan.actor, catalogue, plan.session, cancel);
        CHIRON_TRY(result);
        DemoResult line{plan.person, plan.session, std::move(*result), false, false};
        CHIRON_TRY(checkAgain(database, plan.actor, line));
        made.sessions.push_back(std::move(line));
    }
    const auto researcher = database::AccountService(database).login(kDemoResearcher, kDemoPassword);
    CHIRON_TRY(researcher);
    auto study = makeDemoStudy(
        database, *researcher, seed,
        [&](const std::string& doing) {
            progress({++step, steps, doing});
        },
        cancel);
    CHIRON_TRY(study);
    made.study = std::move(*study);
    return made;
}

core::Result<std::unique_ptr<database::Database>>
createDemoSite(const std::string& file, const database::DatabaseOptions& options,
               const catalogue::Catalogue& catalogue, std::uint64_t seed,
               const std::function<void(const DemoProgress&)>& progress, const std::atomic<bool>* cancel) {
    const QString name = QString::fromStdString(file);
    if (QFileInfo::exists(name))
        return core::fail(core::ErrorCode::badInput,
                          file + ": exists already; a demonstration is made in a new file");
    database::DatabaseOptions marked = options;
    marked.demonstration = true;
    const std::string folder = database::siteFolderFor(file, marked);
    const bool ownFolder = !QFileInfo::exists(QString::fromStdString(folder));
    auto site = openSite(file, marked);
    CHIRON_TRY(site);
    auto made = makeDemoSite(*site->database, catalogue, seed, progress, cancel);
    if (made)
        return std::move(site->database);
    site->database.reset();
    for (const char* suffix : {"", "-wal", "-shm"})
        QFile::remove(name + QLatin1String(suffix));
    if (ownFolder)
        QDir(QString::fromStdString(folder)).removeRecursively();
    return tl::unexpected(made.error());
}

} // namespace chiron::session
