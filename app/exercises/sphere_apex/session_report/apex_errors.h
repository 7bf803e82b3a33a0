// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/report/apex_report.h"
#include "scoring/trace.h"

#include <vector>

namespace chiron::session_report {

/// Where each trial's answer lay, % of the radius: what the scores count; without a mark, where the tool stood at the end. Pure.
std::vector<report::ApexError> apexErrorsOf(const scoring::SessionTrace& trace);

} // namespace chiron::session_report
