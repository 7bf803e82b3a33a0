// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/grasping.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

namespace chiron::desktop {

/// The parameters that the training screen needs for a level with objects. Pure function.
Grasping handlingGrasping(const simulation::ObjectHandlingParameters& level,
                          const session::LevelLimits& limits);

} // namespace chiron::desktop
