// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/finger_control.h"

#include <algorithm>

namespace chiron::desktop {

FingerControl::FingerControl(std::span<devices::PointerMailbox* const> mailboxes, int fingers, double scale,
                             bool mirrored, bool jaw)
    : m_fingers(std::clamp(fingers, 1, std::max(1, static_cast<int>(mailboxes.size())))),
      m_mailboxes(mailboxes.begin(), mailboxes.end()) {
    for (devices::PointerMailbox* mailbox : mailboxes)
        m_tips.emplace_back(*mailbox, scale, mirrored);
    const auto moving = m_tips.front().keys();
    m_keys.assign(moving.begin(), moving.end());
    if (hands() > 1)
        m_keys.push_back(Qt::Key_H);
    if (jaw)
        m_keys.insert(m_keys.end(), {Qt::Key_G, Qt::Key_O});
}

void FingerControl::moveJaw(int key, bool down) {
    (key == Qt::Key_G ? m_closing : m_opening) = down;
    const int asked = (m_opening ? 1 : 0) - (m_closing ? 1 : 0);
    for (int i = 0; i < m_fingers; ++i) // one lever: every finger of the hand receives its rate
        m_mailboxes[static_cast<std::size_t>(m_hand * m_fingers + i)]->setJawRate(kJawSpeed_rad_per_s *
                                                                                  asked);
}

bool FingerControl::isKey(int key) const {
    return std::find(m_keys.begin(), m_keys.end(), key) != m_keys.end();
}

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
    else if (key == Qt::Key_G || key == Qt::Key_O)
        moveJaw(key, true);
    else
        eachFinger([&](PointerControl& tip) { tip.keyDown(key); });
    return true;
}

bool FingerControl::keyUp(int key) {
    if (!isKey(key))
        return false;
    if (key == Qt::Key_G || key == Qt::Key_O)
        moveJaw(key, false);
    else if (key != Qt::Key_H)
        eachFinger([&](PointerControl& tip) { tip.keyUp(key); });
    return true;
}

void FingerControl::releaseKeys() {
    m_still = false;
    for (const int key : {static_cast<int>(Qt::Key_G), static_cast<int>(Qt::Key_O)})
        moveJaw(key, false);
    eachFinger([](PointerControl& tip) { tip.releaseKeys(); });
}

void FingerControl::feel(const haptics::DisplayState& state) {
    for (int hand = 0; hand < hands(); ++hand) {
        bool touches = false;
        for (int tool = hand * m_fingers; tool < (hand + 1) * m_fingers && tool < state.tools; ++tool)
            touches =
                touches ||
                core::toWrench(state.tool[static_cast<std::size_t>(tool)].tissue).force.norm() > kTouch_N;
        for (int i = 0; i < m_fingers; ++i)
            m_tips[static_cast<std::size_t>(hand * m_fingers + i)].setLift(
                touches ? PointerControl::Lift{kMetresPerNotch, kKeyPress_m_per_s} : PointerControl::Lift{});
    }
}

void FingerControl::click() {
    m_tips[static_cast<std::size_t>(activeTool())].click();
}

void FingerControl::choose(int hand) {
    if (hand < 0 || hand >= hands() || hand == m_hand)
        return;
    releaseKeys(); // the other hand keeps its state
    m_hand = hand;
    if (m_tell)
        m_tell(activeTool());
}

} // namespace chiron::desktop
