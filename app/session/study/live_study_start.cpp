// SPDX-License-Identifier: GPL-3.0-or-later
// How a sitting is begun: which condition, what the device renders of it, the run and its session.
#include "session/study/live_study_state.h"

#include "core/random.h"
#include "session/study/study_setup.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

/// The label that is asked for, or the next one; it is still to be done.
core::Result<std::string> chosenLabel(const OpenedStudy& study, const std::string& asked) {
    const std::vector<std::string> open = openConditions(study);
    if (open.empty())
        return core::fail(core::ErrorCode::wrongUse, "every condition is completed");
    const std::string label = asked.empty() ? open.front() : asked;
    if (std::find(open.begin(), open.end(), label) != open.end())
        return label;
    const bool known = std::find(study.order.begin(), study.order.end(), label) != study.order.end();
    return core::fail(known ? core::ErrorCode::wrongUse : core::ErrorCode::notFound,
                      "condition \"" + label + "\" is completed, or not one of the study's");
}

/// A run with its procedures where it was left, or at its beginning.
struct BegunRun {
    database::StudyRunNumber number = 0;
    std::uint64_t seed = 0;
    StudyProgress progress;
    std::size_t trials = 0; ///< stored before
};

core::Result<BegunRun> goOnWith(const OpenedStudy& study, const database::ConductedRun& conducted, double limit) {
    const database::StudyRun& begun = *conducted.open;
    if (auto same = sameTable(begun, limit); !same)
        return tl::unexpected(same.error());
    auto progress = StudyProgress::resume(study.design, conducted.condition, begun.seed, conducted.trials, StudyProgress::limitOf(begun.procedures));
    if (!progress)
        return tl::unexpected(progress.error());
    return BegunRun{begun.id, begun.seed, std::move(*progress), conducted.trials.size()};
}

core::Result<BegunRun> beginOrGoOn(database::Database& database, const database::Actor& actor, const OpenedStudy& study, const std::string& label,
                                   const database::ConductedRun& conducted, double limit) {
    if (conducted.open)
        return goOnWith(study, conducted, limit);
    const std::uint64_t seed = runSeed(study, label);
    auto progress = StudyProgress::begin(study.design, conducted.condition, seed, limit);
    if (!progress)
        return tl::unexpected(progress.error());
    auto run = beginRun(database, actor, study, label, seed, progress->procedureIds());
    if (!run)
        return tl::unexpected(run.error());
    return BegunRun{*run, seed, std::move(*progress), 0};
}

} // namespace

core::Result<std::unique_ptr<LiveStudy>> LiveStudy::start(database::Database& database, const database::Actor& actor,
                                                          LiveStudyRequest request) {
    auto study = openStudy(database, actor, request.study, request.participantCode);
    if (!study)
        return tl::unexpected(study.error());
    const auto label = chosenLabel(*study, request.condition);
    if (!label)
        return tl::unexpected(label.error());
    if (request.station.devices.empty())
        return core::fail(core::ErrorCode::wrongUse, "a sitting needs a device");
    const auto conducted = conduct(database, actor, *study, *label);
    if (!conducted)
        return tl::unexpected(conducted.error());
    auto state = State::conducted(database, actor, *study, *label, *conducted, std::move(request));
    if (!state)
        return tl::unexpected(sealedError(*study, *conducted, state.error()));
    return std::unique_ptr<LiveStudy>(new LiveStudy(std::move(*state)));
}

core::Result<std::unique_ptr<LiveStudy::State>> LiveStudy::State::conducted(database::Database& database, const database::Actor& actor,
                                                                            const OpenedStudy& study, const std::string& label,
                                                                            const database::ConductedRun& conducted, LiveStudyRequest request) {
    const psychophysics::Condition* condition = conditionOf(study.design, conducted.condition);
    if (!condition)
        return core::fail(core::ErrorCode::notFound, "condition \"" + label + "\" is not one of the study's");
    if (auto possible = studyLevel(study.design, *condition); !possible)
        return tl::unexpected(possible.error()); // before a run is begun
    const RenderingLimits limits = limitsAt(request.station.devices.front()->descriptor(), request.measuredDelay_s);
    const LimitedTable table = study.blind() ? blindTable(study.design, *condition, limits) : limitedTable(*condition, limits);
    auto begun = beginOrGoOn(database, actor, study, label, conducted, table.limit);
    if (!begun)
        return tl::unexpected(begun.error());
    auto level = studyLevel(study.design, *condition, simulation::ComparisonControl::none, sessionLabel(study, conducted.sealedCode));
    if (!level)
        return tl::unexpected(level.error());
    const auto blinding = database::blindingOf(study.record.designJson, study.record.summary.unblinded);
    if (!blinding)
        return tl::unexpected(blinding.error());
    auto state = std::make_unique<State>(database, actor, study, std::move(begun->progress), std::move(*level));
    state->blinding = *blinding;
    state->run = begun->number;
    state->describeRun(conducted, table, limits);
    TrainingRequest training;
    training.level = state->level;
    training.seed = core::Random::mix(begun->seed, "sitting " + std::to_string(begun->trials)) >> 1;
    training.station = std::move(request.station);
    training.ringFolder = request.ringFolder;
    training.witness = &state->tap;
    auto live = LiveTraining::start(database, actor, std::move(training));
    if (!live)
        return tl::unexpected(live.error());
    state->training = std::move(*live);
    state->training->post(core::CommandKind::start);
    return state;
}

void LiveStudy::State::describeRun(const database::ConductedRun& conducted, const LimitedTable& limited, const RenderingLimits& limits) {
    condition = conditionOf(study.design, conducted.condition);
    sealedCode = conducted.sealedCode;
    table = limited;
    numbers.limited = std::isfinite(table.limit);
    numbers.candidates = table.candidates;
    numbers.limits = limits;
    view.task = condition->task;
    view.places = psychophysics::placesOf(view.task);
}

} // namespace chiron::session
