// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/laparoscopy/scripted_hand.h"

namespace chiron::operators {

using core::Vec3;

void SharedMind::hear(std::size_t hand, const GraspPercept& felt, double jaw_rad) noexcept {
    m_look.hand[hand] = felt;
    m_look.jaw_rad[hand] = jaw_rad;
    if (hand + 1 == m_look.hands)
        m_mind->think(m_look, m_wishes);
}

mechanisms::HandIntention ScriptedHand::decide(const mechanisms::HandPerception& seen) noexcept {
    if (seen.time_s <= 0.0)
        m_reach.start(seen.p_DT); // the hand starts at the instrument's position
    if (m_senses.feel(seen))
        m_mind->hear(m_hand, m_senses.percept(), m_reach.jaw_rad());
    GraspWish wish = m_mind->wishOf(m_hand);
    wish.velocity_m_per_s = m_map.pointToD(m_map.pointToW(Vec3::Zero()) + wish.velocity_m_per_s);
    m_reach.wish(wish);
    return m_reach.advance();
}

} // namespace chiron::operators
