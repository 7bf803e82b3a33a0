// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/latest_value.h"

#include <array>
#include <cstdint>

namespace chiron::devices {

/// Totals since the mailbox was made, so that reading only the newest loses no movement and no press.
struct PointerTotals {
    std::array<double, 3> moved_m{};       ///< x, y, z in D
    std::array<double, 3> rate_m_per_s{};  ///< of keys held now
    std::uint32_t held = 0;                ///< core::kButton… bits held now
    std::uint32_t markPresses = 0;         ///< counts, wraps
    std::uint32_t stopPresses = 0;
};

/// From the window's events to the driver's tick, without a lock. Threads: move(), setRate(), press(), release() by the
/// GUI; read() by the tick.
class PointerMailbox {
public:
    /// The pointer or wheel moved by this, in metres of D (the window converts pixels). Non-finite values are ignored.
    void move(double dx_m, double dy_m, double dz_m) noexcept;
    /// Keys that move the tool are held: its speed, zero when they are let go. Non-finite values are ignored.
    void setRate(double x_m_per_s, double y_m_per_s, double z_m_per_s) noexcept;
    void press(std::uint32_t buttons) noexcept;
    void release(std::uint32_t buttons) noexcept;

    const PointerTotals& read() noexcept { return m_shared.latest(); }

private:
    PointerTotals m_totals; ///< GUI's copy
    realtime::LatestValue<PointerTotals> m_shared;
};

} // namespace chiron::devices
