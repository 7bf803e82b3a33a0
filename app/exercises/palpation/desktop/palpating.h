// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

namespace chiron::desktop {

/// The parameters of a palpation; null for levels of another exercise. Points into `level`.
inline const simulation::PalpationParameters* palpationOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.find<simulation::PalpationParameters>();
}

} // namespace chiron::desktop
