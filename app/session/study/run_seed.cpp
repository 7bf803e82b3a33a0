// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/run_seed.h"

#include "core/random.h"

#include <algorithm>

namespace chiron::session {

namespace {

/// Also compares by the sealed code, because the run may have begun before the study was unblinded.
bool begunWith(const OpenedStudy& study, const database::StudyRun& run, const StudyRunRequest& request) {
    return (!run.condition.empty() && run.seed == seedOf(study, run.condition, request)) ||
           (!run.sealedCode.empty() && run.seed == seedOf(study, run.sealedCode, request));
}

} // namespace

std::uint64_t seedOf(const OpenedStudy& study, const std::string& label, const StudyRunRequest& request) {
    return core::Random::mix(runSeed(study, label), std::to_string(request.seed)) >> 1;
}

core::Result<void> sameSeed(const OpenedStudy& study, const database::StudyRun& run,
                            const StudyRunRequest& request) {
    if (!request.seedGiven || begunWith(study, run, request))
        return {};
    return core::fail(core::ErrorCode::wrongUse,
                      "run " + std::to_string(run.id) + " was begun with another seed than " +
                          std::to_string(request.seed) + ": expected that one, or none, to go on with it");
}

core::Result<void> seedIsOfWhatWasDone(const OpenedStudy& study, const StudyRunRequest& request) {
    const bool any = std::any_of(study.runs.begin(), study.runs.end(), [&](const database::StudyRun& run) {
        return begunWith(study, run, request);
    });
    if (any || !request.seedGiven)
        return {};
    return core::fail(core::ErrorCode::wrongUse,
                      "participant " + study.participant.code +
                          " has done every run, and none with the seed " + std::to_string(request.seed) +
                          ": expected the one they were begun with, none, or another participant");
}

} // namespace chiron::session
