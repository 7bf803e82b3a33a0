// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "session/level_limits.h"

namespace chiron::desktop {

/// What a screen asks of a level that is done with graspers.
struct Grasping {
    const simulation::ElasticTubeParameters* tube = nullptr;
    const simulation::ObjectHandlingParameters* handling = nullptr;
    session::LevelLimits limits{}; ///< of the level

    explicit operator bool() const { return tube != nullptr || handling != nullptr; }
    int tools() const { return tube ? tube->tools() : handling ? handling->tools() : 1; }
};

/// Empty where the level is done with something else. Points into `level`.
inline Grasping graspingOf(const catalogue::ExerciseLevel& level) {
    return {std::get_if<simulation::ElasticTubeParameters>(&level.parameters),
            std::get_if<simulation::ObjectHandlingParameters>(&level.parameters), session::levelLimits(level)};
}

} // namespace chiron::desktop
