// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/sweep_facts.h"

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_centreline.h"

namespace chiron::tests {

namespace {

/// The canal turns the endoscope, and nobody meets a meatus by chance: along the canal and out again.
void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers) {
    constexpr double kMostTwist_rad = 1.5;
    const auto& urethra = level.parameters.as<simulation::UrethraInsertionParameters>();
    const simulation::UrethraAnatomy& anatomy = urethra.anatomy;
    const simulation::UrethraCentreline line(anatomy);
    const double span_m = anatomy.pivotSpan_m, turning_m = line.length_m() - anatomy.straight_m;
    numbers.turn_Nm_per_rad = anatomy.angularStiffness_Nm_per_rad;
    numbers.turn_Nm_per_m =
        numbers.turn_Nm_per_rad *
        (2.0 * anatomy.curvature_per_m + (span_m > 0.0 ? 0.5 / span_m : 0.0) + kMostTwist_rad / turning_m);
    numbers.shaft_m = urethra.endoscope.radius_m;
    for (const double s_m :
         {-0.012, -0.004, 0.010, 0.030, 0.050, 0.070, 0.090, 0.110, line.length_m(), line.length_m() + 0.015})
        numbers.way_W.push_back(urethra.pose.pointToW(line.at(s_m).p_A));
}

const SweepFacts kFacts("urethra_insertion", complete);

} // namespace

} // namespace chiron::tests
