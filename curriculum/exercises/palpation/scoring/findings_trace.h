// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/findings_book.h"
#include "core/geometry.h"
#include "scoring/trace.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// One report as a recording tells it.
struct TimedReport {
    double t_s = 0.0; ///< of the trace
    core::ReportField field = core::ReportField::found;
    int finding = simulation::FindingsBook::kNone; ///< which it was about
    unsigned value = 0;                      ///< as in the report word
    core::Vec3 place_W = core::Vec3::Zero(); ///< of the finding, on the surface, m
};

struct ReportsOfTrial {
    std::vector<TimedReport> reports; ///< in the order in which they were made
    int lost = 0;                     ///< made, but the trace does not tell what they said
};

/// What was reported in a trial, from its recorded quantities (modules/exercises/palpation/simulation/palpation_quantities.h): a report each
/// time `report_count` rises, in pauses too. Nothing where the trace has no such quantities. A report that makes no sense (a field
/// or finding that there is not) counts as lost.
std::optional<ReportsOfTrial> reportsOf(const TrialTrace& trial);

/// The book after the reports until `until_s` (included).
simulation::FindingsBook findingsAfter(std::span<const TimedReport> reports,
                                 double until_s = std::numeric_limits<double>::infinity());

} // namespace chiron::scoring
