// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/passivity_observer.h"

#include <algorithm>
#include <cmath>

namespace chiron::haptics {

namespace {

/// Returns the rotation vector from one pose to the next. 2·vec(q₁q₀⁻¹) is exact to the third order of the
/// angle, and the angle of one tick is milliradians.
core::Vec3 smallRotation(const core::Quat& from, const core::Quat& to) noexcept {
    const core::Quat turn = to * from.conjugate();
    return (turn.w() < 0.0 ? -2.0 : 2.0) * turn.vec();
}

/// Subtracts f·Δx + τ·θ of one tool, where it was held.
void subtractWork(double& work, const core::ToolWrenches& held, std::size_t i, const core::ToolStates& from,
                  const core::ToolStates& to) noexcept {
    if (static_cast<int>(i) >= std::min(held.count, to.count)) {
        return;
    }
    const core::ToolState& before = from.tools[i];
    const core::ToolState& after = to.tools[i];
    work -= held.tools[i].force.dot(after.p_WT - before.p_WT);
    if (held.tools[i].torque != core::Vec3::Zero()) {
        work -= held.tools[i].torque.dot(smallRotation(before.q_WT, after.q_WT));
    }
}

} // namespace

constexpr std::array<PassivityObserver::Sum, 3> PassivityObserver::kSums{
    &PassivityObserver::m_supplied_J, &PassivityObserver::m_late_J, &PassivityObserver::m_work_J};

void PassivityObserver::reset() noexcept {
    *this = PassivityObserver();
}

/// What was held `ticks` before what is held now.
const core::ToolWrenches& PassivityObserver::heldBefore(std::size_t ticks) const noexcept {
    return ticks == 0 ? m_held : m_earlier[(m_oldest + kMostLate_ticks - ticks) % kMostLate_ticks];
}

void PassivityObserver::addWork(const core::ToolStates& states, const Ages& late_ticks) noexcept {
    double work = 0.0;
    double late = 0.0;
    for (std::size_t i = 0; i < late_ticks.size(); ++i) {
        subtractWork(work, m_held, i, m_states, states);
        subtractWork(late, heldBefore(late_ticks[i]), i, m_states, states);
    }
    m_late_J += std::isfinite(late) ? late : 0.0;
    if (std::isfinite(work)) {
        m_supplied_J += work;
        m_work_J += work;
    }
}

void PassivityObserver::hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept {
    m_earlier[m_oldest] = m_held;
    m_oldest = (m_oldest + 1) % kMostLate_ticks;
    m_heldAny = true;
    m_held = commanded;
    m_held.count = std::min(commanded.count, states.count);
    m_states = states;
}

void PassivityObserver::holdNothing() noexcept {
    if (!m_heldAny) {
        return;
    }
    m_held = core::ToolWrenches{};
    m_earlier = {};
    m_heldAny = false;
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
