// SPDX-License-Identifier: GPL-3.0-or-later
// Called in the tick in which the next tube appears, and therefore kept apart from the plan, which allocates.
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"

namespace chiron::simulation {

namespace {

/// Time constant with which a released part returns where the object names none: an assumption.
constexpr double kRecovery_s = 0.1;

// The fold is our choice: it hangs 10 mm above the floor a little before the tube, does not tear within an
// instrument's reach, and falls back quickly.
constexpr double kFoldHeight_m = 0.010;
constexpr double kFoldBefore_m = 0.004;
constexpr double kFoldReach_m = 0.200;
constexpr double kFoldRecovery_s = 0.15;

} // namespace

TubeLaw elasticTubeLaw(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept {
    TubeLaw law;
    law.elastic = {trial.stiffness_N_per_m, parameters.tube.stiffening_per_m};
    law.viscosity_Ns_per_m = parameters.tube.viscosity_Ns_per_m;
    law.limit_m = (parameters.tearRatio - 1.0) * parameters.restLength_m;
    return law;
}

TubeShape elasticTubeShape(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept {
    TubeShape shape;
    shape.law = elasticTubeLaw(parameters, trial);
    shape.length_m = parameters.restLength_m;
    shape.radius_m = parameters.radius_m;
    shape.fixed = parameters.task != TubeTask::twoHanded;
    shape.base = {trial.base_m.x(), trial.base_m.y(), 0.0};
    shape.recovery_s = parameters.tube.recoveryTime_s > 0.0 ? parameters.tube.recoveryTime_s : kRecovery_s;
    if (parameters.task == TubeTask::transfer) {
        shape.nodes = 3;
        shape.share = {0.0, parameters.gripShare, 1.0};
    } else {
        shape.nodes = 2;
        shape.share = {0.0, 1.0, 1.0};
    }
    return shape;
}

TubeShape tissueFoldShape(const ElasticTubeParameters& parameters, const ElasticTubeTrial& trial) noexcept {
    TubeShape shape;
    shape.law.elastic = {parameters.foldStiffness_N_per_m, 0.0};
    shape.law.viscosity_Ns_per_m = parameters.tube.viscosity_Ns_per_m;
    shape.law.limit_m = kFoldReach_m;
    shape.length_m = kFoldHeight_m;
    shape.radius_m = parameters.radius_m;
    shape.nodes = 2;
    shape.share = {0.0, 1.0, 1.0};
    shape.fixed = true;
    shape.base = {trial.base_m.x(), trial.base_m.y() - kFoldBefore_m, 0.0};
    shape.recovery_s = kFoldRecovery_s;
    return shape;
}

} // namespace chiron::simulation
