// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "realtime/latest_value.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace chiron::devices {

/// Totals since the mailbox was made, so that reading only the newest value loses no movement and no press.
/// The driver defines what each of the `Axes` motions is (m or rad, in which frame).
template <std::size_t Axes> struct MotionTotals {
    std::array<double, Axes> moved{};
    std::array<double, Axes> rate_per_s{}; ///< of the keys that are held now
    std::uint32_t held = 0;                ///< core::kButton… bits that are held now
    std::uint32_t markPresses = 0;         ///< counts, wraps
    std::uint32_t stopPresses = 0;
};

/// Passes the window's events to the driver's tick, without a lock. A call with a value that is not finite is
/// ignored as a whole.
/// Thread: read() by the tick, the rest by the GUI.
template <std::size_t Axes> class MotionMailbox {
public:
    using Motion = std::array<double, Axes>;

    void press(std::uint32_t buttons) noexcept {
        const std::uint32_t pressed = buttons & ~m_totals.held;
        m_totals.held |= buttons;
        m_totals.markPresses += (pressed & core::kButtonMark) != 0 ? 1 : 0;
        m_totals.stopPresses += (pressed & core::kButtonStop) != 0 ? 1 : 0;
        m_shared.publish(m_totals);
    }
    void release(std::uint32_t buttons) noexcept {
        m_totals.held &= ~buttons;
        m_shared.publish(m_totals);
    }
    const MotionTotals<Axes>& read() noexcept { return m_shared.latest(); }

protected:
    void add(const Motion& motion) noexcept {
        if (!allFinite(motion))
            return;
        for (std::size_t i = 0; i < Axes; ++i)
            m_totals.moved[i] += motion[i];
        m_shared.publish(m_totals);
    }
    void setRates(const Motion& rate_per_s) noexcept {
        if (!allFinite(rate_per_s))
            return;
        m_totals.rate_per_s = rate_per_s;
        m_shared.publish(m_totals);
    }

private:
    static bool allFinite(const Motion& values) noexcept {
        bool finite = true;
        for (const double value : values)
            finite = finite && std::isfinite(value);
        return finite;
    }

    MotionTotals<Axes> m_totals; ///< the GUI's copy
    realtime::LatestValue<MotionTotals<Axes>> m_shared;
};

} // namespace chiron::devices
