// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/keyboard_mouse/pointer_mailbox.h"

#include "core/tool_state.h"

#include <cmath>

namespace chiron::devices {

namespace {
bool allFinite(double x, double y, double z) noexcept { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
} // namespace

void PointerMailbox::move(double dx_m, double dy_m, double dz_m) noexcept {
    if (!allFinite(dx_m, dy_m, dz_m))
        return;
    m_totals.moved_m[0] += dx_m;
    m_totals.moved_m[1] += dy_m;
    m_totals.moved_m[2] += dz_m;
    m_shared.publish(m_totals);
}

void PointerMailbox::setRate(double x_m_per_s, double y_m_per_s, double z_m_per_s) noexcept {
    if (!allFinite(x_m_per_s, y_m_per_s, z_m_per_s))
        return;
    m_totals.rate_m_per_s = {x_m_per_s, y_m_per_s, z_m_per_s};
    m_shared.publish(m_totals);
}

void PointerMailbox::press(std::uint32_t buttons) noexcept {
    const std::uint32_t pressed = buttons & ~m_totals.held;
    m_totals.held |= buttons;
    m_totals.markPresses += (pressed & core::kButtonMark) != 0 ? 1 : 0;
    m_totals.stopPresses += (pressed & core::kButtonStop) != 0 ? 1 : 0;
    m_shared.publish(m_totals);
}

void PointerMailbox::release(std::uint32_t buttons) noexcept {
    m_totals.held &= ~buttons;
    m_shared.publish(m_totals);
}

} // namespace chiron::devices
