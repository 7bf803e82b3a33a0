// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/passivity_observer.h"

#include <algorithm>
#include <cmath>

namespace chiron::haptics {

namespace {

/// Rotation vector from one pose to the next; 2·vec(q₁q₀⁻¹) is exact to the third order of the angle, and a
/// tick's angle is milliradians.
core::Vec3 smallRotation(const core::Quat& from, const core::Quat& to) noexcept {
    const core::Quat turn = to * from.conjugate();
    return (turn.w() < 0.0 ? -2.0 : 2.0) * turn.vec();
}

} // namespace

void PassivityObserver::reset() noexcept {
    *this = PassivityObserver();
}

void PassivityObserver::addWork(const core::ToolStates& states) noexcept {
    double work = 0.0;
    for (int tool = 0; tool < std::min(m_held.count, states.count); ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        const core::ToolState& before = m_states.tools[i];
        const core::ToolState& after = states.tools[i];
        work -= m_held.tools[i].force.dot(after.p_WT - before.p_WT);
        if (m_held.tools[i].torque != core::Vec3::Zero()) {
            work -= m_held.tools[i].torque.dot(smallRotation(before.q_WT, after.q_WT));
        }
    }
    if (std::isfinite(work)) {
        m_supplied_J += work;
    }
}

void PassivityObserver::hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept {
    m_held = commanded;
    m_held.count = std::min(commanded.count, states.count);
    m_states = states;
}

void PassivityObserver::hold(const core::ToolStates& states, const core::ToolWrenches& commanded,
                             const std::array<bool, core::kMaxTools>& members) noexcept {
    hold(states, commanded);
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (!members[i]) {
            m_held.tools[i] = core::Wrench{};
        }
    }
}

} // namespace chiron::haptics
