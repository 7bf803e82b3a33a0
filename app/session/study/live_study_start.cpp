// SPDX-License-Identifier: GPL-3.0-or-later
// How a sitting is begun: which condition, what the device renders of it, the run and its session.
#include "session/study/live_study_state.h"

#include "core/random.h"
#include "session/study/study_setup.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

/// The condition that is asked for, or the next one; it is still to be done.
core::Result<const psychophysics::Condition*> chosenCondition(const OpenedStudy& study, const std::string& asked) {
    const std::vector<std::string> open = openConditions(study);
    const std::string id = !asked.empty() ? asked : open.empty() ? std::string() : open.front();
    const psychophysics::Condition* condition = conditionOf(study.design, id);
    if (condition && std::find(open.begin(), open.end(), id) != open.end())
        return condition;
    return core::fail(condition || open.empty() ? core::ErrorCode::wrongUse : core::ErrorCode::notFound,
                      open.empty() ? "every condition is completed" : "condition \"" + id + "\" is completed, or not one of the study's");
}

/// A run with its procedures where it was left, or at its beginning.
struct BegunRun {
    database::StudyRun run;
    StudyProgress progress;
    std::size_t trials = 0; ///< stored before
};

core::Result<BegunRun> goOnWith(database::Database& database, const database::Actor& actor, const OpenedStudy& study,
                                const database::StudyRun& begun, double limit) {
    if (auto same = sameTable(begun, limit); !same)
        return tl::unexpected(same.error());
    const auto trials = trialsOf(database, actor, begun.id);
    if (!trials)
        return tl::unexpected(trials.error());
    auto progress = StudyProgress::resume(study.design, begun.condition, begun.seed, *trials, StudyProgress::limitOf(begun.procedures));
    if (!progress)
        return tl::unexpected(progress.error());
    return BegunRun{begun, std::move(*progress), trials->size()};
}

core::Result<BegunRun> beginOrGoOn(database::Database& database, const database::Actor& actor, const OpenedStudy& study,
                                   const std::string& condition, double limit) {
    if (const auto begun = openRun(study, condition))
        return goOnWith(database, actor, study, *begun, limit);
    const std::uint64_t seed = runSeed(study, condition);
    auto progress = StudyProgress::begin(study.design, condition, seed, limit);
    if (!progress)
        return tl::unexpected(progress.error());
    auto run = beginRun(database, actor, study, condition, seed, progress->procedureIds());
    if (!run)
        return tl::unexpected(run.error());
    return BegunRun{std::move(*run), std::move(*progress), 0};
}

} // namespace

core::Result<std::unique_ptr<LiveStudy>> LiveStudy::start(database::Database& database, const database::Actor& actor,
                                                          LiveStudyRequest request) {
    auto study = openStudy(database, actor, request.study, request.participantCode);
    if (!study)
        return tl::unexpected(study.error());
    const auto condition = chosenCondition(*study, request.condition);
    if (!condition)
        return tl::unexpected(condition.error());
    if (request.station.devices.empty())
        return core::fail(core::ErrorCode::wrongUse, "a sitting needs a device");
    if (auto possible = studyLevel(study->design, **condition); !possible)
        return tl::unexpected(possible.error()); // before a run is begun
    const RenderingLimits limits = limitsAt(request.station.devices.front()->descriptor(), request.measuredDelay_s);
    const LimitedTable table = limitedTable(**condition, limits);
    auto begun = beginOrGoOn(database, actor, *study, (*condition)->id, table.limit);
    if (!begun)
        return tl::unexpected(begun.error());
    auto level = studyLevel(study->design, **condition, simulation::ComparisonControl::none, sessionLabel(*study, begun->run.sealedCode));
    if (!level)
        return tl::unexpected(level.error());
    const std::string id = (*condition)->id;
    auto state = std::make_unique<State>(database, actor, std::move(*study), std::move(begun->progress), std::move(*level));
    state->describeRun(id, begun->run, table, limits);
    TrainingRequest training;
    training.level = state->level;
    training.seed = core::Random::mix(begun->run.seed, "sitting " + std::to_string(begun->trials)) >> 1;
    training.station = std::move(request.station);
    training.ringFolder = request.ringFolder;
    training.witness = &state->tap;
    auto live = LiveTraining::start(database, actor, std::move(training));
    if (!live)
        return tl::unexpected(live.error());
    state->training = std::move(*live);
    state->training->post(core::CommandKind::start);
    return std::unique_ptr<LiveStudy>(new LiveStudy(std::move(state)));
}

void LiveStudy::State::describeRun(const std::string& id, const database::StudyRun& begun, const LimitedTable& limited,
                                   const RenderingLimits& limits) {
    condition = conditionOf(study.design, id);
    run = begun.id;
    sealedCode = begun.sealedCode;
    table = limited;
    numbers.limited = std::isfinite(table.limit);
    numbers.candidates = table.candidates;
    numbers.limits = limits;
    view.task = condition->task;
    view.places = psychophysics::placesOf(view.task);
}

} // namespace chiron::session
