// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/grasping.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

namespace chiron::desktop {

/// What the training screen asks of a level with a tube. Pure.
Grasping tubeGrasping(const simulation::ElasticTubeParameters& level, const session::LevelLimits& limits);

} // namespace chiron::desktop
