// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

namespace chiron::desktop {

/// What a screen asks of a level that is done with graspers.
struct Grasping {
    const simulation::ElasticTubeParameters* tube = nullptr;
    const simulation::ObjectHandlingParameters* handling = nullptr;

    explicit operator bool() const { return tube != nullptr || handling != nullptr; }
    int tools() const { return tube ? tube->tools() : handling ? handling->tools() : 1; }
    double forceLimit_N() const { return tube ? tube->maximumForce_N : handling ? handling->maximumForce_N : 0.0; }
};

/// Empty where the level is done with something else. Points into `level`.
inline Grasping graspingOf(const catalogue::ExerciseLevel& level) {
    return {std::get_if<simulation::ElasticTubeParameters>(&level.parameters),
            std::get_if<simulation::ObjectHandlingParameters>(&level.parameters)};
}

} // namespace chiron::desktop
