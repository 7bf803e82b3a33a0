// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact_loops.h"

#include <algorithm>
#include <cmath>

/// Laws that the tests of the hemisphere's contact share.
namespace chiron::simulation::testing {

using core::Vec3;

inline HemisphereContact::Parameters plainParameters() {
    HemisphereContact::Parameters p;
    p.surface = {0.020, 0.0, core::Vec2(0.004, -0.009)};
    p.stiffness.base_N_per_m = 500.0;
    return p;
}

inline HemisphereContact::Parameters variedParameters() {
    HemisphereContact::Parameters p = plainParameters();
    p.stiffness = {800.0, 0.5, 0.030, core::Vec2(0.4, 1.9)};
    return p;
}

inline HemisphereContact::Parameters dimpledParameters() {
    HemisphereContact::Parameters p = plainParameters();
    p.dimple = {0.001, 0.006, p.surface.centre_m + core::Vec2(0.010, 0.0)};
    return p;
}

inline HemisphereContact::Parameters everything() {
    HemisphereContact::Parameters p = variedParameters();
    p.dimple = dimpledParameters().dimple;
    p.damping_Ns_per_m = 2.0;
    p.friction = 0.3;
    return p;
}

inline Vec3 randomVector(core::Random& random, double reach) {
    return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// Largest change of the elastic force per metre where the depth is at most `depth_m` ≤ R/2: the norm of the
/// potential's second derivative, k|∇d'|² + k·max(d ‖Hess d‖ = 1) + k d' ‖Hess h‖ + 2 d' |∇k| |∇d'| + ½ d'²
/// ‖Hess k‖; exactly k for a uniform stiffness without a dimple, where the first two are the parts of one
/// projection.
inline double forceSlopeBound(const HemisphereContact::Parameters& law, double depth_m) {
    const StiffnessField& k = law.stiffness;
    if (k.variation == 0.0 && law.dimple.depth_m == 0.0)
        return k.base_N_per_m;
    const double wave = 2.0 * core::kPi / k.wavelength_m;
    const double kMax = k.base_N_per_m * (1.0 + k.variation);
    const double kGradient = 0.5 * k.base_N_per_m * k.variation * wave * std::sqrt(2.0);
    const double kCurvature = 0.5 * k.base_N_per_m * k.variation * wave * wave;
    const double w = law.dimple.halfWidth_m;
    const double slope = 1.0 + 8.0 / (3.0 * std::sqrt(3.0)) * law.dimple.depth_m / w;
    const double hCurvature = 8.0 * law.dimple.depth_m / (w * w);
    return kMax * (slope * slope + 1.0 + depth_m * hCurvature) + 2.0 * depth_m * kGradient * slope +
           0.5 * depth_m * depth_m * kCurvature;
}

/// Elastic force alone (no damping, no friction).
inline Force elasticForce(HemisphereContact::Parameters law) {
    law.damping_Ns_per_m = 0.0;
    const HemisphereContact contact(law);
    return [contact](const Vec3& p) { return contact.respond(p, Vec3::Zero()).force; };
}

} // namespace chiron::simulation::testing
