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
class PassivityObserver {
public:
    void reset() noexcept;
    /// Adds the work of the wrenches held since the last tick. Call before begin() of this tick's wrenches.
    void addWork(const core::ToolStates& states) noexcept;
    /// Energy that a ramp or a swap of the scene put in or took out without the person's work: ½Δk x².
    void credit(double energy_J) noexcept { m_supplied_J += energy_J; }
    /// The contact ended: nothing is owed.
    void endContact() noexcept { m_supplied_J = 0.0; }
    /// Remembers what is shown from now on, and where.
    void hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept;
    /// The same for a book of some of the tools alone: what the others hold is not this body's.
    void hold(const core::ToolStates& states, const core::ToolWrenches& commanded,
              const std::array<bool, core::kMaxTools>& members) noexcept;
    /// Nothing is held: no tool is at this body.
    void holdNothing() noexcept { m_held.count = 0; }

    double supplied_J() const noexcept { return m_supplied_J; }

private:
    core::ToolStates m_states;
    core::ToolWrenches m_held;
    double m_supplied_J = 0.0;
};

} // namespace chiron::haptics
