// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/laparoscopy_cues.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <cstdint>
#include <limits>

namespace chiron::simulation {

/// What one trial asks for. SI.
struct TubeGoal {
    TubeTask task = TubeTask::hold;
    double target_N = 0.0;                    ///< hold, twoHanded: tension within ± band_N of it
    double band_N = 0.0;
    double mark_m = 0.0;                      ///< stretch: within ± markTolerance_m of it
    double markTolerance_m = 0.0;
    core::Vec3 target_W = core::Vec3::Zero(); ///< transfer: the free end within targetRadius_m of it
    double targetRadius_m = 0.0;
    double overStretch_m = 0.0;               ///< damaged beyond this stretch, counted again only from below 80 % of it
    double tear_m = 0.0;                      ///< torn beyond this one ...
    double tear_N = std::numeric_limits<double>::infinity(); ///< ... or beyond this tension
    std::uint64_t hold_ticks = 0;
    bool fold = false; ///< tissue lies over it at first
};

/// The tube and its hands at one tick.
struct TubeTaskSample {
    double tension_N = 0.0;
    double stretch_m = 0.0;
    core::Vec3 freeEnd_W = core::Vec3::Zero();
    int held = 0;           ///< places that are held
    bool rightHolds = false; ///< tool 0
    bool leftHolds = false;  ///< tool 1
    bool open = true;        ///< nothing lies over the tube
};

/// Where a trial stands. The steps:
///   hold, stretch, twoHanded: grasp → stretch → hold → done;  transfer: grasp → handOver → carry → hold → done
/// - grasp ends when the tube is held as the task needs it: by one hand, by both ends (twoHanded), by the right hand (transfer).
/// - handOver ends when the left hand holds it and the right one does not.
/// - hold begins when the goal is first met and lasts `hold_ticks`, in the goal or not: how well it was held is scored. It ends in
///   done at the first tick from then on that is in the goal. Out of the goal for longer than 0.5 s in one go breaks it: back
///   to stretch or carry.
/// - A tube that is no longer held as the task needs is dropped: back to grasp.
/// - Where a fold lies over the tube, grasp is retract as long as it is not held back, and the goal is met only while it is.
/// Deterministic. Thread: haptic.
class TubeTaskTracker {
public:
    static constexpr std::uint64_t kBreak_ticks = 500; ///< longer than a reaction (180 ms) and its correction: ours
    static constexpr double kRearmShare = 0.8;         ///< models.md §6

    void begin(const TubeGoal& goal) noexcept;

    struct Change {
        bool moved = false;     ///< to another step
        bool dropped = false;
        bool damaged = false;   ///< over-stretched once more
        bool torn = false;
        bool completed = false;
    };
    /// One running tick. Nothing moves any more after done or torn.
    Change advance(const TubeTaskSample& now) noexcept;

    core::LaparoscopyStep step() const noexcept { return m_step; }
    double dwell() const noexcept; ///< 0..1 of the hold
    bool torn() const noexcept { return m_torn; }
    const TubeGoal& goal() const noexcept { return m_goal; }

private:
    bool begins() const noexcept { return m_step == core::LaparoscopyStep::grasp || m_step == core::LaparoscopyStep::retract; }
    bool heldAsNeeded(const TubeTaskSample& now) const noexcept;
    bool inGoal(const TubeTaskSample& now) const noexcept;
    core::LaparoscopyStep next(const TubeTaskSample& now) noexcept;

    TubeGoal m_goal;
    core::LaparoscopyStep m_step = core::LaparoscopyStep::none;
    std::uint64_t m_held_ticks = 0;
    std::uint64_t m_out_ticks = 0;
    bool m_armed = true; ///< below 80 % since the last over-stretch
    bool m_torn = false;
};

} // namespace chiron::simulation
