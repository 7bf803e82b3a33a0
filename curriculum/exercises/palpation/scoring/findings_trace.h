// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/palpation/cues/findings_book.h"
#include "scoring/trace.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// One report as it is recorded.
struct TimedReport {
    double t_s = 0.0; ///< time of the trace
    simulation::ReportField field = simulation::ReportField::found;
    int finding = simulation::FindingsBook::kNone; ///< the finding that it is about
    unsigned value = 0;                            ///< as encoded in the report word
    core::Vec3 place_W = core::Vec3::Zero();       ///< of the finding, on the surface, m
};

struct ReportsOfTrial {
    std::vector<TimedReport> reports; ///< in the order in which they were made
    int lost = 0;                     ///< reports that were made but whose content the trace does not record
};

/// Reads what was reported in a trial from its recorded quantities
/// (modules/exercises/palpation/simulation/palpation_quantities.h): one report each time `report_count`
/// rises, also in pauses. Returns none if the trace has no such quantities. A report that makes no sense (an
/// unknown field or finding) counts as lost.
std::optional<ReportsOfTrial> reportsOf(const TrialTrace& trial);

/// Returns the list of findings after all reports up to and including `until_s`.
simulation::FindingsBook findingsAfter(std::span<const TimedReport> reports,
                                       double until_s = std::numeric_limits<double>::infinity());

} // namespace chiron::scoring
