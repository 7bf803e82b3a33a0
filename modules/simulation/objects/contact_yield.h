// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact_bits.h"
#include "simulation/yield.h"

#include <cstdint>
#include <limits>

namespace chiron::simulation {

/// TissueYield of one tool on one body, which gives way for a second reason too: the tool has come to where the law has no place
/// (out on another side of a mesh, deeper than a ball is round). It then falls from the force that it has there, by the same curve.
/// Scale all of the contact by the factor: force, stored energy, stiffness. Fixed size. Thread: haptic.
class ContactYield {
public:
    ContactYield() noexcept = default;
    explicit ContactYield(const YieldLaw& law) noexcept : m_law(law), m_yield(law) {}

    /// One tick of `dt_s`. `wanted_N` ≥ 0: what the law answers; `outside`: the tool touches nothing of the body; `breached`: it is
    /// where the law has no place.
    double step(double wanted_N, bool outside, bool breached, double dt_s) noexcept {
        const double factor = m_yield.step(wanted_N, outside, dt_s, 0.0, breached);
        m_gone = m_yield.through() && factor * wanted_N == 0.0;
        return factor;
    }
    bool through() const noexcept { return m_yield.through(); }
    bool gone() const noexcept { return m_gone; } ///< through, and all of the force has fallen
    bool everYields() const noexcept { return m_law.force_N < std::numeric_limits<double>::infinity(); }
    std::uint8_t bits() const noexcept {
        namespace bits = core::contact_bits;
        return static_cast<std::uint8_t>((m_yield.yielded() ? bits::kYielded : 0) | (m_yield.through() ? bits::kThrough | bits::kBeyondChecked : 0));
    }
    void reset() noexcept { *this = ContactYield(m_law); } ///< whole tissue

private:
    YieldLaw m_law;
    TissueYield m_yield;
    bool m_gone = false;
};

} // namespace chiron::simulation
