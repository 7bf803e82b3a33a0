// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "devices/api/motion_mailbox.h"

#include <algorithm>

namespace chiron::devices {

/// How much more slowly a pointer's tool moves while a force is shown that cannot be felt ("pseudo-haptics"):
///   r(F) = 1 − (1 − r_min) · min(1, F/F_max).
/// The idea of a changed control/display ratio is by Lécuyer et al. 2000 ("Pseudo-haptic feedback: can
/// isometric input devices simulate force feedback?", IEEE VR); the linear law and its two constants are
/// assumptions.
struct PseudoHaptics {
    /// 0 < r ≤ 1: control/display ratio at and above slowestAt_N; 1 switches it off.
    double slowestRatio = 0.3;
    double slowestAt_N = 4.0; ///< > 0: shown force at which motion is slowest (the site's default force
                              ///< limit)

    double ratio(double shownForce_N) const noexcept {
        const double share = std::clamp(shownForce_N / slowestAt_N, 0.0, 1.0);
        return std::isfinite(share) ? 1.0 - (1.0 - slowestRatio) * share : slowestRatio;
    }
};

/// The reading end of a MotionMailbox in the tick: returns how far the hand moved in this tick. Pointers and
/// wheels report in jumps, 8 to 16 ms apart, which do not represent the speed of any hand; therefore the tool
/// follows through a first-order lag.
/// Thread: haptic.
template <std::size_t Axes> class MotionIntake {
public:
    /// `share` is the share of the pending movement that a tick makes up, 1 − e^(−tick/time constant); 1: as
    /// the hand reports.
    explicit MotionIntake(double share) noexcept : m_share(share) {}

    void forget(const MotionTotals<Axes>& totals) noexcept { ///< discards everything that came before
        m_seen = totals;
        m_pending = {};
    }
    std::array<double, Axes> take(const MotionTotals<Axes>& totals) noexcept {
        std::array<double, Axes> hand{};
        for (std::size_t i = 0; i < Axes; ++i) {
            m_pending[i] += totals.moved[i] - m_seen.moved[i];
            const double followed = m_share * m_pending[i];
            m_pending[i] -= followed;
            hand[i] = followed + totals.rate_per_s[i] * core::kTickSeconds;
        }
        m_buttons = totals.held;
        // A click that begins and ends between two ticks is still reported for one tick.
        if (totals.markPresses != m_seen.markPresses)
            m_buttons |= core::kButtonMark;
        if (totals.stopPresses != m_seen.stopPresses)
            m_buttons |= core::kButtonStop;
        m_seen = totals;
        return hand;
    }
    std::uint32_t buttons() const noexcept { return m_buttons; } ///< of the last take()

private:
    double m_share;
    MotionTotals<Axes> m_seen;            ///< already taken in
    std::array<double, Axes> m_pending{}; ///< moved by the hand, but not yet by the tool
    std::uint32_t m_buttons = 0;
};

} // namespace chiron::devices
