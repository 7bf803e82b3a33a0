// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/session/elastic_tube_kind.h"

#include "app/exercises/elastic_tube/session/planned_tube.h"
#include "modules/exercises/elastic_tube/operators/elastic_tube_operator.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"
#include "session/laparoscopy_steps.h"
#include "session/moment_rule.h"
#include "session/session_setup.h"

#include <cmath>

namespace chiron::session {

namespace {

using simulation::TubeTask;

const simulation::ElasticTubeParameters& parametersOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.as<simulation::ElasticTubeParameters>();
}

/// Arming takes 2 s and a person may first have to let go; beyond this a scripted run is stuck.
constexpr double kArmingAllowance_s = 20.0;

/// A retractor enters behind the field, so that it pulls tissue away from the hands that work there
/// (assumption).
constexpr double kRetractorBehind_m = 0.040;

class ElasticTubeSurfaces final : public TrialSurfaces {
public:
    ElasticTubeSurfaces(const simulation::ElasticTubeParameters& p, std::uint64_t seed)
        : m_radius_m(p.radius_m) {
        for (const simulation::ElasticTubeTrial& trial : simulation::planElasticTubeTrials(p, seed))
            m_bases.emplace_back(trial.base_m.x(), trial.base_m.y(), 0.0);
    }
    std::optional<TrialObject> object(int trial) const override {
        const auto index = static_cast<std::size_t>(trial);
        if (trial < 0 || index >= m_bases.size())
            return std::nullopt;
        return TrialObject{m_bases[index], m_radius_m, {}};
    }
    core::Vec3 surfacePoint(int, const core::Vec3& p_WT) const override { return p_WT; }

private:
    double m_radius_m;
    std::vector<core::Vec3> m_bases;
};

} // namespace

LevelTools ElasticTubeKind::tools(const catalogue::ExerciseLevel& level) const {
    return {.count = parametersOf(level).tools()};
}

devices::WorkspaceMapping ElasticTubeKind::toolPlace(const catalogue::ExerciseLevel& level, int tool) const {
    const auto& p = parametersOf(level);
    devices::WorkspaceMapping place;
    if (p.hasFold() && tool == p.retractor())
        place.origin_m[1] = kRetractorBehind_m;
    else if (p.hands() > 1)
        place.origin_m[0] = (tool == 0 ? 0.5 : -0.5) * p.instrumentsApart_m;
    return place;
}

std::vector<core::QuantityDescription>
ElasticTubeKind::quantities(const catalogue::ExerciseLevel& level) const {
    std::vector<core::QuantityDescription> out{{"tension_N", "N", 1e-3},    {"stretch_m", "m", 1e-6},
                                               {"grip_0", "1", 1.0},        {"grip_1", "1", 1.0},
                                               {"grip_2", "1", 1.0},        {"free_end_x_m", "m", 1e-6},
                                               {"free_end_y_m", "m", 1e-6}, {"free_end_z_m", "m", 1e-6},
                                               {"step", "1", 1.0},          {"dwell", "1", 1e-3}};
    if (parametersOf(level).hasFold())
        for (const core::QuantityDescription& one : {core::QuantityDescription{"retraction_N", "N", 1e-3},
                                                     {"fold_open", "1", 1.0},
                                                     {"fold_edge_x_m", "m", 1e-6},
                                                     {"fold_edge_y_m", "m", 1e-6},
                                                     {"fold_edge_z_m", "m", 1e-6}})
            out.push_back(one);
    return out;
}

std::unique_ptr<simulation::IScene> ElasticTubeKind::makeScene(const SessionSetup& setup) const {
    return std::make_unique<simulation::ElasticTubeScene>(parametersOf(setup.level), setup.seed);
}

simulation::YieldLaw ElasticTubeKind::yieldLaw(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).yield;
}

core::Result<ScriptedTrainee> ElasticTubeKind::makeOperator(const catalogue::ExerciseLevel& level,
                                                            const std::string& name, std::uint64_t seed,
                                                            const HeldDevices& held) const {
    auto settings = operators::elasticTubeOperatorSettings(name);
    CHIRON_TRY(settings);
    const auto& p = parametersOf(level);
    operators::ElasticTubeBriefing briefing;
    briefing.goal = p.task == TubeTask::stretch    ? operators::TubeGoal::mark
                    : p.task == TubeTask::transfer ? operators::TubeGoal::bring
                                                   : operators::TubeGoal::tension;
    briefing.markRatio = p.markRatio;
    briefing.markTolerance = p.markTolerance;
    briefing.retracts = p.hasFold();
    briefing.places.assign(held.places.begin(), held.places.end());
    auto strategies = operators::makeElasticTubeOperator(*settings, briefing, seed);
    CHIRON_TRY(strategies);
    return ScriptedTrainee{std::move(*strategies), settings->hand};
}

std::vector<std::string> ElasticTubeKind::operatorNames() const {
    const auto names = operators::elasticTubeOperatorNames();
    return {names.begin(), names.end()};
}

int ElasticTubeKind::trialCount(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).trials;
}

double ElasticTubeKind::forceLimit_N(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).maximumForce_N;
}

std::vector<LimitedMetric> ElasticTubeKind::limitedMetrics(const catalogue::ExerciseLevel&) const {
    return {{.metric = "retraction_max"}};
}

std::uint64_t ElasticTubeKind::tickLimit(const catalogue::ExerciseLevel& level) const {
    const auto& p = parametersOf(level);
    return static_cast<std::uint64_t>(
        std::ceil(1000.0 * p.trials * (p.trialLimit_s + p.betweenTrials_s + kArmingAllowance_s)));
}

void ElasticTubeKind::addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                               scoring::TrialTrace& trial) const {
    const auto planned = plannedTubes(parametersOf(level), seed);
    const auto index = static_cast<std::size_t>(trial.trial);
    if (trial.trial >= 0 && index < planned.size())
        trial.truth = scoring::valuesOf(planned[index]);
}

std::unique_ptr<TrialSurfaces> ElasticTubeKind::makeSurfaces(const catalogue::ExerciseLevel& level,
                                                             std::uint64_t seed) const {
    return std::make_unique<ElasticTubeSurfaces>(parametersOf(level), seed);
}

Demonstration ElasticTubeKind::demonstration() const {
    return {.columns = {{">error N", "tension_error_rms", 2},
                        {">in band %", "retraction_time_in_band", 0},
                        {">over", "over_stretches", 0},
                        {">drops", "drops", 0}},
            .legend = "error: RMS distance of the tension from its target; in band: share of the time, once "
                      "the fold was held back, in\n"
                      "which its pull was in its band; over: times the tube was stretched too far; drops: "
                      "times it was let go\n"};
}

core::Result<void> ElasticTubeKind::addMarks(const SessionSetup&, const scoring::SessionTrace*,
                                             PlaybackTrack& track) const {
    nameSteps(track);
    return {};
}

std::vector<MomentRule> ElasticTubeKind::momentRules() const {
    using namespace mark_kinds;
    return {{.metric = "over_stretches", .marks = {kDamaged, kFailed}},
            {.metric = "drops", .marks = {kSlipped}},
            {.metric = "retraction_max",
             .by = MomentRule::By::largestQuantity,
             .quantity = "retraction_N",
             .unit = "N"},
            {.metric = "procedure_completed", .marks = {kFailed}, .spread = true}}; // where it tore
}

} // namespace chiron::session
