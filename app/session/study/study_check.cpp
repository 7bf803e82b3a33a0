// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_check.h"

#include "session/study/apex_sitting.h"
#include "session/study/study_limits.h"
#include "session/study/study_setup.h"

#include <algorithm>

namespace chiron::session {

namespace {

core::Result<RenderingLimits> stationLimits(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition, const std::string& trainee) {
    if (looksForApex(condition)) {
        auto level = apexStudyLevel(design, condition, 1);
        if (!level)
            return tl::unexpected(level.error());
        const auto station = apexStation(*level, trainee, 1);
        return station ? core::Result<RenderingLimits>(renderingLimits(station->devices.front()->descriptor())) : tl::unexpected(station.error());
    }
    auto level = studyLevel(design, condition);
    if (!level)
        return tl::unexpected(level.error());
    auto participant = participantStation(*level, 1);
    return participant ? core::Result<RenderingLimits>(renderingLimits(participant->station.devices.front()->descriptor()))
                       : tl::unexpected(participant.error());
}

core::Result<void> checkCondition(const psychophysics::StudyDesign& design, bool blind, const psychophysics::Condition& condition, const StudyRunRequest& request) {
    const auto limit = limitOnStation(design, blind, condition, request);
    if (!limit)
        return tl::unexpected(limit.error());
    const auto progress = StudyProgress::begin(design, condition.id, 1, *limit);
    return progress ? core::Result<void>() : tl::unexpected(progress.error());
}

} // namespace

core::Result<void> checkObserver(const psychophysics::StudyDesign& design, const psychophysics::ObserverSpec& observer) {
    const auto& all = design.conditions;
    if (!observer.trainee.empty() && std::none_of(all.begin(), all.end(), looksForApex))
        return core::fail(core::ErrorCode::wrongUse, "observer: operator:" + observer.trainee + ": only a study of the apex has one");
    return {};
}

core::Result<double> limitOnStation(const psychophysics::StudyDesign& design, bool blind, const psychophysics::Condition& condition,
                                    const StudyRunRequest& request) {
    if (request.quick)
        return StudyProgress::kNoLimit;
    const auto limits = stationLimits(design, condition, request.observer.trainee);
    if (!limits)
        return tl::unexpected(limits.error());
    return (blind ? blindTable(design, condition, *limits) : limitedTable(condition, *limits)).limit;
}

core::Result<void> checkStudyRun(const psychophysics::StudyDesign& design, bool blind, const StudyRunRequest& request) {
    if (auto observer = checkObserver(design, request.observer); !observer)
        return observer;
    const bool one = !blind && !request.condition.empty();
    if (one && !conditionOf(design, request.condition))
        return core::fail(core::ErrorCode::notFound, "condition \"" + request.condition + "\" is not one of the study's");
    for (const psychophysics::Condition& condition : design.conditions)
        if (!one || condition.id == request.condition)
            if (auto good = checkCondition(design, blind, condition, request); !good)
                return good;
    return {};
}

} // namespace chiron::session
