// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <cstdint>

namespace chiron::session {

/// The presentation for which an arrangement is needed.
struct PresentationPlace {
    int procedure = 0;
    int trial = 0;   ///< scored trials of that procedure before it, whether or not the procedure used them
    int ordinal = 0; ///< presentations of the run before it
    int repeat = 0;  ///< number of times it was spoiled
    bool practice = false;
};

/// The arrangement of a presentation. Every block of as many scored trials as the task has arrangements
/// contains each of them once, in a seeded order of its own (Williams-balanced over position for rank-3,
/// since all six orders occur). Repeated trials and practice trials are drawn independently. A pure function
/// of its arguments, so that a resumed run continues as it would have.
int balancedArrangement(psychophysics::Task task, std::uint64_t seed, const PresentationPlace& place);

/// The largest number of scored trials of a condition (to within a block of arrangements); 0 if a procedure
/// has no maximum.
int trialsAtMost(const psychophysics::Condition& condition);

} // namespace chiron::session
