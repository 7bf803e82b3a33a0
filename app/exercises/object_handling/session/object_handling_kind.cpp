// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/session/object_handling_kind.h"

#include "app/exercises/object_handling/session/planned_handling.h"
#include "modules/exercises/object_handling/operators/object_handling_operator.h"
#include "modules/exercises/object_handling/simulation/object_handling_plan.h"
#include "modules/exercises/object_handling/simulation/object_handling_scene.h"
#include "session/laparoscopy_steps.h"
#include "session/level_cues.h"
#include "session/moment_rule.h"
#include "session/session_setup.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

const simulation::ObjectHandlingParameters& parametersOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.as<simulation::ObjectHandlingParameters>();
}

/// Arming takes 2 s and a person may first have to move out of contact; beyond this a scripted run is stuck.
constexpr double kArmingAllowance_s = 20.0;

class ObjectHandlingSurfaces final : public TrialSurfaces {
public:
    ObjectHandlingSurfaces(const simulation::ObjectHandlingParameters& p, std::uint64_t seed) {
        for (const simulation::ObjectHandlingTrial& trial : simulation::planObjectHandlingTrials(p, seed))
            m_targets.push_back({{trial.target_m.x(), trial.target_m.y(), 0.0}, p.targetRadius_m, {}});
    }
    std::optional<TrialObject> object(int trial) const override {
        const auto index = static_cast<std::size_t>(trial);
        if (trial < 0 || index >= m_targets.size())
            return std::nullopt;
        return m_targets[index];
    }
    core::Vec3 surfacePoint(int trial, const core::Vec3& p_WT) const override {
        if (trial < 0 || static_cast<std::size_t>(trial) >= m_targets.size() || !p_WT.allFinite())
            return p_WT;
        return {p_WT.x(), p_WT.y(), std::max(0.0, p_WT.z())};
    }

private:
    std::vector<TrialObject> m_targets;
};

} // namespace

std::vector<core::QuantityDescription>
ObjectHandlingKind::quantities(const catalogue::ExerciseLevel& level) const {
    std::vector<core::QuantityDescription> out{
        {"step", "1", 1.0}, {"dwell", "1", 0.001}, {"squeeze_N", "N", 0.001}, {"held", "1", 1.0}};
    for (std::size_t i = 0; i < simulation::ObjectHandlingTrial::kMaxObjects; ++i)
        for (const char* axis : {"x", "y", "z"})
            out.push_back({"body_" + std::to_string(i) + "_" + axis + "_m", "m", 1e-6});
    out.push_back({"bed_depth_m", "m", 1e-6});
    if (parametersOf(level).organBed) {
        out.push_back({"prediction_error_m", "m", 1e-7});
        out.push_back({"held_error_m", "m", 1e-7});
    }
    return out;
}

std::unique_ptr<simulation::IScene> ObjectHandlingKind::makeScene(const SessionSetup& setup) const {
    simulation::ObjectHandlingParameters parameters = parametersOf(setup.level);
    parameters.cues = cueWordsOf(setup.level, setup.felt()); // if force cannot be felt, it is shown
    return std::make_unique<simulation::ObjectHandlingScene>(parameters, setup.seed);
}

simulation::YieldLaw ObjectHandlingKind::yieldLaw(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).yield;
}

core::Result<ScriptedTrainee> ObjectHandlingKind::makeOperator(const catalogue::ExerciseLevel& level,
                                                               const std::string& name, std::uint64_t seed,
                                                               const HeldDevices& held) const {
    auto settings = operators::objectHandlingOperatorSettings(name);
    CHIRON_TRY(settings);
    const auto& p = parametersOf(level);
    operators::ObjectHandlingBriefing briefing;
    briefing.weigh = p.task == simulation::HandlingTask::weigh;
    briefing.liftHeight_m = p.liftHeight_m;
    briefing.jawLength_m = p.jawLength_m;
    briefing.place = held.places.front();
    auto strategies = operators::makeObjectHandlingOperator(*settings, briefing, seed);
    CHIRON_TRY(strategies);
    ScriptedTrainee trainee;
    trainee.strategies = std::move(*strategies);
    trainee.hand = settings->hand;
    return trainee;
}

std::vector<std::string> ObjectHandlingKind::operatorNames() const {
    const auto names = operators::objectHandlingOperatorNames();
    return {names.begin(), names.end()};
}

int ObjectHandlingKind::trialCount(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).trials;
}

double ObjectHandlingKind::forceLimit_N(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).maximumForce_N;
}

std::vector<LimitedMetric> ObjectHandlingKind::limitedMetrics(const catalogue::ExerciseLevel& level) const {
    return {{.metric = "squeeze_max", .own = parametersOf(level).squeezeLimit_N},
            {.metric = "placement_error"}};
}

std::uint64_t ObjectHandlingKind::tickLimit(const catalogue::ExerciseLevel& level) const {
    const auto& p = parametersOf(level);
    return static_cast<std::uint64_t>(
        std::ceil(1000.0 * p.trials * (p.trialLimit_s + p.betweenTrials_s + kArmingAllowance_s)));
}

void ObjectHandlingKind::addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                                  scoring::TrialTrace& trial) const {
    const auto planned = plannedHandling(parametersOf(level), seed);
    const auto index = static_cast<std::size_t>(trial.trial);
    if (trial.trial >= 0 && index < planned.size())
        trial.truth = scoring::valuesOf(planned[index]);
}

std::unique_ptr<TrialSurfaces> ObjectHandlingKind::makeSurfaces(const catalogue::ExerciseLevel& level,
                                                                std::uint64_t seed) const {
    return std::make_unique<ObjectHandlingSurfaces>(parametersOf(level), seed);
}

Demonstration ObjectHandlingKind::demonstration() const {
    return {.columns = {{">squeeze N", "squeeze_max", 2},
                        {">too hard s", "squeeze_time_over_limit", 1},
                        {">placed mm", "placement_error", 1},
                        {">weighed %", "weighing_correct", 0}},
            .legend = "squeeze: the largest; too hard: time over the squeeze that the object bears; placed: "
                      "mean distance from the middle of the\n"
                      "target; weighed: weighings that were answered rightly\n"};
}

core::Result<void> ObjectHandlingKind::addMarks(const SessionSetup&, const scoring::SessionTrace*,
                                                PlaybackTrack& track) const {
    nameSteps(track);
    return {};
}

std::vector<MomentRule> ObjectHandlingKind::momentRules() const {
    return {
        {.metric = "squeeze_*", .by = MomentRule::By::largestQuantity, .quantity = "squeeze_N", .unit = "N"}};
}

} // namespace chiron::session
