// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/grasper_control.h"

#include <algorithm>

namespace chiron::desktop {

GrasperControl::GrasperControl(std::span<devices::PointerMailbox* const> mailboxes, double scale,
                               bool mirrored)
    : m_mailboxes(mailboxes.begin(), mailboxes.end()) {
    for (devices::PointerMailbox* mailbox : m_mailboxes)
        m_hands.emplace_back(*mailbox, scale, mirrored);
    const auto moving = m_hands.front().keys();
    m_keys.assign(moving.begin(), moving.end());
    m_keys.insert(m_keys.end(), {Qt::Key_G, Qt::Key_H});
    for (int tool = 0; tool < tools() && tools() > 1; ++tool)
        m_keys.push_back(Qt::Key_1 + tool);
}

bool GrasperControl::keyDown(int key) {
    if (std::find(m_keys.begin(), m_keys.end(), key) == m_keys.end())
        return false;
    if (key >= Qt::Key_1 && key <= Qt::Key_4) {
        choose(key - Qt::Key_1);
    } else if (key == Qt::Key_G || key == Qt::Key_H) {
        (key == Qt::Key_G ? m_closingKey : m_openingKey) = true;
        sendJaw();
    } else {
        hand().keyDown(key);
    }
    return true;
}

bool GrasperControl::keyUp(int key) {
    if (std::find(m_keys.begin(), m_keys.end(), key) == m_keys.end())
        return false;
    if (key == Qt::Key_G || key == Qt::Key_H) {
        (key == Qt::Key_G ? m_closingKey : m_openingKey) = false;
        sendJaw();
    } else {
        hand().keyUp(key);
    }
    return true;
}

void GrasperControl::buttonDown(bool other) {
    m_button = other ? 1 : -1;
    sendJaw();
}

void GrasperControl::buttonUp() {
    m_button = 0;
    sendJaw();
}

void GrasperControl::releaseKeys() {
    m_closingKey = m_openingKey = false;
    m_button = 0;
    hand().releaseKeys();
    sendJaw();
}

void GrasperControl::choose(int tool) {
    if (tool < 0 || tool >= tools() || tool == m_active)
        return;
    releaseKeys(); // the previous tool keeps its state
    m_active = tool;
    if (m_tell)
        m_tell(m_active);
}

void GrasperControl::sendJaw() {
    const int asked = (m_openingKey ? 1 : 0) - (m_closingKey ? 1 : 0) + m_button;
    m_mailboxes[static_cast<std::size_t>(m_active)]->setJawRate(kJawSpeed_rad_per_s *
                                                                std::clamp(asked, -1, 1));
}

} // namespace chiron::desktop
