// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <array>

namespace chiron::haptics {

/// Energy that a contact has been given and what it holds (models.md §5; Hannaford & Ryu 2002, time-domain
/// passivity). W(k) = W(k-1) - f(k-1)·(x(k) - x(k-1)) - τ(k-1)·θ(k-1→k), with the commanded wrench (after
/// caps and slew) in W and θ the rotation between the two poses. Excess = U - W: what could come out, or has
/// come out, without having been put in. One contact lasts from the first touch to when no tool touches
/// anything; several tools holding one body exchange energy through it, so they share the observer.
///
/// A sample is late, and by it a spring or damper that is felt late looks passive while it drives the hand. So a second sum is
/// kept with the wrench that was held when the sample was taken, were it kLate_ticks old: W_l += -f(k-1-kLate)·(x(k) - x(k-1)).
class PassivityObserver {
public:
    void reset() noexcept;
    /// Adds the work of the wrenches held since the last tick. Call before begin() of this tick's wrenches.
    void addWork(const core::ToolStates& states) noexcept;
    /// Energy that a ramp or a swap of the scene put in or took out without the person's work: ½Δk x².
    void credit(double energy_J) noexcept {
        m_supplied_J += energy_J;
        m_late_J += energy_J;
    }
    /// One of the two books alone: debt that is forgiven, or what has become heat.
    void settleSupplied(double energy_J) noexcept { m_supplied_J += energy_J; }
    void settleLate(double energy_J) noexcept { m_late_J += energy_J; }
    /// The contact ended: nothing is owed.
    void endContact() noexcept { m_supplied_J = m_late_J = m_work_J = 0.0; }
    /// A tool took part of what was put in along to another body's book: all sums follow it.
    void move(double energy_J, PassivityObserver& to) noexcept {
        for (const Sum sum : kSums) {
            this->*sum -= energy_J;
            to.*sum += energy_J;
        }
    }
    /// The last tool went: the whole book goes along.
    void moveAll(PassivityObserver& to) noexcept {
        for (const Sum sum : kSums) {
            to.*sum += this->*sum;
            this->*sum = 0.0;
        }
    }
    /// Remembers what is shown from now on, and where.
    void hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept;
    /// The same for a book of some of the tools alone: what the others hold is not this body's.
    void hold(const core::ToolStates& states, const core::ToolWrenches& commanded,
              const std::array<bool, core::kMaxTools>& members) noexcept;
    /// Nothing is held: no tool is at this body.
    void holdNothing() noexcept;

    static constexpr std::size_t kLate_ticks = 3; ///< the latest samples that a device may send (devices.md §6)

    double supplied_J() const noexcept { return m_supplied_J; } ///< the book: work and credits
    double late_J() const noexcept { return m_late_J; }         ///< the same, were samples kLate_ticks old
    double work_J() const noexcept { return m_work_J; }         ///< the work alone, since the contact began

private:
    using Sum = double PassivityObserver::*;
    static const std::array<Sum, 3> kSums;

    core::ToolStates m_states;
    core::ToolWrenches m_held;
    std::array<core::ToolWrenches, kLate_ticks> m_earlier{}; ///< ring
    std::size_t m_oldest = 0;
    double m_supplied_J = 0.0;
    double m_late_J = 0.0;
    double m_work_J = 0.0;
};

} // namespace chiron::haptics
