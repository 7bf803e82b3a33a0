// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

namespace chiron::desktop {

/// The parameters of a level that is done with an endoscope; null for other levels.
inline const simulation::UrethraInsertionParameters* endoscopyOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.find<simulation::UrethraInsertionParameters>();
}

} // namespace chiron::desktop
