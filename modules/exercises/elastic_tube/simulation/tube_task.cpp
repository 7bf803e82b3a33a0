// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/elastic_tube/simulation/tube_task.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

using Step = core::LaparoscopyStep;

void TubeTaskTracker::begin(const TubeGoal& goal) noexcept {
    *this = TubeTaskTracker();
    m_goal = goal;
    m_step = goal.fold ? Step::retract : Step::grasp;
}

bool TubeTaskTracker::heldAsNeeded(const TubeTaskSample& now) const noexcept {
    switch (m_goal.task) {
    case TubeTask::hold:
    case TubeTask::stretch:
        return now.held > 0;
    case TubeTask::twoHanded:
        return now.held > 1;
    case TubeTask::transfer: // the right hand begins; after that either hand will do
        return now.rightHolds || (!begins() && now.leftHolds);
    }
    return false;
}

bool TubeTaskTracker::inGoal(const TubeTaskSample& now) const noexcept {
    if (!now.open)
        return false;
    switch (m_goal.task) {
    case TubeTask::hold:
    case TubeTask::twoHanded:
        return std::abs(now.tension_N - m_goal.target_N) <= m_goal.band_N;
    case TubeTask::stretch:
        return std::abs(now.stretch_m - m_goal.mark_m) <= m_goal.markTolerance_m;
    case TubeTask::transfer:
        return (now.freeEnd_W - m_goal.target_W).norm() <= m_goal.targetRadius_m;
    }
    return false;
}

Step TubeTaskTracker::next(const TubeTaskSample& now) noexcept {
    const bool transfer = m_goal.task == TubeTask::transfer;
    if (!heldAsNeeded(now))
        return now.open ? Step::grasp : Step::retract;
    if (transfer && !begins() && (now.rightHolds || !now.leftHolds))
        return Step::handOver;
    switch (m_step) {
    case Step::grasp:
    case Step::retract:
        return transfer ? Step::handOver : Step::stretch;
    case Step::handOver:
        return Step::carry;
    case Step::stretch:
    case Step::carry:
        return inGoal(now) ? Step::hold : m_step;
    case Step::hold:
        ++m_held_ticks;
        m_out_ticks = inGoal(now) ? 0 : m_out_ticks + 1;
        if (m_out_ticks > kBreak_ticks)
            return transfer ? Step::carry : Step::stretch;
        return m_out_ticks == 0 && m_held_ticks >= m_goal.hold_ticks ? Step::done : Step::hold;
    default:
        return m_step;
    }
}

TubeTaskTracker::Change TubeTaskTracker::advance(const TubeTaskSample& now) noexcept {
    Change change;
    if (m_torn || m_step == Step::done || m_step == Step::none)
        return change;
    if (now.stretch_m < kRearmShare * m_goal.overStretch_m)
        m_armed = true;
    if (m_armed && now.stretch_m > m_goal.overStretch_m) {
        m_armed = false;
        change.damaged = true;
    }
    if (now.stretch_m > m_goal.tear_m || now.tension_N > m_goal.tear_N) {
        m_torn = change.torn = true;
        return change;
    }
    const Step before = m_step;
    const bool began = !begins();
    m_step = next(now);
    change.moved = m_step != before;
    if (change.moved && m_step != Step::done)
        m_held_ticks = m_out_ticks = 0;
    change.dropped = began && begins();
    change.completed = m_step == Step::done;
    return change;
}

double TubeTaskTracker::dwell() const noexcept {
    if (m_step == Step::done)
        return 1.0;
    if (m_step != Step::hold || m_goal.hold_ticks == 0)
        return 0.0;
    return std::min(1.0, static_cast<double>(m_held_ticks) / static_cast<double>(m_goal.hold_ticks));
}

} // namespace chiron::simulation
