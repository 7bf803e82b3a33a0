// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

core::Vec3 bladderCentre_A(const UrethraAnatomy& anatomy, const UrethraCentreline& line) noexcept {
    const CentrelinePoint neck = line.atZ(anatomy.zEnd_m);
    return neck.p_A + anatomy.bladderRadius_m * neck.t_A;
}

core::Vec3 landmark_A(const UrethraAnatomy& anatomy, const UrethraCentreline& line,
                      const BladderLandmark& landmark) noexcept {
    const CentrelinePoint neck = line.atZ(anatomy.zEnd_m);
    const core::Vec3 across =
        std::cos(landmark.azimuth_rad) * core::Vec3::UnitX() + std::sin(landmark.azimuth_rad) * neck.n_A;
    return bladderCentre_A(anatomy, line) +
           anatomy.bladderRadius_m *
               (std::cos(landmark.polar_rad) * neck.t_A + std::sin(landmark.polar_rad) * across);
}

ProcedurePlan procedurePlan(const UrethraInsertionParameters& parameters) noexcept {
    const UrethraCentreline line(parameters.anatomy);
    ProcedurePlan plan;
    plan.beak_m = parameters.endoscope.beak_m;
    plan.meatus_m = parameters.meatus_m;
    plan.neck_m = line.length_m();
    plan.goal_m = parameters.goalDepth_m > 0.0 ? parameters.goalDepth_m : plan.neck_m + kGoalBeyondNeck_m;
    plan.withdraws = parameters.withdraws;
    plan.landmarks = std::min(parameters.landmarks.size(), ProcedurePlan::kMaxLandmarks);
    for (std::size_t i = 0; i < plan.landmarks; ++i) {
        const core::Vec3 p_A = landmark_A(parameters.anatomy, line, parameters.landmarks[i]);
        plan.landmark_A[i] = {p_A.x(), p_A.y(), p_A.z()};
    }
    plan.cosHalfAngle = std::cos(parameters.landmarkHalfAngle_rad);
    plan.distance_m = parameters.landmarkDistance_m;
    plan.speed_m_per_s = parameters.landmarkSpeed_m_per_s;
    plan.hold_us = static_cast<std::uint64_t>(std::llround(std::max(0.0, parameters.landmarkHold_s) * 1e6));
    return plan;
}

} // namespace chiron::simulation
