// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/begun_run.h"

#include "session/study/study_setup.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

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

SittingError refused(core::Error error, DeviceRefusal device) {
    SittingError typed(std::move(error));
    typed.device = device;
    return typed;
}

bool rendersAny(const psychophysics::Condition& condition, double limit) {
    const std::vector<double>& differences = condition.stimulus.differences;
    return std::any_of(differences.begin(), differences.end(),
                       [limit](double difference) { return std::abs(difference) <= limit; });
}

SittingResult<BegunRun> goOnWith(const OpenedStudy& study, const database::ConductedRun& conducted,
                                 double limit) {
    const database::StudyRun& begun = *conducted.open;
    if (auto same = sameTable(begun, limit); !same)
        return tl::unexpected(refused(same.error(), DeviceRefusal::rendersLess));
    auto progress = StudyProgress::resume(study.design, conducted.condition, begun.seed, conducted.trials,
                                          StudyProgress::limitOf(begun.procedures));
    CHIRON_TRY(progress);
    if (auto same = sameVersions(begun, progress->procedureIds()); !same) {
        SittingError typed(same.error());
        typed.otherVersion = true;
        return tl::unexpected(std::move(typed));
    }
    return BegunRun{begun.id, begun.seed, std::move(*progress)};
}

} // namespace

const psychophysics::Condition* ConductedSitting::condition() const {
    return conditionOf(study.design, run.condition);
}

core::Result<ConductedSitting> conductSitting(database::Database& database, const database::Actor& actor,
                                              const LiveStudyRequest& request) {
    auto study = openStudy(database, actor, request.study, request.participantCode);
    CHIRON_TRY(study);
    auto label = chosenLabel(*study, request.condition);
    CHIRON_TRY(label);
    if (request.station.tools.empty())
        return core::fail(core::ErrorCode::wrongUse, "a session needs a device");
    auto run = conduct(database, actor, *study, *label);
    CHIRON_TRY(run);
    study = unmasked(std::move(*study), *run);
    CHIRON_TRY(study);
    ConductedSitting sitting{std::move(*study), std::move(*label), std::move(*run)};
    if (!sitting.condition())
        return core::fail(core::ErrorCode::notFound,
                          "condition \"" + sitting.label + "\" is not one of the study's");
    return sitting;
}

SittingError sealed(const ConductedSitting& sitting, SittingError error) {
    error.message = sealedError(sitting.study, sitting.run, error).message;
    return error;
}

SittingResult<BegunRun> beginOrGoOn(database::Database& database, const database::Actor& actor,
                                    const ConductedSitting& sitting, double limit) {
    if (sitting.run.open)
        return goOnWith(sitting.study, sitting.run, limit);
    const std::uint64_t seed = runSeed(sitting.study, sitting.label);
    auto progress = StudyProgress::begin(sitting.study.design, sitting.run.condition, seed, limit);
    if (!progress)
        return tl::unexpected(rendersAny(*sitting.condition(), limit)
                                  ? SittingError(progress.error())
                                  : refused(progress.error(), DeviceRefusal::rendersNone));
    auto run = beginRun(database, actor, sitting.study, sitting.label, seed, progress->procedureIds());
    CHIRON_TRY(run);
    return BegunRun{*run, seed, std::move(*progress)};
}

} // namespace chiron::session
