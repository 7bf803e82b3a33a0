// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "haptics/passivity_controller.h"
#include "haptics/safety_guard_mask.h"
#include "haptics/safety_io.h"
#include "haptics/safety_sample_sanity.h"
#include "haptics/safety_settings.h"
#include "haptics/safety_state_machine.h"
#include "haptics/safety_tool.h"
#include "realtime/haptic_tick.h"

#include <array>
#include <span>

namespace chiron::haptics {

/// The last stage before any device, in every mode (models.md §5). Its order is: sanity (admit); then, in
/// limit(): state machine, arming gain, passivity and over-velocity damping, caps, slew, caps once more,
/// finite check. After limit() the caps always hold: first per device axis in the device's frame through
/// IToolKinematics::efforts, then for the norms of force and torque. Each wrench is scaled as a whole, so
/// that its direction is kept.
///
/// Once per tick, call admit() for every tool, then the scene, then limit(). Record the sample *as read*
/// (dropped ones too) with its age, so that a replay comes to the same verdicts. Time enters through age_us,
/// heartbeatAge_ms, the tick's index and, for the age of a packet older than the one just refused, now_ns.
/// All of these are recorded, so the same inputs give the same bits.
///
/// A device that renders no force (or whose period is too long to do so) gets zero force and is always ready;
/// its bad packets are dropped but never latch a fault. Not copyable: one supervisor guards one set of
/// devices.
/// Thread: configure() on any thread before the loop runs; the rest on the haptic thread, where it never
/// blocks or allocates.
class SafetySupervisor {
public:
    SafetySupervisor() = default;
    SafetySupervisor(const SafetySupervisor&) = delete;
    SafetySupervisor& operator=(const SafetySupervisor&) = delete;

    /// Configures the supervisor, which then starts at `off` with no packet seen. Not for the tick.
    /// Errors: badInput for no or too many tools, settings out of range, a device without period or axes, or
    /// a workspace scale that is not positive.
    core::Result<void> configure(const SafetySettings& settings, std::span<const SafetyTool> tools);

    /// Runs the sanity stage of one tool, before the scene. pose_D = kinematics.pose(sample). See
    /// SafetySampleSanity::admit. Unless the result is `fresh`, keep the last good state. 0 <= tool < the
    /// configured count.
    Admission admit(const realtime::HapticTick& now, int tool, const core::DeviceSample& sample,
                    const core::ToolState& pose_D, std::uint32_t age_us) noexcept;

    /// Runs all other stages, after the scene. Fills `out` completely.
    void limit(const realtime::HapticTick& now, const SafetyInput& in, SafetyOutput& out) noexcept;

    const SafetySettings& settings() const noexcept { return m_settings; }
    bool rendersForce(int tool) const noexcept; ///< whether this tool may ever get force
    bool anyRendersForce() const noexcept;
    /// Returns the total damping that this tool may get, in W: b_max of its device over the workspace's
    /// scale; unbounded if the tool renders no force.
    double dampingBudget_Ns_per_m(int tool) const noexcept;

    /// Tests only: switches rows of the table off. Call before configure().
    void setGuardMaskForTests(GuardMask mask) noexcept { m_mask = mask; }

private:
    using Wrenches = PassivityController::Wrenches;

    Wrenches requestedWrenches(const SafetyInput& in) noexcept;
    SafetyConditions observe(const SafetyInput& in, const Wrenches& requested) noexcept;
    void observeSample(std::size_t tool, SafetyConditions& conditions) noexcept;
    void observeMotion(const SafetyInput& in, const Wrenches& requested, std::size_t tool,
                       SafetyConditions& conditions) const noexcept;
    PassivityBodies bodiesOf(const SafetyInput& in, const Wrenches& requested) const noexcept;
    void fillContact(const SafetyInput& in, const Wrenches& requested, std::size_t body,
                     PassivityContact& contact) const noexcept;
    void applyPassivity(const SafetyInput& in, const Wrenches& requested, Wrenches& wrenches) noexcept;
    void applyOverVelocityDamping(const SafetyInput& in, Wrenches& wrenches) const noexcept;
    void applyCapsAndSlew(const SafetyInput& in, Wrenches& wrenches) noexcept;
    void applyFiniteCheck(Wrenches& wrenches) noexcept;
    Wrenches withCompensation(const SafetyInput& in, const Wrenches& wrenches) noexcept;
    void forgetReferences(bool inputOnly) noexcept;
    core::DisplayPose displayOf(const SafetyInput& in, std::size_t tool, const SafeTool& safe) noexcept;
    void publish(const SafetyInput& in, const Wrenches& wrenches, const Wrenches& whole,
                 SafetyOutput& out) noexcept;

    SafetySettings m_settings;
    GuardMask m_mask;
    int m_count = 0;
    std::array<SafetyToolLimits, core::kMaxTools> m_limits{};
    std::array<SafetySampleSanity, core::kMaxTools> m_sanity{};
    SafetyStateMachine m_machine;
    PassivityController m_passivity;
    Wrenches m_last{}; ///< commanded in the previous tick
    std::array<core::DisplayPose, core::kMaxTools> m_lastDisplay{};
    double m_lastGain = 0.0;
    std::uint32_t m_guards = 0;  ///< collected while limit() runs
    bool m_requestFinite = true; ///< of this tick
    bool m_answerFinite = true;  ///< of the previous tick: latched as a fault in this one
};

} // namespace chiron::haptics
