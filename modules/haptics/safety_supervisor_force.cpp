// SPDX-License-Identifier: GPL-3.0-or-later
// The stages after the gain: passivity, over-velocity damping, caps, slew, finite check, and the output.
#include "haptics/finite_wrench.h"
#include "haptics/safety_caps.h"
#include "haptics/safety_display.h"
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

PassivityBodies SafetySupervisor::bodiesOf(const SafetyInput& in, const Wrenches& requested) const noexcept {
    PassivityBodies bodies;
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        bodies.bodyOf[i] = static_cast<std::uint8_t>(std::min<int>(in.scene.body[i], core::kMaxTools - 1));
        bodies.contacts[bodies.bodyOf[i]].members[i] = true;
    }
    for (std::size_t body = 0; body < bodies.contacts.size(); ++body) {
        fillContact(in, requested, body, bodies.contacts[body]);
    }
    return bodies;
}

void SafetySupervisor::fillContact(const SafetyInput& in, const Wrenches& requested, std::size_t body,
                                   PassivityContact& contact) const noexcept {
    const bool all = !in.scene.energyByBody && body == 0; // without energy per body, everything belongs to
                                                          // body 0
    contact.stored_J = usable(all                     ? in.scene.storedEnergy_J
                              : in.scene.energyByBody ? in.scene.bodyEnergy_J[body]
                                                      : 0.0);
    contact.stiffness_N_per_m = usable(all                     ? in.scene.contactStiffness_N_per_m
                                       : in.scene.energyByBody ? in.scene.bodyStiffness_N_per_m[body]
                                                               : 0.0);
    contact.capKnee = m_settings.capKnee;
    contact.gain = m_machine.gain();
    contact.gainBefore = m_lastGain;
    double sum = 0.0;
    int members = 0;
    bool pushes = false;
    contact.givesWay = in.scene.energyByBody;
    // A body that is held counts as touched even if it is slack; its stiffness shows that it is held.
    contact.touching = contact.stored_J > 0.0 || (contact.givesWay && contact.stiffness_N_per_m > 0.0);
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        // A tool that displays force to the pad alone exchanges no energy here.
        contact.members[i] = contact.members[i] && m_limits[i].pushesHand;
        if (!contact.members[i]) {
            continue;
        }
        pushes = true;
        ++members;
        const core::Wrench& w = requested[i];
        contact.capRatio[i] = 1.0;
        contact.damping_Ns_per_m[i] = usable(in.scene.damping_Ns_per_m[i]);
        contact.share[i] = w.force.squaredNorm();
        sum += contact.share[i];
        contact.touching =
            contact.touching || w.force != core::Vec3::Zero() || w.torque != core::Vec3::Zero();
        if (contact.gain > 0.0 && m_limits[i].renders && m_mask.has(GuardMask::kCaps)) {
            contact.capRatio[i] = capRatio(m_limits[i], m_sanity[i].good(), w, usable(in.scene.load_N[i]));
        }
    }
    if (!pushes) {
        contact.stored_J = contact.stiffness_N_per_m = 0.0;
        contact.touching = false;
    }
    for (std::size_t i = 0; i < contact.share.size(); ++i) {
        if (contact.members[i]) {
            contact.share[i] = sum > 0.0 ? contact.share[i] / sum : 1.0 / members;
        }
    }
}

void SafetySupervisor::applyPassivity(const SafetyInput& in, const Wrenches& requested,
                                      Wrenches& wrenches) noexcept {
    if (!m_mask.has(GuardMask::kPassivity)) {
        return;
    }
    if (m_passivity.apply(m_limits, m_count, in.states, bodiesOf(in, requested), wrenches)) {
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
            in.states.tools[i].v_WT / m_limits[i].scale; // along the axes of W, at the hand's speed
        if (!m_limits[i].renders || !m_limits[i].pushesHand || m_limits[i].forceCap_N <= 0.0 ||
            !v_D.allFinite()) {
            continue;
        }
        const double b = std::min(m_settings.overVelocityDamping_Ns_per_m, m_limits[i].damping_Ns_per_m);
        wrenches[i].force = -gain * b * v_D;
    }
}

