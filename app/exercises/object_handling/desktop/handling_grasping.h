// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/grasping.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

namespace chiron::desktop {

/// What the training screen asks of a level with objects. Pure.
Grasping handlingGrasping(const simulation::ObjectHandlingParameters& level, const session::LevelLimits& limits);

} // namespace chiron::desktop
