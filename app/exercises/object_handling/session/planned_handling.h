// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/object_handling/scoring/handling_truth.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::session {

/// The truth of every trial of a session, planned again from content and seed: what scores, reports and
/// playback know of a trial. Everything that is always planned is set. Pure function.
std::vector<scoring::HandlingTruth> plannedHandling(const simulation::ObjectHandlingParameters& level,
                                                    std::uint64_t seed);

} // namespace chiron::session
