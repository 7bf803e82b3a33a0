// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/finger_control.h"

#include <algorithm>

namespace chiron::desktop {

FingerControl::FingerControl(std::span<devices::PointerMailbox* const> mailboxes, int fingers, double scale, bool mirrored)
    : m_fingers(std::clamp(fingers, 1, std::max(1, static_cast<int>(mailboxes.size())))) {
    for (devices::PointerMailbox* mailbox : mailboxes)
        m_tips.emplace_back(*mailbox, scale, mirrored, PointerControl::Lift{kMetresPerNotch, kKeyPress_m_per_s});
    const auto moving = m_tips.front().keys();
    m_keys.assign(moving.begin(), moving.end());
    if (hands() > 1)
        m_keys.push_back(Qt::Key_H);
}

bool FingerControl::isKey(int key) const { return std::find(m_keys.begin(), m_keys.end(), key) != m_keys.end(); }

void FingerControl::drag(QPointF pixels, bool lifting) noexcept {
    if (!m_still)
        eachFinger([&](PointerControl& tip) { tip.drag(pixels, lifting); });
}

void FingerControl::wheel(int eighthsOfDegree) noexcept {
    eachFinger([&](PointerControl& tip) { tip.wheel(eighthsOfDegree); });
}

bool FingerControl::keyDown(int key) {
    if (!isKey(key))
        return false;
    if (key == Qt::Key_H)
        choose((m_hand + 1) % hands());
    else
        eachFinger([&](PointerControl& tip) { tip.keyDown(key); });
    return true;
}

bool FingerControl::keyUp(int key) {
    if (!isKey(key))
        return false;
    if (key != Qt::Key_H)
        eachFinger([&](PointerControl& tip) { tip.keyUp(key); });
    return true;
}

void FingerControl::releaseKeys() {
    m_still = false;
    eachFinger([](PointerControl& tip) { tip.releaseKeys(); });
}

void FingerControl::click() { m_tips[static_cast<std::size_t>(activeTool())].click(); }

void FingerControl::choose(int hand) {
    if (hand < 0 || hand >= hands() || hand == m_hand)
        return;
    releaseKeys(); // the hand that is left stays as it is
    m_hand = hand;
    if (m_tell)
        m_tell(activeTool());
}

} // namespace chiron::desktop
