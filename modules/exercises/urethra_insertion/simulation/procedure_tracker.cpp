// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/procedure_tracker.h"

#include "modules/exercises/urethra_insertion/cues/canal_reach.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

using simulation::ProcedureStage;

namespace {

core::Vec3 vectorOf(const std::array<double, 3>& a) noexcept {
    return {a[0], a[1], a[2]};
}

} // namespace

ProcedureStep ProcedureTracker::advance(const ProcedureSample& now, std::uint64_t dt_us) noexcept {
    ProcedureStep step;
    if (!std::isfinite(now.s_m) || !std::isfinite(now.offset_m) || !now.p_A.allFinite() ||
        !now.axis_A.allFinite())
        return step;
    m_now_us += m_began ? dt_us : 0;
    measureSpeed(now.p_A);
    m_gate.step(now.s_m, now.offset_m);
    if (m_stage == ProcedureStage::inspection)
        step.seenNow = look(now, m_began ? dt_us : 0);
    m_began = true;
    for (ProcedureStage next = after(m_stage, now); next != m_stage; next = after(m_stage, now)) {
        m_stage = next;
        step.stageChanged = true;
    }
    return step;
}

ProcedureStage ProcedureTracker::after(ProcedureStage stage, const ProcedureSample& now) const noexcept {
    const bool inCanal = m_gate.inside() && now.offset_m <= kCanalReach_m;
    const bool allSeen = m_seen == (std::uint32_t{1} << m_plan.landmarks) - 1;
    switch (stage) {
    case ProcedureStage::outside:
        return inCanal && now.s_m > -m_plan.beak_m ? ProcedureStage::insertion : stage;
    case ProcedureStage::insertion:
        return inCanal && now.s_m >= m_plan.goal_m ? ProcedureStage::inspection : stage;
    case ProcedureStage::inspection:
        if (!allSeen)
            return stage;
        return m_plan.withdraws ? ProcedureStage::withdrawal : ProcedureStage::completed;
    case ProcedureStage::withdrawal:
        return now.s_m < -m_plan.beak_m ? ProcedureStage::completed : stage;
    case ProcedureStage::completed:
        break;
    }
    return stage;
}

void ProcedureTracker::measureSpeed(const core::Vec3& p_A) noexcept {
    while (m_first + 1 < m_count && m_now_us - place(m_first + 1).t_us >= kSpeedWindow_us)
        ++m_first;
    const bool aged = m_first < m_count && m_now_us > place(m_first).t_us;
    if (aged)
        m_speed_m_per_s = (p_A - vectorOf(place(m_first).p)).norm() /
                          (static_cast<double>(m_now_us - place(m_first).t_us) * 1e-6);
    if (m_count == 0 || m_now_us - place(m_count - 1).t_us >= kPlaceEvery_us) {
        m_places[m_count % kPlaces] = {m_now_us, {p_A.x(), p_A.y(), p_A.z()}};
        ++m_count;
    }
}

bool ProcedureTracker::inView(const ProcedureSample& now, std::size_t landmark) const noexcept {
    const core::Vec3 to = vectorOf(m_plan.landmark_A[landmark]) - now.p_A;
    const double distance_m = to.norm();
    return distance_m <= m_plan.distance_m && to.dot(now.axis_A) >= m_plan.cosHalfAngle * distance_m;
}

std::uint32_t ProcedureTracker::look(const ProcedureSample& now, std::uint64_t dt_us) noexcept {
    const bool still = now.s_m > m_plan.neck_m && m_speed_m_per_s <= m_plan.speed_m_per_s;
    std::uint32_t seenNow = 0;
    for (std::size_t i = 0; i < m_plan.landmarks; ++i) {
        const std::uint32_t bit = std::uint32_t{1} << i;
        if ((m_seen & bit) != 0)
            continue;
        m_held_us[i] = still && inView(now, i) ? m_held_us[i] + dt_us : 0;
        if (m_held_us[i] >= m_plan.hold_us && m_held_us[i] > 0)
            seenNow |= bit;
    }
    m_seen |= seenNow;
    return seenNow;
}

int ProcedureTracker::nextLandmark() const noexcept {
    if (m_stage != ProcedureStage::inspection)
        return -1;
    for (std::size_t i = 0; i < m_plan.landmarks; ++i)
        if ((m_seen & (std::uint32_t{1} << i)) == 0)
            return static_cast<int>(i);
    return -1;
}

double ProcedureTracker::dwell() const noexcept {
    if (m_stage != ProcedureStage::inspection)
        return 0.0;
    std::uint64_t longest_us = 0;
    for (std::size_t i = 0; i < m_plan.landmarks; ++i)
        if ((m_seen & (std::uint32_t{1} << i)) == 0)
            longest_us = std::max(longest_us, m_held_us[i]);
    if (m_plan.hold_us == 0)
        return 0.0;
    return std::min(1.0, static_cast<double>(longest_us) / static_cast<double>(m_plan.hold_us));
}

} // namespace chiron::simulation
