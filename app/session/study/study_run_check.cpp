// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_run_check.h"

#include "session/study/mark_sessions.h"
#include "session/study/simulated_limits.h"
#include "session/study/study_setup.h"

#include <algorithm>

namespace chiron::session {

namespace {

/// Checks that the condition can be presented to its simulated participant at all.
core::Result<void> checkStation(const psychophysics::StudyDesign& design,
                                const psychophysics::Condition& condition, const std::string& trainee) {
    if (const MarkSessions* marks = markSessionsOf(condition)) {
        auto level = marks->level(design, condition, 1, {});
        CHIRON_TRY(level);
        const auto station = marks->scripted(*level, trainee, 1);
        CHIRON_TRY(station);
        return {};
    }
    auto level = studyLevel(design, condition);
    CHIRON_TRY(level);
    const auto participant = participantStation(*level, 1);
    CHIRON_TRY(participant);
    return {};
}

core::Result<void> checkCondition(const psychophysics::StudyDesign& design, bool blind,
                                  const psychophysics::Condition& condition, const StudyRunRequest& request,
                                  const RenderingLimits& limits) {
    const auto limit = limitOnStation(design, blind, condition, request, limits);
    CHIRON_TRY(limit);
    const auto progress = StudyProgress::begin(design, condition.id, 1, *limit);
    CHIRON_TRY(progress);
    return {};
}

} // namespace

core::Result<void> checkObserver(const psychophysics::StudyDesign& design,
                                 const psychophysics::ObserverSpec& observer) {
    const auto& all = design.conditions;
    if (!observer.trainee.empty() && std::none_of(all.begin(), all.end(), looksForApex))
        return core::fail(core::ErrorCode::wrongUse,
                          "observer: operator:" + observer.trainee + ": only a study of the apex has one");
    return {};
}

core::Result<RenderingLimits> limitsOfRun(const StudyRunRequest& request) {
    return request.quick ? RenderingLimits{} : simulatedLimits();
}

core::Result<double> limitOnStation(const psychophysics::StudyDesign& design, bool blind,
                                    const psychophysics::Condition& condition, const StudyRunRequest& request,
                                    const RenderingLimits& limits) {
    if (request.quick)
        return StudyProgress::kNoLimit;
    CHIRON_TRY(checkStation(design, condition, request.observer.trainee));
    return (blind ? blindTable(design, condition, limits) : limitedTable(condition, limits)).limit;
}

core::Result<void> checkStudyRun(const psychophysics::StudyDesign& design, bool blind,
                                 const StudyRunRequest& request) {
    CHIRON_TRY(checkObserver(design, request.observer));
    const bool one = !blind && !request.condition.empty();
    if (one && !conditionOf(design, request.condition))
        return core::fail(core::ErrorCode::notFound,
                          "condition \"" + request.condition + "\" is not one of the study's");
    const auto limits = limitsOfRun(request);
    CHIRON_TRY(limits);
    for (const psychophysics::Condition& condition : design.conditions)
        if (!one || condition.id == request.condition)
            CHIRON_TRY(checkCondition(design, blind, condition, request, *limits));
    return {};
}

} // namespace chiron::session
