// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "modules/exercises/object_handling/simulation/handling_world.h"

#include <cstdint>

namespace chiron::simulation {

/// Progress of a trial. The task is to take hold of an object, lift it by `liftHeight_m`, carry it over the
/// target, set it down there, let go, and let it lie at rest for `hold_s`. An object counts only if it has
/// been lifted that high since it was last grasped; one that was pushed into the target has to be lifted
/// again. In a weigh task any object that is laid into the target in this way ends the trial, and the choice
/// of the object is the answer.
/// Thread: haptic.
class HandlingProgress {
public:
    /// A body slower than this is at rest, m/s (assumption: below models.md §6's 5 mm/s, at which movement
    /// starts).
    static constexpr double kRest_m_per_s = 0.002;

    explicit HandlingProgress(const ObjectHandlingParameters& parameters) noexcept;

    void begin(const ObjectHandlingTrial& trial) noexcept;
    /// Call after each step of the world. `clockRuns`: the trial runs and is not paused; otherwise only
    /// step() is updated.
    void follow(const HandlingWorld& world, bool clockRuns) noexcept;

    core::LaparoscopyStep step() const noexcept { return m_step; }
    double dwell() const noexcept; ///< 0..1, share of hold_s
    bool done() const noexcept { return m_step == core::LaparoscopyStep::done; }

private:
    bool isOverTarget(const LooseBody& body) const noexcept;
    bool liesInTarget(const HandlingWorld& world, std::size_t i) const noexcept;

    ObjectHandlingParameters m_parameters;
    core::Vec2 m_target_m = core::Vec2::Zero();
    core::LaparoscopyStep m_step = core::LaparoscopyStep::grasp;
    std::array<bool, HandlingWorld::kMaxBodies> m_lifted{};
    int m_heldBefore = HandlingWorld::kNone;
    std::uint64_t m_dwellTicks = 0;
    std::uint64_t m_holdTicks;
};

} // namespace chiron::simulation
