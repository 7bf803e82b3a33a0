// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "cues/laparoscopy_cues.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <cstdint>
#include <limits>

namespace chiron::simulation {

/// The goal of one trial.
/// Unit: SI.
struct TubeGoal {
    TubeTask task = TubeTask::hold;
    /// hold, twoHanded: the tension has to be within ± band_N of it.
    double target_N = 0.0;
    double band_N = 0.0;
    /// stretch: the stretch has to be within ± markTolerance_m of it.
    double mark_m = 0.0;
    double markTolerance_m = 0.0;
    /// transfer: the free end has to be within targetRadius_m of it.
    core::Vec3 target_W = core::Vec3::Zero();
    double targetRadius_m = 0.0;
    /// Beyond this stretch the tube is damaged; counted again only after it fell below 80 % of it.
    double overStretch_m = 0.0;
    double tear_m = 0.0;                                     ///< the tube is torn beyond this stretch ...
    double tear_N = std::numeric_limits<double>::infinity(); ///< ... or beyond this tension
    std::uint64_t hold_ticks = 0;
    bool fold = false; ///< tissue lies over the tube at first
};

/// State of the tube and its hands in one tick.
struct TubeTaskSample {
    double tension_N = 0.0;
    double stretch_m = 0.0;
    core::Vec3 freeEnd_W = core::Vec3::Zero();
    int held = 0;            ///< number of places that are held
    bool rightHolds = false; ///< tool 0
    bool leftHolds = false;  ///< tool 1
    bool open = true;        ///< nothing lies over the tube
};

/// Progress of one trial. The steps are:
///   hold, stretch, twoHanded: grasp → stretch → hold → done
///   transfer: grasp → handOver → carry → hold → done
/// - grasp ends when the tube is held as the task needs it: by one hand, by both ends (twoHanded), or by the
///   right hand (transfer).
/// - handOver ends when the left hand holds the tube and the right one does not.
/// - hold begins when the goal is first met and lasts `hold_ticks`, whether the goal is met or not, because
///   scoring judges how well it was held. It ends in done at the first tick after that in which the goal is
///   met. Missing the goal for longer than 0.5 s without a break returns to stretch or carry.
/// - A tube that is no longer held as the task needs has been dropped, and the trial returns to grasp.
/// - Where a fold lies over the tube, the step is retract instead of grasp as long as the fold is not held
///   back, and the goal is met only while it is held back.
///
/// Deterministic.
/// Thread: haptic.
class TubeTaskTracker {
public:
    /// Longer than a reaction (180 ms) and its correction: our choice.
    static constexpr std::uint64_t kBreak_ticks = 500;
    static constexpr double kRearmShare = 0.8; ///< models.md §6

    void begin(const TubeGoal& goal) noexcept;

    struct Change {
        bool moved = false; ///< to another step
        bool dropped = false;
        bool damaged = false; ///< over-stretched anew
        bool torn = false;
        bool completed = false;
    };
    /// Advances by one running tick. Nothing changes any more after done or torn.
    Change advance(const TubeTaskSample& now) noexcept;

    core::LaparoscopyStep step() const noexcept { return m_step; }
    double dwell() const noexcept; ///< 0..1, share of the holding time
    bool torn() const noexcept { return m_torn; }
    const TubeGoal& goal() const noexcept { return m_goal; }

private:
    bool begins() const noexcept {
        return m_step == core::LaparoscopyStep::grasp || m_step == core::LaparoscopyStep::retract;
    }
    bool heldAsNeeded(const TubeTaskSample& now) const noexcept;
    bool inGoal(const TubeTaskSample& now) const noexcept;
    core::LaparoscopyStep next(const TubeTaskSample& now) noexcept;

    TubeGoal m_goal;
    core::LaparoscopyStep m_step = core::LaparoscopyStep::none;
    std::uint64_t m_held_ticks = 0;
    std::uint64_t m_out_ticks = 0;
    bool m_armed = true; ///< has been below 80 % since the last over-stretch
    bool m_torn = false;
};

} // namespace chiron::simulation
