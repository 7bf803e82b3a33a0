// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/report/apex_report.h"
#include "scoring/trace.h"

#include <vector>

namespace chiron::session_report {

/// The position of each trial's answer, % of the radius, as the scores count it; without a mark, the tool's
/// position at the end. Pure function.
std::vector<report::ApexError> apexErrorsOf(const scoring::SessionTrace& trace);

} // namespace chiron::session_report
