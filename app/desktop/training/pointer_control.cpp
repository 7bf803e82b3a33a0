// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/pointer_control.h"

#include "core/tool_state.h"

#include <algorithm>
#include <array>

namespace chiron::desktop {

namespace {

struct KeyWay {
    int key;
    int axis;
    double sign;
};

constexpr std::array<KeyWay, 6> kWays{{{Qt::Key_Left, 0, -1.0},
                                       {Qt::Key_Right, 0, 1.0},
                                       {Qt::Key_Down, 1, -1.0},
                                       {Qt::Key_Up, 1, 1.0},
                                       {Qt::Key_PageDown, 2, -1.0},
                                       {Qt::Key_PageUp, 2, 1.0}}};

constexpr std::array<int, kWays.size()> kKeys{Qt::Key_Left, Qt::Key_Right,    Qt::Key_Down,
                                              Qt::Key_Up,   Qt::Key_PageDown, Qt::Key_PageUp};

bool moves(int key) {
    return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

} // namespace

void PointerControl::drag(QPointF pixels, bool lifting) noexcept {
    const double perPixel = kMetresPerPixel / m_scale;
    if (lifting)
        m_mailbox.move(0.0, 0.0, -pixels.y() * perPixel);
    else
        m_mailbox.move(m_right * pixels.x() * perPixel, -pixels.y() * perPixel, 0.0);
}

void PointerControl::wheel(int eighthsOfDegree) noexcept {
    m_mailbox.move(0.0, 0.0, m_lift.wheelStep_m * eighthsOfDegree / 120.0);
}

std::span<const int> PointerControl::keys() const noexcept {
    return kKeys;
}

bool PointerControl::keyDown(int key) {
    if (!moves(key))
        return false;
    m_held.insert(key);
    sendRate();
    return true;
}

bool PointerControl::keyUp(int key) {
    if (!moves(key))
        return false;
    m_held.erase(key);
    sendRate();
    return true;
}

void PointerControl::releaseKeys() {
    m_held.clear();
    sendRate();
    m_mailbox.release(core::kButtonMark);
}

void PointerControl::click() {
    m_mailbox.press(core::kButtonMark);
    m_mailbox.release(core::kButtonMark);
}

void PointerControl::setLift(Lift lift) {
    if (lift == m_lift)
        return;
    m_lift = lift;
    sendRate();
}

void PointerControl::sendRate() {
    std::array<double, 3> rate{};
    for (const KeyWay& way : kWays)
        if (m_held.count(way.key) != 0)
            rate[static_cast<std::size_t>(way.axis)] +=
                way.sign * (way.axis == 2 ? m_lift.keySpeed_m_per_s : kKeySpeed_m_per_s);
    m_mailbox.setRate(m_right * rate[0], rate[1], rate[2]);
}

} // namespace chiron::desktop
