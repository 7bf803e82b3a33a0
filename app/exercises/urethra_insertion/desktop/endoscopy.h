// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

namespace chiron::desktop {

/// The level's parameters where it is done with an endoscope; null where it is not.
inline const simulation::UrethraInsertionParameters* endoscopyOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.find<simulation::UrethraInsertionParameters>();
}

} // namespace chiron::desktop
