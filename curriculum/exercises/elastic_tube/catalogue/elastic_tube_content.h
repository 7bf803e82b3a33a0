// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

#include <QByteArray>

namespace chiron::catalogue {

/// Returns content/schema/elastic_tube_parameters.json, made of the rows from which the parameters are read.
QByteArray elasticTubeSchema();

/// Reads simulation::ElasticTubeParameters from the keys of content/schema/elastic_tube_parameters.json.
/// Unit: mm and degrees in the JSON; SI in the result.
ExerciseParameters readElasticTube(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// Checks what the range of a single key cannot express: the tension band is above zero and is reached before
/// the tube is damaged, the mark is below the tear, the jaw opens wider to release than to hold, the target
/// is within reach, and a sampled loop can render the tube stably.
void checkElasticTube(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
