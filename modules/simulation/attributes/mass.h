// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/units.h"

namespace chiron::simulation {

/// Weight of an object that an instrument has lifted, as a force on the tool in W (z up): f = (0, 0, −m g).
/// Where inertia is wanted, f = −m a is added. `mass_kg` = m ≥ 0 (P2: an ovary is about 10 g, 98 mN), g =
/// core::kStandardGravity. Weight is conservative, U = m g z: lifting by Δz costs m g Δz. P2 leaves inertia
/// out as negligible; 10 g at 1 m/s² is 10 mN, less than a hand can tell apart.
///
/// About the signs of P2's three formulas F_h = m g sin h, F_p = m g sin p, F_d = m g cos h cos p: no single
/// force has these three as its image under P2's own map. With z of P2's figure pointing up (gravity (0, 0,
/// −m g)) the map gives +m g sin h, +m g sin p and −m g cos h cos p: F_d has the opposite sign. With z along
/// an instrument that points down (this program's vendor axes, gravity (0, 0, +m g)) it gives −m g sin h, −m
/// g sin p, +m g cos h cos p: F_d agrees, a weight pulls the instrument outwards along itself, and the other
/// two have the opposite sign. The program renders the force above, sent through the selected map. The
/// formulas as published are available as `evaluate polar_weight` (mechanisms) and are never rendered. Pure.
/// Source: P2 "Mass Model"; models.md §2.1, §2.2.
struct Mass {
    static core::Vec3 weight(double mass_kg) noexcept {
        return {0.0, 0.0, -mass_kg * core::kStandardGravity};
    }
    /// Returns −m a for the object's acceleration `acceleration_W` (m/s²). It is not conservative as a force
    /// on the tool alone, because the kinetic energy ½ m v² belongs to the balance.
    static core::Vec3 inertia(double mass_kg, const core::Vec3& acceleration_W) noexcept {
        return -mass_kg * acceleration_W;
    }
    /// Returns U = m g z (J); `height_m` may be measured from any level.
    static double energy(double mass_kg, double height_m) noexcept {
        return mass_kg * core::kStandardGravity * height_m;
    }
};

} // namespace chiron::simulation
