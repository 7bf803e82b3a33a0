// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/tube/tube_segment.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

constexpr double kShortest_m = 1e-9; ///< a shorter chord has no direction

/// A unit vector perpendicular to the chord, mostly downward. It is well defined for all directions in which
/// tubes lie.
core::Vec3 bulgeDirection(const core::Vec3& chord, double length_m) noexcept {
    const core::Vec3 down(0.35, 0.0, -1.0); // a standing tube bulges to +x
    core::Vec3 n = down;
    if (length_m > kShortest_m)
        n -= chord * (chord.dot(down) / (length_m * length_m));
    const double norm = n.norm();
    return norm > 1e-6 ? core::Vec3(n / norm) : core::Vec3::UnitY();
}

} // namespace

SegmentPull pullOf(const TubeLaw& law, double tubeLength_m, double restLength_m, const core::Vec3& a,
                   const core::Vec3& b, const core::Vec3& rate, double mostDamping_Ns_per_m) noexcept {
    SegmentPull pull;
    const core::Vec3 chord = b - a;
    const double length_m = chord.norm();
    const double whole = tubeLength_m / restLength_m;
    const double stretch_m = (length_m - restLength_m) * whole;
    if (!(stretch_m > 0.0))
        return pull;
    const core::Vec3 u = chord / length_m;
    const double stretching = u.dot(rate) * whole;
    const double fade = std::min(1.0, stretch_m / kTubeDampingFull_m);
    pull.stretch_m = stretch_m;
    const double viscosity =
        law.viscosity_Ns_per_m * DampingBudget::share(law.viscosity_Ns_per_m * whole, mostDamping_Ns_per_m);
    pull.tension_N = std::max(0.0, law.tension_N(stretch_m) + viscosity * fade * stretching);
    pull.damping_Ns_per_m = viscosity * whole * fade;
    pull.onFirst = pull.tension_N * u;
    pull.energy_J = law.energy_J(stretch_m) / whole;
    pull.stiffness_N_per_m = law.slope_N_per_m(stretch_m) * whole;
    return pull;
}

core::Vec3 tubePlace(const core::Vec3& a, const core::Vec3& b, double restLength_m, double t) noexcept {
    const core::Vec3 chord = b - a;
    const double c2 = chord.squaredNorm();
    core::Vec3 place = a + t * chord;
    const double spare2 = restLength_m * restLength_m - c2;
    if (spare2 > 0.0) {
        place +=
            bulgeDirection(chord, std::sqrt(c2)) * (std::sqrt(spare2) * std::sin(core::kPi * t) / core::kPi);
        place.z() = std::max(place.z(), std::min({0.0, a.z(), b.z()}));
    }
    return place;
}

} // namespace chiron::simulation
