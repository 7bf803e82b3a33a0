// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

#include <QByteArray>

namespace chiron::catalogue {

/// Returns content/schema/palpation_parameters.json, made of the rows from which the parameters are read.
QByteArray palpationSchema();

/// Reads simulation::PalpationParameters from the keys of content/schema/palpation_parameters.json.
/// Unit: mm in the JSON; m in the result.
ExerciseParameters readPalpation(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// Checks what the range of a single key cannot express: low ≤ high; catch trials as well as others; lumps
/// for which the law of models.md §3 is valid and that fit into regions of their own; a tissue whose nearest
/// surface point is unique down to the depth that the force cap allows a finger; at most four fingers; and a
/// move of the lumps that keeps them in the area.
void checkPalpation(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
