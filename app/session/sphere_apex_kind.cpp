// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sphere_apex_kind.h"

#include "operators/sphere_apex/sphere_apex_operator.h"
#include "simulation/exercises/sphere_apex/sphere_apex_plan.h"
#include "simulation/exercises/sphere_apex/sphere_apex_scene.h"

#include <cmath>

namespace chiron::session {

namespace {

const simulation::SphereApexParameters& parametersOf(const catalogue::ExerciseLevel& level) {
    return std::get<simulation::SphereApexParameters>(level.parameters);
}

/// Arming takes 2 s and a person may first have to move out of contact; beyond this a scripted run is stuck.
constexpr double kArmingAllowance_s = 20.0;

} // namespace

std::unique_ptr<simulation::IScene> SphereApexKind::makeScene(const catalogue::ExerciseLevel& level,
                                                              std::uint64_t seed) const {
    return std::make_unique<simulation::SphereApexScene>(parametersOf(level), seed);
}

core::Result<ScriptedTrainee> SphereApexKind::makeOperator(const std::string& name, std::uint64_t seed) const {
    auto settings = operators::sphereApexOperatorSettings(name);
    if (!settings)
        return tl::unexpected(settings.error());
    auto strategy = operators::makeSphereApexOperator(*settings, seed);
    if (!strategy)
        return tl::unexpected(strategy.error());
    return ScriptedTrainee{std::move(*strategy), settings->hand};
}

std::vector<std::string> SphereApexKind::operatorNames() const {
    const auto names = operators::sphereApexOperatorNames();
    return {names.begin(), names.end()};
}

int SphereApexKind::trialCount(const catalogue::ExerciseLevel& level) const { return parametersOf(level).trials; }

double SphereApexKind::forceLimit_N(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).maximumForce_N;
}

std::uint64_t SphereApexKind::tickLimit(const catalogue::ExerciseLevel& level) const {
    const auto& p = parametersOf(level);
    return static_cast<std::uint64_t>(
        std::ceil(1000.0 * p.trials * (p.trialLimit_s + p.betweenTrials_s + kArmingAllowance_s)));
}

void SphereApexKind::addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                              scoring::TrialTrace& trial) const {
    const auto& p = parametersOf(level);
    const auto plan = simulation::planSphereApexTrials(p, seed);
    const auto index = static_cast<std::size_t>(trial.trial);
    if (index < plan.size())
        trial.apex = scoring::ApexTruth{plan[index].centre_m.x(), plan[index].centre_m.y(), p.radius_m};
}

} // namespace chiron::session
