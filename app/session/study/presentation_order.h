// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <cstdint>

namespace chiron::session {

/// Which presentation an arrangement is for.
struct PresentationPlace {
    int procedure = 0;
    int trial = 0;   ///< scored ones of that procedure before it, told or not
    int ordinal = 0; ///< presentations of the run before it
    int repeat = 0;  ///< how often it was spoiled
    bool practice = false;
};

/// The arrangement of a presentation: every block of as many scored trials as the task has arrangements holds each of them once, in
/// an order of its own by the seed (Williams-balanced over position for rank-3, since all six orders occur). A repeated trial and
/// practice are drawn by themselves. A pure function of its arguments, so that a resumed run goes on as it would have.
int balancedArrangement(psychophysics::Task task, std::uint64_t seed, const PresentationPlace& place);

/// Scored trials that a condition takes at most (to within a block of arrangements); 0 where no procedure says.
int trialsAtMost(const psychophysics::Condition& condition);

} // namespace chiron::session
