// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace chiron::haptics {

/// Sums the energy W that people have put into a contact (models.md §5; Hannaford & Ryu 2002, time-domain
/// passivity): W(k) = W(k-1) - f(k-1)·(x(k) - x(k-1)) - τ(k-1)·θ(k-1→k), with the commanded wrench (after
/// caps and slew) in W and θ the rotation between the two poses. With U the stored energy, the excess U - W
/// is the energy that could come out, or has come out, without having been put in. A contact lasts from the
/// first touch until no tool touches anything. Several tools that hold one body exchange energy through it,
/// so they share the observer.
///
/// Samples are late, so a spring or damper that is felt late looks passive while it drives the hand. A second
/// sum therefore uses the wrench that was rendered when the sample was taken, if samples are as old as the
/// tool's device may send them, n ticks: W_l += -f(k-1-n)·(x(k) - x(k-1)).
class PassivityObserver {
public:
    /// Age of the oldest samples of each tool's device, in ticks, 0..kMostLate_ticks.
    using Ages = std::array<std::uint8_t, core::kMaxTools>;
    /// Twice the longest period at which a device may render force (SafetySettings::slowestRendering_us).
    static constexpr std::size_t kMostLate_ticks = 8;

    void reset() noexcept;
    /// Adds the work of the wrenches held since the last tick. Call it before hold() of this tick's wrenches.
    /// By default samples are not late at all.
    void addWork(const core::ToolStates& states, const Ages& late_ticks = {}) noexcept;
    /// Adds the energy that a ramp or a swap of the scene put in or took out without the person's work:
    /// ½Δk x².
    void credit(double energy_J) noexcept {
        m_supplied_J += energy_J;
        m_late_J += energy_J;
    }
    /// Each changes one of the two sums alone: a deficit that is forgiven, or energy that has become heat.
    void settleSupplied(double energy_J) noexcept { m_supplied_J += energy_J; }
    void settleLate(double energy_J) noexcept { m_late_J += energy_J; }
    /// Ends the contact: no energy is owed any more.
    void endContact() noexcept { m_supplied_J = m_late_J = m_work_J = 0.0; }
    /// Moves energy to another body's balance because a tool took it along; all sums change alike.
    void move(double energy_J, PassivityObserver& to) noexcept {
        for (const Sum sum : kSums) {
            this->*sum -= energy_J;
            to.*sum += energy_J;
        }
    }
    /// Moves all energy to another body's balance because the last tool left.
    void moveAll(PassivityObserver& to) noexcept {
        for (const Sum sum : kSums) {
            to.*sum += this->*sum;
            this->*sum = 0.0;
        }
    }
    /// Remembers the wrenches that are rendered from now on, and the poses at which they begin.
    void hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept;
    /// The same for the balance of only some tools: the wrenches of the others do not belong to this body.
    void hold(const core::ToolStates& states, const core::ToolWrenches& commanded,
              const std::array<bool, core::kMaxTools>& members) noexcept;
    /// Clears the held wrenches, because no tool is at this body.
    void holdNothing() noexcept;

    double supplied_J() const noexcept { return m_supplied_J; } ///< work and credits
    double late_J() const noexcept { return m_late_J; }         ///< the same, if samples are late
    double work_J() const noexcept { return m_work_J; }         ///< the work alone, since the contact began

private:
    using Sum = double PassivityObserver::*;
    static const std::array<Sum, 3> kSums;

    const core::ToolWrenches& heldBefore(std::size_t ticks) const noexcept;

    core::ToolStates m_states;
    core::ToolWrenches m_held;
    std::array<core::ToolWrenches, kMostLate_ticks> m_earlier{}; ///< ring buffer of what was held before
    std::size_t m_oldest = 0;
    bool m_heldAny = false; ///< hold() was called since the last holdNothing()
    double m_supplied_J = 0.0;
    double m_late_J = 0.0;
    double m_work_J = 0.0;
};

} // namespace chiron::haptics
