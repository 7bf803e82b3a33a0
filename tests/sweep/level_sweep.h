// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "core/geometry.h"
#include "simulation/scene.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace chiron::tests {

/// The largest of something, and where it was.
struct Worst {
    double value = -std::numeric_limits<double>::infinity();
    std::uint64_t path = 0;
    std::uint64_t tick = 0;
    std::size_t tool = 0;
    core::Vec3 p_W = core::Vec3::Zero();
};

/// What a tool met that was pushed, dragged and lifted through one level, over all that its mechanism
/// reaches.
struct SweepResult {
    std::string level;        ///< "exercise/number id"
    bool yieldStated = false; ///< the level's content says at which force its tissue gives way
    double yieldForce_N = std::numeric_limits<double>::infinity(); ///< that force
    double yieldTorque_Nm = 0.0; ///< and the torque; 0: nothing of the level turns the tool
    double limit_N = 0.0;        ///< the level's limit
    double limit_Nm = 0.0;       ///< and of torque
    std::uint64_t ticks = 0, touching = 0, beyondChecked = 0, yields = 0;
    bool finite = true;
    Worst force;  ///< N, of one tool
    Worst torque; ///< N·m
    /// N in one tick, over what the stiffness there times the way allows; yield events left out. At most 0.1
    /// is asked for. Stiffness: what the scene says, friction's bristle, and b v / 0.5 mm of damping that
    /// fades in; the way: between tool and object, which of a tube is the way between the hands that hold it.
    Worst change;
    Worst fall; ///< the same during a yield event, over what its curve allows too
    /// N·m in one tick, over what the tissue's turning back allows: k_φ times the turn and what the way turns
    /// it by, as much more as the axes of P1's torque lean over (1/cos² of 30°), and the force's bound at the
    /// radius of the shaft. At most 1 mN·m is asked for.
    Worst torqueChange;
    Worst torqueFall; ///< the same during a yield event, over what its curve allows too
    Worst inAir;      ///< N, where nothing is stored and nothing is stiff
    Worst made;       ///< J that one contact gave more than it took, by the trapezoid rule: what a law makes,
                      ///< without a controller
    std::string line() const; ///< for people
    static std::string heading();
};

struct SweepSettings {
    std::uint64_t seed = 1;
    int paths = 200;
    int firstPath = 0; ///< a multiple of pathsPerScene
    double path_s = 3.0;
    int pathsPerScene = 10;    ///< every second scene is begun in the air, the others wherever the mechanism
                               ///< reaches: in tissue, under the table
    bool onlyInTheAir = false; ///< every scene is begun in the air
    /// What the scene answered in each tick, if somebody wants to see it; `tick` counts within the path.
    std::function<void(std::uint64_t path, std::uint64_t tick, const simulation::SceneOutput& answered)>
        witness;
};

/// Drives the level's scene itself, as fast as it goes, without loop, supervisor or device. Every tool of the
/// level takes a path of its own.
SweepResult sweepLevel(const catalogue::ExerciseLevel& level, const SweepSettings& settings);

} // namespace chiron::tests
