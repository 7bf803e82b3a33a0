// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "modules/exercises/urethra_insertion/simulation/meatus_gate.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace chiron::simulation {

/// The requirements of a trial of an endoscopic procedure. Plain data with fixed storage, because the tick
/// copies it.
/// Unit: m for lengths.
/// Frame: A.
struct ProcedurePlan {
    static constexpr std::size_t kMaxLandmarks = 16;

    double beak_m = 0.010; ///< ℓ: the tip is inside from s > −ℓ on
    /// Greatest distance from the centre-line at which it enters there (MeatusGate); 0: anywhere.
    double meatus_m = 0.0;
    double goal_m = 0.0; ///< arc length of the tip that ends the insertion
    double neck_m = 0.0; ///< L: landmarks are seen only with the tip beyond it, where nothing lies between
    bool withdraws = true;
    std::array<std::array<double, 3>, kMaxLandmarks> landmark_A{}; ///< on the bladder's wall
    std::size_t landmarks = 0;
    double cosHalfAngle = 1.0;       ///< of the cone about the centre of the view
    double distance_m = 0.0;         ///< a landmark has to be nearer than this
    double speed_m_per_s = 0.0;      ///< and the tip no faster than this
    std::uint64_t hold_us = 1000000; ///< for this long without a break
};

/// Position of the endoscope, in A. `axis_A` is the unit vector along which it looks.
struct ProcedureSample {
    double s_m = 0.0; ///< arc length of the tip's foot on the centre-line
    core::Vec3 p_A = core::Vec3::Zero();
    core::Vec3 axis_A = core::Vec3::UnitZ();
    double offset_m = 0.0; ///< distance of the tip from the centre-line
};

/// Changes that one sample caused.
struct ProcedureStep {
    bool stageChanged = false;
    std::uint32_t seenNow = 0; ///< landmarks that became seen, one bit each
};

/// Follows an endoscopic procedure from poses alone (models.md §1.3). The scene advances it in every running
/// tick, and review advances it over the stored poses, so that stage and landmarks can always be recomputed.
///
/// Stages only go forward: *outside* until s > −ℓ; *insertion* until s ≥ goal; *inspection* (if there are
/// landmarks) until all are seen; *withdrawal* (if required) until s < −ℓ; *completed*. A tip farther than
/// kCanalReach_m from the centre-line neither enters nor reaches the goal, because it is beside the
/// canal, and so is one that did not come through the meatus. The withdrawal may end at any distance from the
/// centre-line: past the entrance the canal hangs free and follows the shaft, and beside it nothing is in the
/// patient.
///
/// A landmark counts as seen when, in inspection and with the tip beyond the neck, it stayed within the half
/// angle of the centre of the view and nearer than the distance, with the tip no faster than the limit, for
/// the holding time without a break. Landmarks count in any order. Speed is ‖p(t) − p(t₀)‖/(t − t₀), where t₀
/// is the newest stored sample at least 100 ms old (the first one before that). It is a mean over one period
/// of a hand's tremor of 8–12 Hz, whose 0.1 mm would read 6 mm/s from tick to tick. Time excludes pauses.
/// Deterministic.
///
/// Thread: haptic or any; allocates nothing.
class ProcedureTracker {
public:
    static constexpr std::uint64_t kSpeedWindow_us = 100000;

    explicit ProcedureTracker(const ProcedurePlan& plan) noexcept
        : m_plan(plan), m_gate(plan.meatus_m, plan.beak_m) {}

    /// `dt_us` is the time since the last sample without pauses; that of the first sample is ignored. A pose
    /// that is not finite is skipped.
    ProcedureStep advance(const ProcedureSample& now, std::uint64_t dt_us) noexcept;

    simulation::ProcedureStage stage() const noexcept { return m_stage; }
    std::uint32_t seen() const noexcept { return m_seen; }
    /// The first landmark in the plan's order that has not been seen; −1 when none is left or the stage is
    /// not inspection.
    int nextLandmark() const noexcept;
    /// 0..1: share of the holding time that has passed for the unseen landmark that is nearest to being seen.
    double dwell() const noexcept;
    double speed_m_per_s() const noexcept { return m_speed_m_per_s; }
    const ProcedurePlan& plan() const noexcept { return m_plan; }

private:
    struct Place {
        std::uint64_t t_us = 0;
        std::array<double, 3> p{};
    };
    // A power of two that exceeds the window at one position per millisecond
    static constexpr std::size_t kPlaces = 128;
    static constexpr std::uint64_t kPlaceEvery_us = 1000;

    void measureSpeed(const core::Vec3& p_A) noexcept;
    std::uint32_t look(const ProcedureSample& now, std::uint64_t dt_us) noexcept;
    bool inView(const ProcedureSample& now, std::size_t landmark) const noexcept;
    simulation::ProcedureStage after(simulation::ProcedureStage stage,
                                     const ProcedureSample& now) const noexcept;
    const Place& place(std::uint64_t number) const noexcept { return m_places[number % kPlaces]; }

    ProcedurePlan m_plan;
    MeatusGate m_gate;
    simulation::ProcedureStage m_stage = simulation::ProcedureStage::outside;
    std::uint32_t m_seen = 0;
    std::array<std::uint64_t, ProcedurePlan::kMaxLandmarks> m_held_us{};
    bool m_began = false;
    std::uint64_t m_now_us = 0;
    double m_speed_m_per_s = 0.0;
    std::array<Place, kPlaces> m_places{};
    std::uint64_t m_first = 0; ///< number of the oldest position that is still needed
    std::uint64_t m_count = 0; ///< number of positions stored so far
};

} // namespace chiron::simulation