void SafetySupervisor::applyCapsAndSlew(const SafetyInput& in, Wrenches& wrenches) noexcept {
    bool capped = false;
    bool slewed = false;
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        core::Wrench& w = wrenches[i];
        if (!m_limits[i].renders) {
            continue;
        }
        if (m_mask.has(GuardMask::kCaps)) {
            const double load_N = m_machine.gain() * usable(in.scene.load_N[i]);
            capped = applyCaps(m_limits[i], m_sanity[i].good(), w, load_N, m_settings.capKnee) || capped;
        }
        if (m_mask.has(GuardMask::kSlew)) {
            w.force = limitSlew(m_last[i].force, w.force, m_settings.slewForce_N_per_ms, slewed);
            w.torque = limitSlew(m_last[i].torque, w.torque, m_settings.slewTorque_Nm_per_ms, slewed);
            // The result may contain part of the last wrench, and the pose has changed since, so the caps of
            // *this* pose are applied again. Scaling down is a decrease, so the slew limit still holds.
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
    if (!std::all_of(wrenches.begin(), wrenches.end(), isFinite)) {
        m_answerFinite = false;
        m_guards |= guard_bits::kNotFinite;
        wrenches = Wrenches{};
    }
}

/// Returns the wrenches for the devices: with the feed-forward of their friction, scaled by the gain and at
/// most a tenth of the tool's cap, and the sum within the caps of this pose. The energy balance leaves the
/// feed-forward out, because it is less than what friction takes (friction_compensation.h).
SafetySupervisor::Wrenches SafetySupervisor::withCompensation(const SafetyInput& in,
                                                              const Wrenches& wrenches) noexcept {
    constexpr double kMostOfCap = 0.1;
    Wrenches whole = wrenches;
    const double gain = m_machine.gain();
    if (gain <= 0.0 || !m_answerFinite)
        return whole;
    for (int tool = 0; tool < m_count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        core::Wrench help = in.compensation_W[i];
        if (!m_limits[i].renders || !isFinite(help) ||
            (help.force == core::Vec3::Zero() && help.torque == core::Vec3::Zero()))
            continue;
        const double force = help.force.norm(), torque = help.torque.norm();
        double share = gain;
        if (force > kMostOfCap * m_limits[i].forceCap_N)
            share = std::min(share, gain * kMostOfCap * m_limits[i].forceCap_N / force);
        if (torque > kMostOfCap * m_limits[i].torqueCap_Nm)
            share = m_limits[i].torqueCap_Nm > 0.0
                        ? std::min(share, gain * kMostOfCap * m_limits[i].torqueCap_Nm / torque)
                        : share;
        whole[i].force += share * help.force;
        if (m_limits[i].torqueCap_Nm > 0.0)
            whole[i].torque += share * help.torque;
        if (m_mask.has(GuardMask::kCaps))
            (void)applyCaps(m_limits[i], m_sanity[i].good(), whole[i]);
    }
    return whole;
}

core::DisplayPose SafetySupervisor::displayOf(const SafetyInput& in, std::size_t tool,
                                              const SafeTool& safe) noexcept {
    // Over-velocity damping is not a tissue force, so a pad shows nothing of it.
    const bool shows = safe.enabled && m_machine.dampingGain() <= 0.0;
    core::DisplayPose display = displayUnder(in.scene.display[tool], in.scene.tissue.tools[tool].force.norm(),
                                             safe.wrench_W.force.norm(), shows, m_limits[tool].forceCap_N);
    if (m_mask.has(GuardMask::kSlew)) {
        bool limited = false;
        display = slewDisplay(m_lastDisplay[tool], display, m_settings.slewForce_N_per_ms, limited);
        // On a device that pushes the hand, the display is only a picture, so no guard acts on a person.
        m_guards |= limited && !m_limits[tool].pushesHand ? guard_bits::kSlew : 0u;
    }
    m_lastDisplay[tool] = display;
    return display;
}

void SafetySupervisor::publish(const SafetyInput& in, const Wrenches& wrenches, const Wrenches& whole,
                               SafetyOutput& out) noexcept {
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
        safe.wrench_D = m_limits[i].map.wrenchToD(whole[i]);
        safe.compensation_D = m_limits[i].map.wrenchToD(
            {whole[i].force - wrenches[i].force, whole[i].torque - wrenches[i].torque});
        safe.display = displayOf(in, i, safe);
        safe.display_D = m_limits[i].map.displayToD(safe.display);
        safe.noMovement = !m_limits[i].renders && m_sanity[i].age_us() >= m_settings.noMovement_us;
        if (m_limits[i].pushesHand) // otherwise no work is done at this port
            commanded.tools[i] = wrenches[i];
    }
    m_last = wrenches;
    m_passivity.hold(in.states, commanded);
    out.energySupplied_J = m_passivity.work_J();
    out.energyKept_J = m_passivity.kept_J();
    out.energyWithheld_J = m_passivity.withheld_J();
    out.energyBook_J = m_passivity.supplied_J();
    out.energyStored_J = m_passivity.stored_J();
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
