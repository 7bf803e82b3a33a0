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
    std::string level;         ///< "exercise/number id"
    bool conservative = false; ///< the scene says that its law has a potential
    bool measured = false;     ///< somebody wrote SweepFacts for this exercise
    bool givesWay = true;      ///< the level's content has to say at which force its tissue gives way
    bool yieldStated = false;  ///< and it does
    double yieldForce_N = std::numeric_limits<double>::infinity(); ///< that force
    double yieldTorque_Nm = 0.0; ///< and the torque; 0: nothing of the level turns the tool
    double limit_N = 0.0;        ///< the level's limit
    double limit_Nm = 0.0;       ///< and of torque
    std::uint64_t ticks = 0, touching = 0, beyondChecked = 0, yields = 0;
    bool finite = true;
    Worst force;  ///< N, of one tool
    Worst torque; ///< N·m
    /// N in one tick, over what the way and the change of speed allow there (Sweep::allowed_N); yield events
    /// left out. At most 0.1 is asked for.
    Worst change;
    Worst fall; ///< the same during a yield event, over what its curve allows too
    /// N·m in one tick, over what the tissue's turning back allows: k_φ times the turn and what the way turns
    /// it by, as much more as the axes of P1's torque lean over (1/cos² of 30°), and the force's bound at the
    /// radius of the shaft. At most 1 mN·m is asked for.
    Worst torqueChange;
    Worst torqueFall; ///< the same during a yield event, over what its curve allows too
    /// N, where nothing may act by true distances (true_contact.h), which are not asked for with a guard;
    /// what has given way falls by its curve and is left out.
    Worst inAir;
    Worst inAirAsTold; ///< N, where the scene itself says that nothing is stored and nothing is stiff
    /// J that one contact gave more than it took, by the trapezoid rule over forces and torques of all tools:
    /// what the law makes, without a controller.
    Worst made;
    std::uint64_t closed = 0; ///< contacts whose books closed: from nothing stored and still to the same

    // With SweepSettings::guarded: the same path behind the supervisor, on a device that pushes the hand.
    std::uint64_t damped = 0; ///< ticks in which the passivity controller damped, or rendered softer
    double withheld_J = 0.0;  ///< PassivityController::withheld_J(), of all scenes
    Worst commanded;          ///< N
    double cap_N = 0.0;       ///< that the supervisor keeps
    Worst returned;     ///< J that a contact gave the hand beyond what the hand had put into it, at any time
    Worst brought;      ///< J, the most that one tick has brought without anybody's work
    Worst overReturned; ///< J, over what the controller allows (GuardedContact::over_J)

    std::string line() const;        ///< for people
    std::string guardedLine() const; ///< for people, of the supervisor's numbers
    static std::string heading();
    static std::string guardedHeading();
};

struct SweepSettings {
    std::uint64_t seed = 1;
    int paths = 200;
    int firstPath = 0; ///< a multiple of pathsPerScene
    double path_s = 3.0;
    int pathsPerScene = 10;    ///< every second scene is begun in the air, the others wherever the mechanism
                               ///< reaches: in tissue, under the table
    bool onlyInTheAir = false; ///< every scene is begun in the air
    /// Also through a supervisor, whose device lends the laws its damping budget.
    bool guarded = false;
    /// What the scene answered in each tick, if somebody wants to see it; `tick` counts within the path.
    std::function<void(std::uint64_t path, std::uint64_t tick, const simulation::SceneOutput& answered)>
        witness;
};

/// Drives the level's scene itself, as fast as it goes, without loop or device; the motion is prescribed, so
/// that no supervisor changes it. Every tool of the level takes a path of its own. A study's level is
/// presented one pair of objects after the other.
SweepResult sweepLevel(const catalogue::ExerciseLevel& level, const SweepSettings& settings);

} // namespace chiron::tests
