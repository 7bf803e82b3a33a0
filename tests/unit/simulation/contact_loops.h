// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "core/units.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"

#include <cmath>
#include <functional>
#include <vector>

namespace chiron::simulation::testing {

using Force = std::function<core::Vec3(const core::Vec3&)>;

/// A smooth random closed path round `centre`: three harmonics an axis, all of it within ±`reach` an axis.
inline std::vector<core::Vec3> randomLoop(core::Random& random, const core::Vec3& centre, double reach,
                                          int steps) {
    double amplitude[3][3];
    double phase[3][3];
    for (int axis = 0; axis < 3; ++axis)
        for (int harmonic = 0; harmonic < 3; ++harmonic) {
            amplitude[axis][harmonic] = random.uniform(-1.0, 1.0) * reach / 3.0;
            phase[axis][harmonic] = random.uniform(0.0, 2.0 * core::kPi);
        }
    std::vector<core::Vec3> path(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i < steps; ++i) {
        core::Vec3 p = centre;
        for (int axis = 0; axis < 3; ++axis)
            for (int harmonic = 0; harmonic < 3; ++harmonic)
                p[axis] += amplitude[axis][harmonic] *
                           std::sin(2.0 * core::kPi * (harmonic + 1) * i / steps + phase[axis][harmonic]);
        path[static_cast<std::size_t>(i)] = p;
    }
    path.back() = path.front();
    return path;
}

/// A random point of the surface, one third each on the cap, near the rim and on the plane.
inline core::Vec3 randomSurfacePoint(core::Random& random, const HemisphereOnPlane& shape) {
    const double angle = random.uniform(0.0, 2.0 * core::kPi);
    const auto place = static_cast<int>(random.below(3));
    const double R = shape.radius_m;
    const double z = place == 0 ? random.uniform(0.0, R) : (place == 1 ? random.uniform(0.0, 0.1 * R) : 0.0);
    const double rho = place == 2 ? random.uniform(R, 2.0 * R) : std::sqrt(R * R - z * z);
    return {shape.centre_m.x() + rho * std::cos(angle), shape.centre_m.y() + rho * std::sin(angle),
            shape.planeHeight_m + z};
}

/// Work (J) that the hand puts in along a path, by the trapezoid rule: −∫ f·dx. Negative: energy was made.
inline double workIn(const std::vector<core::Vec3>& path, const Force& force) {
    double work = 0.0;
    core::Vec3 before = force(path.front());
    for (std::size_t i = 1; i < path.size(); ++i) {
        const core::Vec3 now = force(path[i]);
        work -= 0.5 * (before + now).dot(path[i] - path[i - 1]);
        before = now;
    }
    return work;
}

/// Straight pieces of `steps` steps between the corners.
inline std::vector<core::Vec3> polygon(const std::vector<core::Vec3>& corners, int steps) {
    std::vector<core::Vec3> path{corners.front()};
    for (std::size_t c = 1; c < corners.size(); ++c)
        for (int i = 1; i <= steps; ++i)
            path.push_back(corners[c - 1] + (corners[c] - corners[c - 1]) * (static_cast<double>(i) / steps));
    return path;
}

} // namespace chiron::simulation::testing
