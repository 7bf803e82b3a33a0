// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "core/units.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"

#include <array>
#include <cmath>
#include <vector>

/// Poses of the endoscope that the tests of the urethra's forces share.
namespace chiron::simulation::testing {

/// A pose by arc length, offset in the section and tilt of the axis from the centre-line in and out of the
/// plane of symmetry.
struct Placement {
    double s_m = 0.0, ex_m = 0.0, en_m = 0.0;
    double pitch_rad = 0.0, yaw_rad = 0.0;
};

inline EndoscopeMotion motionAt(const UrethraCentreline& line, const Placement& at) {
    const CentrelinePoint foot = line.at(at.s_m);
    EndoscopeMotion motion;
    motion.p_A = foot.p_A + at.ex_m * core::Vec3::UnitX() + at.en_m * foot.n_A;
    const double angle = foot.psi_rad + at.pitch_rad;
    motion.axis_A = core::Vec3(std::sin(at.yaw_rad), std::cos(at.yaw_rad) * std::sin(angle),
                               std::cos(at.yaw_rad) * std::cos(angle));
    return motion;
}

inline core::Vec3 randomVector(core::Random& random, double reach) {
    return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// Anywhere from before the entrance to deep in the bladder, up to `offset_m` (each way) off and 30° tilted,
/// moving.
inline EndoscopeMotion randomMotion(core::Random& random, const UrethraCentreline& line,
                                    double offset_m = 0.006) {
    const double tilt = core::kPi / 6.0;
    EndoscopeMotion motion =
        motionAt(line, {random.uniform(-0.015, line.length_m() + 0.045), random.uniform(-offset_m, offset_m),
                        random.uniform(-offset_m, offset_m), random.uniform(-tilt, tilt),
                        random.uniform(-tilt, tilt)});
    motion.v_A = randomVector(random, 0.1);
    motion.w_A = randomVector(random, 3.0);
    return motion;
}

/// In the bladder, near or in its wall, all round it.
inline EndoscopeMotion randomInBladder(core::Random& random, const UrethraForces& forces) {
    const CentrelinePoint neck = forces.centreline().at(forces.centreline().length_m());
    core::Vec3 way;
    do
        way = randomVector(random, 1.0);
    while (way.norm() > 1.0 || way.norm() < 0.1);
    const double R = forces.wall().anatomy().bladderRadius_m;
    EndoscopeMotion motion = randomMotion(random, forces.centreline());
    motion.p_A = neck.p_A + R * neck.t_A + random.uniform(R - 0.008, R + 0.002) * way.normalized();
    return motion;
}

inline UrethraAnatomy strictured() {
    UrethraAnatomy anatomy;
    anatomy.changeCount = 1;
    anatomy.changes[0].centre_m = 0.080;
    anatomy.changes[0].stiffnessFactor = 15.0;
    anatomy.changes[0].frictionFactor = 1.3;
    return anatomy;
}

inline UrethraForceSettings basic() {
    UrethraForceSettings settings;
    settings.sections = ForceSections::p1Basic;
    return settings;
}

inline Endoscope thin() {
    Endoscope scope;
    scope.radius_m = 0.002; // 12 Fr in a canal of 5 mm: plays freely by 0.5 mm
    return scope;
}

inline UrethraAnatomy held() {
    UrethraAnatomy anatomy;
    anatomy.freeHold_N_per_m = 600.0;
    return anatomy;
}

/// As the shipped levels have it: straight up to B, a pelvic floor that the shaft pivots at.
inline UrethraAnatomy bentAtB() {
    UrethraAnatomy anatomy = held();
    anatomy.straight_m = 0.035;
    anatomy.zEnd_m = 0.100;
    anatomy.pivotSpan_m = 0.020;
    anatomy.wallRetardation_s = 0.005;
    return anatomy;
}

/// The anatomies, endoscopes and grids over which the laws must hold.
struct Variant {
    const char* name;
    UrethraAnatomy anatomy;
    Endoscope endoscope;
    UrethraForceSettings settings;
};

inline std::vector<Variant> variants() {
    return {{"normal", {}, {}, {}},
            {"stricture", strictured(), {}, {}},
            {"26 drawn sections", {}, {}, basic()},
            {"thin endoscope in a stricture", strictured(), thin(), {}},
            {"held free part", held(), {}, {}},
            {"bent at B", bentAtB(), {}, {}}};
}

} // namespace chiron::simulation::testing
