// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact_bits.h"
#include "simulation/yield.h"

#include <cstdint>
#include <limits>

namespace chiron::simulation {

/// TissueYield of one tool on one body, which can also give way for a second reason: the tool has reached a
/// pose for which the law is not defined (it has come out on another side of a mesh, or is deeper than a ball
/// is round). The force then falls along the same curve, from its value at that moment. Multiply the
/// contact's force, stored energy and stiffness by the factor. Fixed size.
/// Thread: haptic.
class ContactYield {
public:
    ContactYield() noexcept = default;
    explicit ContactYield(const YieldLaw& law) noexcept : m_law(law), m_yield(law) {}

    /// Advances by one tick of `dt_s` and returns the factor. `wanted_N` ≥ 0 is the force of the law.
    /// `outside`: the tool does not touch the body. `breached`: the law is not defined at the tool's pose.
    double step(double wanted_N, bool outside, bool breached, double dt_s) noexcept {
        const double factor = m_yield.step(wanted_N, outside, dt_s, 0.0, breached);
        m_gone = m_yield.through() && factor * wanted_N == 0.0;
        return factor;
    }
    bool through() const noexcept { return m_yield.through(); }
    bool gone() const noexcept { return m_gone; } ///< given way, and the whole force has fallen
    bool everYields() const noexcept { return m_law.force_N < std::numeric_limits<double>::infinity(); }
    std::uint8_t bits() const noexcept {
        namespace bits = core::contact_bits;
        return static_cast<std::uint8_t>((m_yield.yielded() ? bits::kYielded : 0) |
                                         (m_yield.through() ? bits::kThrough | bits::kBeyondChecked : 0));
    }
    void reset() noexcept { *this = ContactYield(m_law); } ///< the tissue is whole again

private:
    YieldLaw m_law;
    TissueYield m_yield;
    bool m_gone = false;
};

} // namespace chiron::simulation
