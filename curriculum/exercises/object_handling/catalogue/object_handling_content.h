// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

namespace chiron::catalogue {

/// simulation::ObjectHandlingParameters from content/schema/object_handling_parameters.json's keys (mm, g there, m, kg here).
ExerciseParameters readObjectHandling(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// What no single key's range can say: low ≤ high; objects that have weight, can be held within the squeeze limit, fit between
/// the jaws and on the bed; steps that a tick of 1 ms carries; a heaviest object that there can be.
void checkObjectHandling(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
