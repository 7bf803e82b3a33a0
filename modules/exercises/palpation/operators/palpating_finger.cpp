// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/operators/palpating_finger.h"

namespace chiron::operators {

namespace {
constexpr double kTurning = 0.01; ///< share of the remaining angle per tick; assumption
}

mechanisms::HandIntention PalpatingFinger::decide(const mechanisms::HandPerception& seen) noexcept {
    if (!m_awake || seen.time_s <= 0.0) {
        m_awake = true;
        m_reach.start(seen.p_DT); // the hand begins where the instrument is
        m_turn = seen.q_DT;
        m_mind->wake(m_tool, m_map.pointToW(seen.p_DT));
    }
    if (m_senses.feel(seen, m_mind->order(m_tool)))
        m_mind->felt(m_tool, m_senses.press());
    m_mind->hear(m_tool, seen.time_s, seen.cues, m_map.pointToW(m_reach.place()));
    const FingerOrder& order = m_mind->order(m_tool);
    mechanisms::HandIntention wanted = m_reach.advance(m_map.pointToD(order.goal_W), order.speed_m_per_s);
    m_turn = m_turn.slerp(kTurning, m_map.orientationToD(order.turn_W));
    wanted.q_DDesired = m_turn;
    wanted.buttons = order.buttons;
    return wanted;
}

} // namespace chiron::operators
