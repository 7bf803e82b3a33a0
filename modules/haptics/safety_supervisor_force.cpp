// SPDX-License-Identifier: GPL-3.0-or-later
// The stages after the gain: passivity, over-velocity damping, caps, slew, finite check, and the answer.
#include "haptics/safety_caps.h"
#include "haptics/safety_slew.h"
#include "haptics/safety_supervisor.h"

#include <algorithm>
#include <cmath>

namespace chiron::haptics {

namespace guard_bits = core::guard_bits;

namespace {

double usable(double value) noexcept {
    return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

} // namespace

PassivityContact SafetySupervisor::contactOf(const SafetyInput& in,
                                             const Wrenches& requested) const noexcept {
    PassivityContact contact;
    contact.stored_J = usable(in.scene.storedEnergy_J);
    contact.stiffness_N_per_m = usable(in.scene.contactStiffness_N_per_m);
    contact.gain = m_machine.gain();
    contact.gainBefore = m_lastGain;
    double sum = 0.0;
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        contact.capRatio[i] = 1.0;
        contact.share[i] = requested[i].force.squaredNorm();
        sum += contact.share[i];
        if (contact.gain > 0.0 && m_limits[i].renders && m_mask.has(GuardMask::kCaps)) {
            contact.capRatio[i] = capRatio(m_limits[i], m_sanity[i].good(), requested[i]);
        }
    }
    for (double& share : contact.share) {
        share = sum > 0.0 ? share / sum : 1.0 / std::max(1, m_count);
    }
    contact.touching =
        contact.stored_J > 0.0 || std::any_of(requested.begin(), requested.end(), [](const auto& w) {
            return w.force != core::Vec3::Zero() || w.torque != core::Vec3::Zero();
        });
    return contact;
}

void SafetySupervisor::applyPassivity(const SafetyInput& in, const Wrenches& requested,
                                      Wrenches& wrenches) noexcept {
    if (!m_mask.has(GuardMask::kPassivity)) {
        return;
    }
    if (m_passivity.apply(m_limits, m_count, in.states, contactOf(in, requested), wrenches)) {
        m_guards |= guard_bits::kPassivity;
    }
}

void SafetySupervisor::applyOverVelocityDamping(const SafetyInput& in, Wrenches& wrenches) const noexcept {
    const double gain = m_machine.dampingGain();
    if (gain <= 0.0) {
        return;
    }
    for (int tool = 0; tool < std::min(m_count, in.states.count); ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        const core::Vec3 v_D =
            in.states.tools[i].v_WT / m_limits[i].scale; // along W's axes, at the hand's speed
        if (!m_limits[i].renders || m_limits[i].forceCap_N <= 0.0 || !v_D.allFinite()) {
            continue;
        }
        const double b = std::min(m_settings.overVelocityDamping_Ns_per_m, m_limits[i].damping_Ns_per_m);
        wrenches[i].force = -gain * b * v_D;
    }
}

void SafetySupervisor::applyCapsAndSlew(Wrenches& wrenches) noexcept {
    bool capped = false;
    bool slewed = false;
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        core::Wrench& w = wrenches[i];
        if (!m_limits[i].renders) {
            continue;
        }
        if (m_mask.has(GuardMask::kCaps)) {
            capped = applyCaps(m_limits[i], m_sanity[i].good(), w) || capped;
        }
        if (m_mask.has(GuardMask::kSlew)) {
            w.force = limitSlew(m_last[i].force, w.force, m_settings.slewForce_N_per_ms, slewed);
            w.torque = limitSlew(m_last[i].torque, w.torque, m_settings.slewTorque_Nm_per_ms, slewed);
            // Part of the last wrench may be in the answer, and the pose has moved since: the caps of *this*
            // pose hold. Scaling down is a decrease, so the slew still holds too.
            if (slewed && m_mask.has(GuardMask::kCaps)) {
                capped = applyCaps(m_limits[i], m_sanity[i].good(), w) || capped;
            }
        }
    }
    m_guards |= (capped ? guard_bits::kCap : 0u) | (slewed ? guard_bits::kSlew : 0u);
}

void SafetySupervisor::applyFiniteCheck(Wrenches& wrenches) noexcept {
    if (!m_mask.has(GuardMask::kFinite)) {
        return;
    }
    const bool finite = std::all_of(wrenches.begin(), wrenches.end(), [](const core::Wrench& w) {
        return w.force.allFinite() && w.torque.allFinite();
    });
    if (!finite) {
        m_answerFinite = false;
        m_guards |= guard_bits::kNotFinite;
        wrenches = Wrenches{};
    }
}

void SafetySupervisor::publish(const SafetyInput& in, const Wrenches& wrenches, SafetyOutput& out) noexcept {
    const bool live = m_answerFinite && (m_machine.gain() > 0.0 || m_machine.dampingGain() > 0.0);
    core::ToolWrenches commanded;
    commanded.count = m_count;
    out = SafetyOutput();
    out.count = m_count;
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        SafeTool& safe = out.tools[i];
        safe.enabled = live && m_limits[i].renders;
        safe.wrench_W = wrenches[i];
        safe.wrench_D = m_limits[i].map.wrenchToD(wrenches[i]);
        safe.noMovement = !m_limits[i].renders && m_sanity[i].age_us() >= m_settings.noMovement_us;
        commanded.tools[i] = wrenches[i];
    }
    m_last = wrenches;
    m_passivity.hold(in.states, commanded);
    out.paused = m_machine.paused();
    if (anyRendersForce()) {
        out.force = m_machine.state();
        out.guards = m_guards | m_machine.guards();
        out.waitsFor = m_machine.waitsFor();
        out.gain = m_machine.gain();
        out.forceReady = out.force == core::ForceState::on;
    } else {
        out.guards = m_guards | (m_machine.guards() & guard_bits::kPause);
        out.waitsFor = ArmingWait::nothing;
        out.forceReady = true;
    }
}

} // namespace chiron::haptics
