// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/simulation/handling_progress.h"

#include <algorithm>

namespace chiron::simulation {

using core::LaparoscopyStep;

void HandlingProgress::begin(const ObjectHandlingTrial& trial) noexcept {
    m_target_m = trial.target_m;
    m_step = LaparoscopyStep::grasp;
    m_lifted.fill(false);
    m_heldBefore = HandlingWorld::kNone;
    m_dwellTicks = 0;
}

double HandlingProgress::dwell() const noexcept {
    return std::min(1.0, static_cast<double>(m_dwellTicks) / static_cast<double>(m_holdTicks));
}

bool HandlingProgress::isOverTarget(const LooseBody& body) const noexcept {
    const double x = body.p_W.x() - m_target_m.x();
    const double y = body.p_W.y() - m_target_m.y();
    return x * x + y * y <= m_parameters.targetRadius_m * m_parameters.targetRadius_m;
}

bool HandlingProgress::liesInTarget(const HandlingWorld& world, std::size_t i) const noexcept {
    const LooseBody& body = world.body(i);
    return world.held() != static_cast<int>(i) && m_lifted[i] && isOverTarget(body) && body.onBed() &&
           body.v_W.squaredNorm() < kRest_m_per_s * kRest_m_per_s;
}

void HandlingProgress::follow(const HandlingWorld& world, bool clockRuns) noexcept {
    if (done())
        return;
    const int held = world.held();
    if (held != HandlingWorld::kNone) {
        const auto i = static_cast<std::size_t>(held);
        if (held != m_heldBefore)
            m_lifted[i] = false;
        const LooseBody& body = world.body(i);
        m_lifted[i] = m_lifted[i] || body.lifted_m() >= m_parameters.liftHeight_m;
        m_step = !m_lifted[i]         ? LaparoscopyStep::lift
                 : isOverTarget(body) ? LaparoscopyStep::place
                                      : LaparoscopyStep::carry;
    } else {
        m_step = LaparoscopyStep::grasp;
    }
    m_heldBefore = held;
    bool placed = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(world.count()); ++i)
        placed = placed || liesInTarget(world, i);
    if (!placed)
        m_dwellTicks = 0;
    else if (clockRuns)
        ++m_dwellTicks;
    if (placed && held == HandlingWorld::kNone)
        m_step = LaparoscopyStep::place;
    if (m_dwellTicks >= m_holdTicks)
        m_step = LaparoscopyStep::done;
}

} // namespace chiron::simulation
