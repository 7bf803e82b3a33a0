// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/urethra_wall.h"

#include "core/units.h"
#include "simulation/geometry/urethra/smoothstep.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// ½(1 + cos πu): 1 at u ≤ 0, exactly 0 from u = 1 on.
double raisedCosine(double u) noexcept {
    if (u <= 0.0)
        return 1.0;
    return u >= 1.0 ? 0.0 : 0.5 * (1.0 + std::cos(core::kPi * u));
}

/// Derivative of raisedCosine(), 0 outside; it is continuous.
double raisedCosineSlope(double u) noexcept {
    return u <= 0.0 || u >= 1.0 ? 0.0 : -0.5 * core::kPi * std::sin(core::kPi * u);
}

double weight(const UrethraLocalChange& change, double s_m) noexcept {
    const double fromCentre = s_m - change.centre_m;
    return smoothstep((0.5 * change.length_m + fromCentre) / change.edge_m + 0.5) *
           smoothstep((0.5 * change.length_m - fromCentre) / change.edge_m + 0.5);
}

/// base + Σ w (changed − base). Changes do not overlap (urethraProblems() checks this), so the value is a
/// change's own one at full weight and exactly the base value away from all changes.
template <class ChangedValue>
double varied(const UrethraAnatomy& anatomy, double s_m, double base, ChangedValue changed) noexcept {
    double value = base;
    for (std::size_t i = 0; i < std::min(anatomy.changeCount, UrethraAnatomy::kMaxChanges); ++i)
        value += weight(anatomy.changes[i], s_m) * (changed(anatomy.changes[i]) - base);
    return value;
}

} // namespace

double UrethraWall::radius_m(double s_m) const noexcept {
    return varied(m_anatomy, s_m, m_anatomy.radius_m,
                  [](const UrethraLocalChange& change) { return change.radius_m; });
}

double UrethraWall::stiffness_N_per_m3(double s_m) const noexcept {
    const double base = m_anatomy.wallStiffness_N_per_m3;
    return varied(m_anatomy, s_m, base,
                  [base](const UrethraLocalChange& change) { return base * change.stiffnessFactor; });
}

double UrethraWall::friction(double s_m) const noexcept {
    const double base = m_anatomy.friction;
    return varied(m_anatomy, s_m, base,
                  [base](const UrethraLocalChange& change) { return base * change.frictionFactor; });
}

double UrethraWall::constrained(double s_m) const noexcept {
    return smoothstep(0.5 + 0.5 * (s_m - m_anatomy.freeLength_m) / m_anatomy.freeBlend_m);
}

double UrethraWall::opening(double s_m, double tip_s_m) const noexcept {
    // Uses the same sum for the end as the drawn surface does: the quotient may round to just below 1 there.
    return s_m >= tip_s_m + m_scope.beak_m ? 0.0 : raisedCosine((s_m - tip_s_m) / m_scope.beak_m);
}

double UrethraWall::openingSlope(double s_m, double tip_s_m) const noexcept {
    return -raisedCosineSlope((s_m - tip_s_m) / m_scope.beak_m) / m_scope.beak_m;
}

double UrethraWall::following(double s_m, double tip_s_m) const noexcept {
    return s_m > tip_s_m ? opening(s_m, tip_s_m) : raisedCosine((tip_s_m - s_m) / m_scope.behind_m);
}

double UrethraWall::followingSlope(double s_m, double tip_s_m) const noexcept {
    return s_m > tip_s_m ? openingSlope(s_m, tip_s_m)
                         : raisedCosineSlope((tip_s_m - s_m) / m_scope.behind_m) / m_scope.behind_m;
}

double UrethraWall::openedRadius_m(double s_m, double tip_s_m) const noexcept {
    const double rest = radius_m(s_m);
    const double more = m_scope.radius_m - rest;
    if (more <= 0.0)
        return rest;
    return s_m <= tip_s_m ? m_scope.radius_m : rest + more * opening(s_m, tip_s_m);
}

} // namespace chiron::simulation
