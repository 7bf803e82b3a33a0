// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/units.h"

namespace chiron::simulation {

/// Weight of an object that an instrument has lifted, on the tool, W (z up):  f = (0, 0, −m g),  and where inertia is
/// wanted  f = −m a  on top. `mass_kg` = m ≥ 0 (P2: an ovary is about 10 g, 98 mN), g = core::kStandardGravity.
/// Weight is conservative, U = m g z: lifting by Δz costs m g Δz. P2 leaves inertia out as negligible; 10 g at 1 m/s² is
/// 10 mN, under what a hand tells apart.
///
/// Sign against P2's three formulas F_h = m g sin h, F_p = m g sin p, F_d = m g cos h cos p: no one force has them for its
/// image under P2's own map. With z of P2's figure up (gravity (0, 0, −m g)) the map gives +m g sin h, +m g sin p and
/// −m g cos h cos p: F_d has the other sign. With z along an instrument that points down (this house's vendor axes,
/// gravity (0, 0, +m g)) it gives −m g sin h, −m g sin p, +m g cos h cos p: F_d agrees, a weight pulls the instrument
/// outwards along itself, and the other two are turned. What is rendered is the force above, sent through the selected map; the
/// formulas as published are `evaluate polar_weight` (mechanisms), never rendered.
/// Pure. Source: P2 "Mass Model"; models.md §2.1, §2.2.
struct Mass {
    static core::Vec3 weight(double mass_kg) noexcept { return {0.0, 0.0, -mass_kg * core::kStandardGravity}; }
    /// −m a: `acceleration_W` of the object, m/s². Not conservative as a force on the tool alone (½ m v² goes with it).
    static core::Vec3 inertia(double mass_kg, const core::Vec3& acceleration_W) noexcept {
        return -mass_kg * acceleration_W;
    }
    /// U = m g z, J; `height_m` over any level one likes.
    static double energy(double mass_kg, double height_m) noexcept {
        return mass_kg * core::kStandardGravity * height_m;
    }
};

} // namespace chiron::simulation
