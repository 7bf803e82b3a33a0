// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/procedure_tracker.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

namespace chiron::simulation {

/// Goal beyond the bladder neck where a level gives no depth of its own: the tip is in the bladder's cavity,
/// past the neck's rounded wall.
inline constexpr double kGoalBeyondNeck_m = 0.010;

/// A procedure starts with the tip on the straight line before the entrance, at this distance outside.
inline constexpr double kStartBeforeEntrance_m = 0.025;

/// Centre of the bladder's sphere, whose wall meets the centre-line at C: C + R t(C).
/// Unit: m.
/// Frame: A.
core::Vec3 bladderCentre_A(const UrethraAnatomy& anatomy, const UrethraCentreline& line) noexcept;

/// Position of a landmark of the bladder: centre + R (cos θ t + sin θ (cos φ x̂ + sin φ n)), with θ polar and
/// φ azimuth in the frame of C.
/// Unit: m.
/// Frame: A.
core::Vec3 landmark_A(const UrethraAnatomy& anatomy, const UrethraCentreline& line,
                      const BladderLandmark& landmark) noexcept;

/// The requirements of a level as the tracker follows them. Landmarks beyond the sixteenth are omitted
/// (content with more is refused before).
ProcedurePlan procedurePlan(const UrethraInsertionParameters& parameters) noexcept;

/// The endoscope's axis in W, a unit vector: the endoscope looks along −z of T.
inline core::Vec3 endoscopeAxis_W(const core::Quat& q_WT) noexcept {
    return -(q_WT * core::Vec3::UnitZ());
}

} // namespace chiron::simulation
