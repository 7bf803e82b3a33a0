// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/geometry.h"

#include <string_view>
#include <vector>

namespace chiron::tests {

inline constexpr double kSteepest = 1.5; ///< of a smoothstep, in its middle

/// What a level's content says of how its force may change: read from the keys that every exercise has in
/// common, and completed by the exercise's own SweepFacts.
struct LevelNumbers {
    double yield_N = 0.0;  ///< 0: never
    double yield_Nm = 0.0; ///< 0: never
    double fall_ms = 20.0;
    double breaks_N_per_ms = 0.0;   ///< how fast the force may fall where something is meant to break
    double bristle_N_per_m = 0.0;   ///< stick of friction: a stiffness across, which a scene does not report
    double largest_Ns_per_m = 50.0; ///< b_max: with a change of speed a force may change by that much
    double damping_Ns_per_m = 0.0;  ///< faded in with depth: at a speed v a stiffness of b v / fade_m at most
    double fade_m = 0.0005;
    double turn_Nm_per_rad = 0.0; ///< how stiff the tissue turns the tool back; 0: not at all
    double turn_Nm_per_m =
        0.0; ///< the same for a way: the canal turns along it, the pivot's lever, and it gets stiffer
    double shaft_m = 0.0;            ///< radius: at which forces turn the tool
    std::vector<core::Vec3> way_W{}; ///< a way that nobody meets by chance, to be gone again and again
};

/// What a sweep must know of one exercise that the common keys do not say. An exercise that needs it has a
/// file tests/exercises/<id>/sweep_facts.cpp with one object of this class; the file is found by its name.
class SweepFacts {
public:
    using Complete = void (*)(const catalogue::ExerciseLevel& level, LevelNumbers& numbers);

    SweepFacts(std::string_view exercise, Complete completes);

    /// Completes the numbers of a level, where its exercise has something to say.
    static void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers);
};

} // namespace chiron::tests
