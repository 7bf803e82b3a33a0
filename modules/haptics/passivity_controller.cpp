// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/passivity_controller.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::haptics {

namespace {

double lever2(const SafetyToolLimits& limits) noexcept {
    if (limits.forceCap_N <= 0.0) {
        return 0.0;
    }
    const double lever = limits.torqueCap_Nm / limits.forceCap_N;
    return lever * lever;
}

/// -b v, cut so that a vector with a component along v loses at most that component.
void addDamping(core::Vec3& shown, const core::Vec3& rate, double b) noexcept {
    const double rate2 = rate.squaredNorm();
    const double power = shown.dot(rate);
    if (!(rate2 > 0.0) || !std::isfinite(rate2)) {
        return;
    }
    const double most = power > 0.0 ? power / rate2 : std::numeric_limits<double>::infinity();
    shown -= std::min(b, most) * rate;
}

} // namespace

void PassivityController::reset(const SafetySettings& settings) noexcept {
    m_settings = settings;
    m_observer.reset();
    m_excess_J = 0.0;
}

double PassivityController::renderedEnergy_J(const PassivityContact& contact, double gain,
                                             int count) noexcept {
    if (gain <= 0.0) {
        return 0.0;
    }
    double energy = 0.0;
    for (int tool = 0; tool < count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        const double s = std::min(1.0, contact.capRatio[i] / gain);
        energy += contact.share[i] * gain * contact.stored_J * s * (2.0 - s);
    }
    return energy;
}

bool PassivityController::apply(const Limits& limits, int count, const core::ToolStates& states,
                                const PassivityContact& contact, Wrenches& wrenches) noexcept {
    m_observer.addWork(states);
    if (!contact.touching || contact.gain <= 0.0) {
        m_observer.endContact();
        m_excess_J = 0.0;
        return false;
    }
    const double rendered = renderedEnergy_J(contact, contact.gain, count);
    if (contact.gain != contact.gainBefore) {
        m_observer.credit(rendered - renderedEnergy_J(contact, contact.gainBefore, count));
    }
    m_excess_J = rendered - m_observer.supplied_J();
    return inject(limits, count, states, contact, wrenches);
}

bool PassivityController::inject(const Limits& limits, int count, const core::ToolStates& states,
                                 const PassivityContact& contact, Wrenches& wrenches) const noexcept {
    double rate2 = 0.0;  // Σ(v² + r²ω²) of the tools that touch
    double speed2 = 0.0; // Σv² of the same
    double scale = std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    for (int tool = 0; tool < count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        if (!limits[i].renders || contact.share[i] <= 0.0) {
            continue;
        }
        const double v2 = states.tools[i].v_WT.squaredNorm();
        speed2 += v2;
        rate2 += v2 + lever2(limits[i]) * states.tools[i].w_WT.squaredNorm();
        scale = std::min(scale, limits[i].scale);
        most = std::min(most, limits[i].damping_Ns_per_m / limits[i].scale);
    }
    constexpr double kT = core::kTickSeconds;
    const double leak = 0.5 * contact.gain * contact.stiffness_N_per_m * speed2 * kT * kT;
    const double excess = m_excess_J + leak;
    const double slowest = m_settings.passivityMinimumSpeed_m_per_s;
    if (!(excess > m_settings.passivityExcess_J * scale) || !(rate2 > slowest * slowest * scale * scale)) {
        return false;
    }
    const double alpha = std::min(excess / (kT * rate2), contact.gain * most);
    for (int tool = 0; tool < count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        if (!limits[i].renders || contact.share[i] <= 0.0) {
            continue;
        }
        addDamping(wrenches[i].force, states.tools[i].v_WT, alpha);
        addDamping(wrenches[i].torque, states.tools[i].w_WT, alpha * lever2(limits[i]));
    }
    return true;
}

void PassivityController::hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept {
    m_observer.hold(states, commanded);
}

} // namespace chiron::haptics
