// SPDX-License-Identifier: GPL-3.0-or-later
// The start of a run of comparisons: the differences that the device renders, the run and its session.
#include "session/study/live_study_state.h"

#include "core/random.h"
#include "session/study/study_setup.h"

#include <cmath>

namespace chiron::session {

SittingResult<std::unique_ptr<LiveStudy>>
LiveStudy::start(database::Database& database, const database::Actor& actor, LiveStudyRequest request) {
    const auto sitting = conductSitting(database, actor, request);
    CHIRON_TRY(sitting);
    return start(database, actor, *sitting, std::move(request));
}

SittingResult<std::unique_ptr<LiveStudy>> LiveStudy::start(database::Database& database,
                                                           const database::Actor& actor,
                                                           const ConductedSitting& sitting,
                                                           LiveStudyRequest request) {
    auto state = State::conducted(database, actor, sitting, std::move(request));
    if (!state)
        return tl::unexpected(sealed(sitting, state.error()));
    return std::unique_ptr<LiveStudy>(new LiveStudy(std::move(*state)));
}

SittingResult<std::unique_ptr<LiveStudy::State>> LiveStudy::State::conducted(database::Database& database,
                                                                             const database::Actor& actor,
                                                                             const ConductedSitting& sitting,
                                                                             LiveStudyRequest request) {
    const OpenedStudy& study = sitting.study;
    const psychophysics::Condition& condition = *sitting.condition();
    CHIRON_TRY(studyLevel(study.design, condition)); // before a run begins
    const RenderingLimits limits =
        limitsAt(request.station.tools.front().device->descriptor(), request.measuredDelay_s);
    const LimitedTable table =
        study.blind() ? blindTable(study.design, condition, limits) : limitedTable(condition, limits);
    auto begun = beginOrGoOn(database, actor, sitting, table.limit);
    CHIRON_TRY(begun);
    const double free_s = sitting.run.trials.empty() ? request.freeMinute_s : 0.0;
    auto level = studyLevel(study.design, condition, simulation::ComparisonControl::none,
                            sessionLabel(study, sitting.run.sealedCode), free_s > 0.0);
    CHIRON_TRY(level);
    auto state = std::make_unique<State>(
        database, actor, study, std::move(begun->progress), std::move(*level),
        !request.station.tools.front().device->descriptor().rendersForce, request.language);
    state->tryFor_s = free_s;
    state->waitsAfterPractice = request.waitsAfterPractice;
    state->view.firstPart = study.firstPart(sitting.label);
    state->view.partsToCome = study.partsBeside(sitting.label);
    state->blinding = study.record.blinding;
    state->run = begun->number;
    state->describeRun(sitting.run, table, limits);
    TrainingRequest training;
    training.level = state->level;
    training.seed =
        core::Random::mix(begun->seed, "sitting " + std::to_string(sitting.run.trials.size())) >> 1;
    training.station = std::move(request.station);
    training.ringFolder = request.ringFolder;
    training.studyRun = begun->number;
    training.witness = &state->tap;
    auto live = LiveTraining::start(database, actor, std::move(training));
    CHIRON_TRY(live);
    state->training = std::move(*live);
    state->training->post(core::CommandKind::start);
    return state;
}

void LiveStudy::State::describeRun(const database::ConductedRun& conducted, const LimitedTable& limited,
                                   const RenderingLimits& limits) {
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
