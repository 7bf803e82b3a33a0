// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

namespace chiron::catalogue {

/// simulation::ElasticTubeParameters from content/schema/elastic_tube_parameters.json's keys (mm and degrees there, SI here).
ExerciseParameters readElasticTube(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// What no single key's range can say: a band above zero that is reached before the tube is damaged, a mark below the tear,
/// a jaw that lets go wider than it holds, a target within reach, and a tube that a sampled loop can carry.
void checkElasticTube(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
