// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/elastic_tube/scoring/tube_truth.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::session {

/// The truth of every trial of a session, planned again from content and seed: what scores, reports and
/// playback know of a trial. Pure function.
std::vector<scoring::TubeTruth> plannedTubes(const simulation::ElasticTubeParameters& level,
                                             std::uint64_t seed);

} // namespace chiron::session
