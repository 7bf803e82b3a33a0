// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "core/tool_state.h"
#include "haptics/safety_io.h"
#include "haptics/safety_settings.h"
#include "realtime/haptic_tick.h"

#include <cstdint>

namespace chiron::haptics {

/// The sanity stage of one tool (models.md §5, "sample sanity"). It decides whether a sample may be used and
/// keeps the age of the newest good one. Trivially copyable; it has no clock of its own.
class SafetySampleSanity {
public:
    /// Forgets everything: the next finite packet with a unit quaternion becomes the reference. period_us ≥
    /// 1.
    void reset(const SafetySettings& settings, std::uint32_t period_us, bool guarded) noexcept;

    /// Checks a sample. `pose_D` is kinematics.pose(sample); `age_us` is now - arrival of that sample in
    /// whole microseconds. A packet is new if its number, counts, jaw, buttons, device time or status differ
    /// from those of the previous one (the arrival time does not count, because a replay does not have it). A
    /// jump may be jump_m for each period that has passed, by the packet numbers and by executed ticks alike,
    /// so that a lost packet does not make the next one bad. A driver that has no packet yet sets
    /// sample_status::kInvalid, so that its empty sample does not become the reference.
    Admission admit(const realtime::HapticTick& now, const core::DeviceSample& sample,
                    const core::ToolState& pose_D, std::uint32_t age_us) noexcept;

    /// For use after a fault was re-armed: the next sane packet becomes the reference, whatever its number
    /// and position.
    void forgetReference() noexcept;

    bool hasGood() const noexcept { return m_hasGood; }
    /// True if a good packet has come since the last forgetReference().
    bool hasReference() const noexcept { return m_hasReference; }
    bool droppedThisTick() const noexcept { return m_dropped; }
    std::uint32_t badInARow() const noexcept { return m_bad; }
    /// Age of the newest good packet, at the last admit().
    std::uint32_t age_us() const noexcept { return m_age_us; }
    const core::DeviceSample& good() const noexcept { return m_good; }
    /// The newest packet, good or not: its stop button counts.
    const core::DeviceSample& seen() const noexcept { return m_seen; }

private:
    bool isSane(const realtime::HapticTick& now, const core::DeviceSample& sample,
                const core::ToolState& pose_D) const noexcept;
    std::uint32_t goodAge(const realtime::HapticTick& now) const noexcept;

    core::DeviceSample m_good;
    core::DeviceSample m_seen;
    double m_goodPosition_m[3] = {0.0, 0.0, 0.0};
    double m_jump_m = 0.0;
    double m_quaternionTolerance = 0.0;
    std::uint64_t m_goodTick = 0;
    std::int64_t m_goodArrival_us = 0; ///< in the clock of now_ns
    std::uint32_t m_period_us = 1000;
    std::uint32_t m_bad = 0;
    std::uint32_t m_age_us = 0;
    bool m_guarded = true;
    bool m_hasSeen = false;
    bool m_hasGood = false;
    bool m_hasReference = false;
    bool m_seenWasGood = false;
    bool m_dropped = false;
};

} // namespace chiron::haptics
