// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety_supervisor.h"

#include "haptics/finite_wrench.h"
#include "haptics/safety_caps.h"
#include "haptics/safety_slew.h"
#include "haptics/safety_watchdog.h"

#include <algorithm>
#include <cmath>

namespace chiron::haptics {

namespace guard_bits = core::guard_bits;

namespace {

/// A larger request is scaled down before any norm is taken, so that squares cannot overflow. Far above any
/// cap.
constexpr double kHuge = 1e6;

double largest(const core::Wrench& w) noexcept {
    return std::max(w.force.cwiseAbs().maxCoeff(), w.torque.cwiseAbs().maxCoeff());
}

} // namespace

bool SafetySupervisor::rendersForce(int tool) const noexcept {
    return tool >= 0 && tool < m_count && m_limits[static_cast<std::size_t>(tool)].renders;
}

bool SafetySupervisor::anyRendersForce() const noexcept {
    return std::any_of(m_limits.begin(), m_limits.begin() + m_count,
                       [](const SafetyToolLimits& limits) { return limits.renders; });
}

double SafetySupervisor::dampingBudget_Ns_per_m(int tool) const noexcept {
    if (!rendersForce(tool))
        return simulation::kUnboundedDamping;
    const SafetyToolLimits& limits = m_limits[static_cast<std::size_t>(tool)];
    return limits.damping_Ns_per_m / limits.scale;
}

Admission SafetySupervisor::admit(const realtime::HapticTick& now, int tool, const core::DeviceSample& sample,
                                  const core::ToolState& pose_D, std::uint32_t age_us) noexcept {
    if (tool < 0 || tool >= m_count) {
        return Admission::dropped;
    }
    const auto i = static_cast<std::size_t>(tool);
    return m_sanity[i].admit(now, sample, pose_D, m_limits[i].inProcess ? 0 : age_us);
}

void SafetySupervisor::limit(const realtime::HapticTick&, const SafetyInput& in, SafetyOutput& out) noexcept {
    m_guards = 0;
    const Wrenches requested = requestedWrenches(in);
    m_machine.step(observe(in, requested));
    m_answerFinite = true;
    if (m_machine.rearmedThisStep()) {
        forgetReferences(false);
    }
    forgetReferences(true);

    const double gain = m_machine.gain();
    Wrenches wrenches{};
    if (gain > 0.0) {
        wrenches = requested;
        for (core::Wrench& w : wrenches) {
            w.force *= gain;
            w.torque *= gain;
        }
    }
    applyPassivity(in, requested, wrenches);
    applyOverVelocityDamping(in, wrenches);
    applyCapsAndSlew(in, wrenches);
    applyFiniteCheck(wrenches);
    publish(in, wrenches, withCompensation(in, wrenches), out);
    m_lastGain = gain;
}

SafetySupervisor::Wrenches SafetySupervisor::requestedWrenches(const SafetyInput& in) noexcept {
    Wrenches requested{};
    m_requestFinite = true;
    for (int tool = 0; tool < std::min(m_count, in.scene.tissue.count); ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        if (!m_limits[i].renders) {
            continue;
        }
        core::Wrench w = in.scene.tissue.tools[i];
        if (m_mask.has(GuardMask::kFinite) && !isFinite(w)) {
            m_requestFinite = false;
            continue;
        }
        // Parts that the device cannot render at all are removed; everything else is scaled, which keeps the
        // direction.
        if (m_limits[i].forceCap_N <= 0.0) {
            w.force.setZero();
        }
        if (m_limits[i].torqueCap_Nm <= 0.0) {
            w.torque.setZero();
        }
        if (const double most = largest(w); most > kHuge) {
            w.force *= kHuge / most;
            w.torque *= kHuge / most;
        }
        requested[i] = w;
    }
    return requested;
}

SafetyConditions SafetySupervisor::observe(const SafetyInput& in, const Wrenches& requested) noexcept {
    SafetyConditions conditions;
    conditions.commands = in.commands;
    conditions.heartbeatAge_ms = in.heartbeatAge_ms;
    conditions.sceneChanged = (in.scene.events & core::event_bits::kSceneChanged) != 0;
    conditions.allGood = true;
    conditions.requestSmall = m_requestFinite;
    conditions.still = true;
    if (!m_requestFinite || !m_answerFinite) {
        conditions.faults |= guard_bits::kNotFinite;
    }
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        observeSample(i, conditions);
        observeMotion(in, requested, i, conditions);
    }
    return conditions;
}

void SafetySupervisor::observeSample(std::size_t tool, SafetyConditions& conditions) noexcept {
    const SafetySampleSanity& sanity = m_sanity[tool];
    const SafetyToolLimits& limits = m_limits[tool];
    std::uint32_t faults = 0;
    if (sanity.badInARow() >= m_settings.badPacketsToFault) {
        faults |= guard_bits::kSampleFault;
    }
    if ((sanity.seen().status & core::sample_status::kDeviceFault) != 0) {
        faults |= guard_bits::kDeviceFault;
    }
    m_guards |= faults | (sanity.droppedThisTick() ? guard_bits::kBadSample : 0u);
    // The stop button counts in a refused packet too: this is the safe reading of a doubtful packet.
    conditions.stopButton = conditions.stopButton || (sanity.seen().buttons & core::kButtonStop) != 0;
    if (!limits.renders) {
        return;
    }
    conditions.deadMan = conditions.deadMan || (sanity.good().buttons & core::kButtonDeadMan) != 0;
    conditions.allGood = conditions.allGood && sanity.hasReference();
    if (m_mask.has(GuardMask::kWatchdog) && !limits.inProcess && sanity.hasGood()) {
        conditions.watchdogScale = std::min(conditions.watchdogScale, watchdogScale(limits, sanity.age_us()));
        if (sanity.age_us() >= limits.watchdogFault_us) {
            faults |= guard_bits::kWatchdogFault;
        }
    }
    conditions.faults |= faults;
}

void SafetySupervisor::observeMotion(const SafetyInput& in, const Wrenches& requested, std::size_t tool,
                                     SafetyConditions& conditions) const noexcept {
    if (!m_limits[tool].renders || static_cast<int>(tool) >= in.states.count) {
        return;
    }
    const double speed = in.states.tools[tool].v_WT.norm() / m_limits[tool].scale;
    conditions.still = conditions.still && speed < m_settings.stillSpeed_m_per_s;
    conditions.tooFast = conditions.tooFast || !(speed <= m_settings.overVelocity_m_per_s);
    conditions.requestSmall = conditions.requestSmall &&
                              requested[tool].force.norm() < m_settings.armingForce_N &&
                              requested[tool].torque.norm() < m_settings.armingTorque_Nm;
}

void SafetySupervisor::forgetReferences(bool inputOnly) noexcept {
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        // Input-only tools have no force to guard: after badPacketsToFault bad packets they start afresh by
        // themselves.
        if (inputOnly ? !m_limits[i].renders && m_sanity[i].badInARow() >= m_settings.badPacketsToFault
                      : m_limits[i].renders) {
            m_sanity[i].forgetReference();
        }
    }
}

} // namespace chiron::haptics
