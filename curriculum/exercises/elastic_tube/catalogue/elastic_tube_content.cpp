// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/elastic_tube/catalogue/elastic_tube_content.h"

#include "catalogue/object_content.h"
#include "catalogue/yield_content.h"
#include "core/units.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <algorithm>
#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::ElasticTubeParameters;
using simulation::TubeTask;

constexpr double kMm = 1000.0;
constexpr double kDeg = 180.0 / core::kPi;

struct Number {
    const char* name;
    double& (*in)(Parameters&);
    double perUnit; ///< content units per SI unit
};

constexpr Number kNumbers[] = {
    {"stiffness_low_N_per_m", [](Parameters& p) -> double& { return p.stiffnessLow_N_per_m; }, 1.0},
    {"stiffness_high_N_per_m", [](Parameters& p) -> double& { return p.stiffnessHigh_N_per_m; }, 1.0},
    {"rest_length_mm", [](Parameters& p) -> double& { return p.restLength_m; }, kMm},
    {"radius_mm", [](Parameters& p) -> double& { return p.radius_m; }, kMm},
    {"base_x_mm", [](Parameters& p) -> double& { return p.baseX_m; }, kMm},
    {"base_y_mm", [](Parameters& p) -> double& { return p.baseY_m; }, kMm},
    {"base_spread_mm", [](Parameters& p) -> double& { return p.baseSpread_m; }, kMm},
    {"tear_ratio", [](Parameters& p) -> double& { return p.tearRatio; }, 1.0},
    {"over_stretch_ratio", [](Parameters& p) -> double& { return p.overStretchRatio; }, 1.0},
    {"target_low_N", [](Parameters& p) -> double& { return p.targetLow_N; }, 1.0},
    {"target_high_N", [](Parameters& p) -> double& { return p.targetHigh_N; }, 1.0},
    {"band_N", [](Parameters& p) -> double& { return p.band_N; }, 1.0},
    {"mark_ratio", [](Parameters& p) -> double& { return p.markRatio; }, 1.0},
    {"mark_tolerance", [](Parameters& p) -> double& { return p.markTolerance; }, 1.0},
    {"target_x_mm", [](Parameters& p) -> double& { return p.targetX_m; }, kMm},
    {"target_y_mm", [](Parameters& p) -> double& { return p.targetY_m; }, kMm},
    {"target_z_mm", [](Parameters& p) -> double& { return p.targetZ_m; }, kMm},
    {"target_radius_mm", [](Parameters& p) -> double& { return p.targetRadius_m; }, kMm},
    {"grip_share", [](Parameters& p) -> double& { return p.gripShare; }, 1.0},
    {"hold_s", [](Parameters& p) -> double& { return p.hold_s; }, 1.0},
    {"grasp_reach_mm", [](Parameters& p) -> double& { return p.graspReach_m; }, kMm},
    {"grasp_angle_deg", [](Parameters& p) -> double& { return p.graspAngle_rad; }, kDeg},
    {"release_angle_deg", [](Parameters& p) -> double& { return p.releaseAngle_rad; }, kDeg},
    {"instruments_apart_mm", [](Parameters& p) -> double& { return p.instrumentsApart_m; }, kMm},
    {"fold_stiffness_N_per_m", [](Parameters& p) -> double& { return p.foldStiffness_N_per_m; }, 1.0},
    {"retraction_low_N", [](Parameters& p) -> double& { return p.retractionLow_N; }, 1.0},
    {"retraction_high_N", [](Parameters& p) -> double& { return p.retractionHigh_N; }, 1.0},
    {"trial_limit_s", [](Parameters& p) -> double& { return p.trialLimit_s; }, 1.0},
    {"between_trials_s", [](Parameters& p) -> double& { return p.betweenTrials_s; }, 1.0},
    {"maximum_force_N", [](Parameters& p) -> double& { return p.maximumForce_N; }, 1.0},
};

constexpr std::pair<const char*, TubeTask> kTasks[] = {
    {"hold", TubeTask::hold},
    {"stretch", TubeTask::stretch},
    {"two_handed", TubeTask::twoHanded},
    {"transfer", TubeTask::transfer},
};

void readTask(const ObjectReader& parameters, Parameters& p) {
    const std::string given = parameters.text("task");
    for (const auto& [name, task] : kTasks)
        if (given == name) {
            p.task = task;
            return;
        }
    parameters.problems().push_back(
        {memberPath(parameters.path(), "task"), quoted(QString::fromStdString(given)),
         QStringLiteral("\"hold\", \"stretch\", \"two_handed\" or \"transfer\"")});
}

void refuseUnknownKeys(const ObjectReader& parameters) {
    std::vector<QString> known{QStringLiteral("task"), QStringLiteral("trials"), QStringLiteral("tube")};
    for (const Number& key : kNumbers)
        known.push_back(QLatin1String(key.name));
    for (const char* key : kYieldKeys)
        known.push_back(QLatin1String(key));
    for (const QString& key : parameters.json().keys())
        if (std::find(known.begin(), known.end(), key) == known.end())
            parameters.problems().push_back(
                {memberPath(parameters.path(), key), QStringLiteral("unknown key"),
                 QStringLiteral("a parameter of elastic_tube") + didYouMean(key, known)});
}

} // namespace

ExerciseParameters readElasticTube(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Parameters p;
    for (const Number& key : kNumbers)
        if (parameters.has(QLatin1String(key.name)))
            key.in(p) = parameters.number(QLatin1String(key.name)) / key.perUnit;
    readYield(parameters, p.yield);
    if (parameters.has("trials"))
        p.trials = parameters.integer("trials");
    if (parameters.has("task"))
        readTask(parameters, p);
    if (parameters.has("tube"))
        p.tube = readObject(parameters.object("tube"));
    refuseUnknownKeys(parameters);
    p.cues = cues;
    return ExerciseParameters(std::move(p));
}

} // namespace chiron::catalogue
