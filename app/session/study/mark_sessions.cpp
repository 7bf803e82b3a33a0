// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/mark_sessions.h"

#include "core/random.h"
#include "psychophysics/study/apex_study.h"
#include "session/exercise_kind.h"

#include <cmath>

namespace chiron::session {

const MarkSessions* markSessionsOf(const psychophysics::Condition& condition) {
    for (const ExerciseKind* kind : exerciseKinds())
        if (const MarkSessions* sessions = kind->markSessions(condition))
            return sessions;
    return nullptr;
}

bool looksForApex(const psychophysics::Condition& condition) noexcept {
    return condition.stimulus.attribute == psychophysics::Attribute::apex;
}

StudyAnswer plannedMark(double radius_m, std::uint64_t seed, int ordinal) {
    auto random = core::Random::stream(seed, "study.apex " + std::to_string(ordinal));
    const double sd_m = psychophysics::ApexObserver{}.sdPercent / 100.0 * radius_m;
    ApexMark mark;
    mark.errorX_m = sd_m * random.normal();
    mark.errorY_m = sd_m * random.normal();
    mark.radius_m = radius_m;
    mark.planned = true;
    StudyAnswer answer;
    answer.answer = 0;
    answer.value = std::hypot(mark.errorX_m, mark.errorY_m);
    answer.fidelity.apex = mark;
    return answer;
}

} // namespace chiron::session
