// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/endoscope_control.h"

#include <Qt>
#include <algorithm>
#include <array>

namespace chiron::desktop {

namespace {

constexpr std::array<int, 11> kKeys{Qt::Key_W,    Qt::Key_S,     Qt::Key_PageUp, Qt::Key_PageDown,
                                    Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down,
                                    Qt::Key_Q,    Qt::Key_E,     Qt::Key_Shift};

bool moves(int key) {
    return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

} // namespace

std::span<const int> EndoscopeControl::keys() const noexcept {
    return kKeys;
}

void EndoscopeControl::drag(QPointF pixels, bool sideways) noexcept {
    devices::EndoscopeMovement by;
    if (sideways) {
        by.right_m = m_right * pixels.x() * kMetresPerPixel / m_scale;
        by.up_m = -pixels.y() * kMetresPerPixel / m_scale;
    } else {
        by.turnRight_rad = m_right * pixels.x() * kRadiansPerPixel / m_scale;
        by.turnUp_rad = -pixels.y() * kRadiansPerPixel / m_scale;
    }
    m_mailbox.move(by);
}

void EndoscopeControl::wheel(int eighthsOfDegree) noexcept {
    m_mailbox.move({.advance_m = kMetresPerWheelStep * eighthsOfDegree / 120.0});
}

bool EndoscopeControl::keyDown(int key) {
    if (!moves(key))
        return false;
    m_held.insert(key);
    sendRate();
    return true;
}

bool EndoscopeControl::keyUp(int key) {
    if (!moves(key))
        return false;
    m_held.erase(key);
    sendRate();
    return true;
}

void EndoscopeControl::releaseKeys() {
    m_held.clear();
    sendRate();
}

void EndoscopeControl::sendRate() {
    const double right = m_right * between(Qt::Key_Left, Qt::Key_Right);
    const double up = between(Qt::Key_Down, Qt::Key_Up);
    devices::EndoscopeMovement perSecond;
    perSecond.advance_m =
        kKeyAdvance_m_per_s *
        std::clamp(between(Qt::Key_S, Qt::Key_W) + between(Qt::Key_PageDown, Qt::Key_PageUp), -1.0, 1.0);
    if (holds(Qt::Key_Shift)) {
        perSecond.right_m = kKeyShift_m_per_s * right;
        perSecond.up_m = kKeyShift_m_per_s * up;
    } else {
        perSecond.turnRight_rad = kKeyTurn_rad_per_s * right;
        perSecond.turnUp_rad = kKeyTurn_rad_per_s * up;
    }
    perSecond.spin_rad = m_right * kKeySpin_rad_per_s * between(Qt::Key_Q, Qt::Key_E);
    m_mailbox.setRate(perSecond);
}

} // namespace chiron::desktop
