// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

#include <QByteArray>

namespace chiron::catalogue {

/// Returns content/schema/object_handling_parameters.json, made of the rows from which the parameters are
/// read.
QByteArray objectHandlingSchema();

/// Reads simulation::ObjectHandlingParameters from the keys of
/// content/schema/object_handling_parameters.json.
/// Unit: mm and g in the JSON; m and kg in the result.
ExerciseParameters readObjectHandling(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// Checks what the range of a single key cannot express: low ≤ high; objects that have weight, can be held
/// within the squeeze limit, and fit between the jaws and on the bed; dynamics that are stable with a tick of
/// 1 ms; and a heaviest object that can exist.
void checkObjectHandling(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
