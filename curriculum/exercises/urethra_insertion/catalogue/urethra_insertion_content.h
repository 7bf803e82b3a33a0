// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

namespace chiron::catalogue {

/// simulation::UrethraInsertionParameters from content/schema/urethra_insertion_parameters.json's keys (mm, degrees and Fr there, SI here).
ExerciseParameters readUrethraInsertion(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// What no single key's range can say: a canal that does not run into itself, changes that lie in it, a bladder the endoscope
/// fits into, goals that can be reached, landmarks that can be seen.
void checkUrethraInsertion(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
