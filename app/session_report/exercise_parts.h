// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "report/report_data.h"
#include "scoring/trace.h"

namespace chiron::session_report {

/// What only this exercise has to show, chosen by its level's parameters: an exercise that has nothing written for it does not
/// compile, and none gets another one's. Pure.
report::ExerciseParts exercisePartsOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level);

} // namespace chiron::session_report
