// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

namespace chiron::desktop {

/// A palpation's own parameters; null for levels of another kind. Points into `level`.
inline const simulation::PalpationParameters* palpationOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.find<simulation::PalpationParameters>();
}

} // namespace chiron::desktop
