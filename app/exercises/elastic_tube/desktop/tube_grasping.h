// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/grasping.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

namespace chiron::desktop {

/// The parameters that the training screen needs for a level with a tube. Pure function.
Grasping tubeGrasping(const simulation::ElasticTubeParameters& level, const session::LevelLimits& limits);

} // namespace chiron::desktop
