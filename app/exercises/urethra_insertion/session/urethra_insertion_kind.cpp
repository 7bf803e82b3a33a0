// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session/urethra_insertion_kind.h"

#include "app/exercises/urethra_insertion/session/device_friction.h"
#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "app/exercises/urethra_insertion/session/insertion_series.h"
#include "app/exercises/urethra_insertion/session/playback_insertion.h"
#include "core/units.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "modules/exercises/urethra_insertion/operators/urethra_insertion_operator.h"
#include "modules/exercises/urethra_insertion/simulation/drawn_tip.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_scene.h"
#include "session/moment_rule.h"
#include "session/session_setup.h"

#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace chiron::session {

namespace {

constexpr int kCystoscopyLevel = 3;    // P1's whole procedure in normal tissue
constexpr double kBendMark_deg = 15.0; // pass mark of the levels that have a bend (content/README.md)

const simulation::UrethraInsertionParameters& parametersOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.as<simulation::UrethraInsertionParameters>();
}

/// Arming takes 2 s and a person may first have to move out of contact; beyond this a scripted run is stuck.
constexpr double kArmingAllowance_s = 20.0;

/// The canal has no object that has to be found; playback only needs the drawn position of the tip.
class UrethraInsertionSurfaces final : public TrialSurfaces {
public:
    explicit UrethraInsertionSurfaces(const simulation::UrethraInsertionParameters& p) : m_drawn(p) {}
    std::optional<TrialObject> object(int) const override { return std::nullopt; }
    core::Vec3 surfacePoint(int trial, const core::Vec3& p_WT) const override {
        return trial == 0 ? m_drawn.inW(p_WT) : p_WT;
    }

private:
    simulation::DrawnTip m_drawn;
};

std::optional<double> depthIn(const PlaybackTrack& track, double t_s) {
    const auto moment = insertionAt(track, t_s);
    return moment && std::isfinite(moment->depth_m) ? std::optional(moment->depth_m) : std::nullopt;
}

/// The moment of a trial at which the endoscope was deepest in its canal.
std::optional<WorstMoment> deepest(const PlaybackTrack& track) {
    std::optional<WorstMoment> worst;
    for (const PlaybackMoment& moment : track.moments) {
        if (moment.paused || moment.phase != core::TrialPhase::running)
            continue;
        const std::optional<double> depth_m = depthIn(track, moment.t_s);
        if (!depth_m || (worst && core::mmFromM(*depth_m) <= worst->value))
            continue;
        worst.emplace();
        worst->t_s = moment.t_s;
        worst->trial = moment.trial;
        worst->value = core::mmFromM(*depth_m);
        worst->unit = "mm";
    }
    return worst;
}

constexpr SceneEvent kSceneEvents[]{
    {simulation::procedure_bits::kLandmarkSeen, "landmark_seen", mark_kinds::kLandmarkSeen},
};

} // namespace

std::optional<core::Vec3> UrethraInsertionKind::toolStart_W(const catalogue::ExerciseLevel&,
                                                            const devices::WorkspaceMapping&) const {
    return simulation::AnatomyPose{}.pointToW({0.0, 0.0, -simulation::kStartBeforeEntrance_m});
}

std::unique_ptr<simulation::IScene> UrethraInsertionKind::makeScene(const SessionSetup& setup) const {
    simulation::UrethraInsertionParameters felt = parametersOf(setup.level);
    if (!setup.devices.empty() && !setup.mappings.empty())
        felt.forces = onDevice(felt.forces, setup.devices[0], setup.mappings[0]);
    return std::make_unique<simulation::UrethraInsertionScene>(felt);
}

simulation::YieldLaw UrethraInsertionKind::yieldLaw(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).yield;
}

core::Result<ScriptedTrainee> UrethraInsertionKind::makeOperator(const catalogue::ExerciseLevel&,
                                                                 const std::string& name, std::uint64_t seed,
                                                                 const HeldDevices&) const {
    auto settings = operators::urethraInsertionOperatorSettings(name);
    CHIRON_TRY(settings);
    auto strategy = operators::makeUrethraInsertionOperator(*settings, seed);
    CHIRON_TRY(strategy);
    return oneHanded(std::move(*strategy), settings->hand);
}

std::vector<std::string> UrethraInsertionKind::operatorNames() const {
    const auto names = operators::urethraInsertionOperatorNames();
    return {names.begin(), names.end()};
}

int UrethraInsertionKind::trialCount(const catalogue::ExerciseLevel&) const {
    return 1;
}

double UrethraInsertionKind::forceLimit_N(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).maximumForce_N;
}

std::vector<LimitedMetric> UrethraInsertionKind::limitedMetrics(const catalogue::ExerciseLevel& level) const {
    return {{.metric = "lateral_max", .own = parametersOf(level).lateralLimit_N}};
}

SessionCaps UrethraInsertionKind::caps(const catalogue::ExerciseLevel& level) const {
    return {.torque_Nm = parametersOf(level).maximumTorque_Nm, .knee = 0.2};
}

std::uint64_t UrethraInsertionKind::tickLimit(const catalogue::ExerciseLevel& level) const {
    return static_cast<std::uint64_t>(
        std::ceil(1000.0 * (parametersOf(level).trialLimit_s + kArmingAllowance_s)));
}

void UrethraInsertionKind::addTruth(const catalogue::ExerciseLevel& level, std::uint64_t,
                                    scoring::TrialTrace& trial) const {
    if (auto series = insertionSeries(parametersOf(level), trial))
        trial.own = std::make_shared<scoring::InsertionSeries>(std::move(*series));
    else
        trial.own.reset();
}

std::unique_ptr<TrialSurfaces> UrethraInsertionKind::makeSurfaces(const catalogue::ExerciseLevel& level,
                                                                  std::uint64_t) const {
    return std::make_unique<UrethraInsertionSurfaces>(parametersOf(level));
}

core::Result<void> UrethraInsertionKind::addMarks(const SessionSetup& setup,
                                                  const scoring::SessionTrace* trace,
                                                  PlaybackTrack& track) const {
    const auto& metrics = setup.level.metrics;
    const bool traumaIsCritical =
        std::any_of(metrics.begin(), metrics.end(), [](const catalogue::MetricChoice& metric) {
            return metric.id == "critical_errors" && metric.version >= scoring::kCriticalSpansCountFrom;
        });
    CHIRON_TRY(addInsertionMarks(track, *trace, setup.level.gates, traumaIsCritical));
    addInsertion(track, *trace);
    return {};
}

void UrethraInsertionKind::storeTruth(const scoring::TrialTrace& trial, QJsonObject& truth) const {
    const scoring::InsertionSeries* insertion = scoring::insertionOf(trial);
    if (insertion == nullptr)
        return;
    QJsonArray seen_s;
    for (const double t_s : insertion->landmarkSeen_s)
        seen_s.append(std::isnan(t_s) ? QJsonValue() : QJsonValue(t_s));
    truth.insert("completed", trial.completed);
    truth.insert("length_m", insertion->length_m);
    truth.insert("bend_m", insertion->bend_m);
    truth.insert("goal_m", insertion->goal_m);
    truth.insert("lateral_limit_N", insertion->lateralLimit_N);
    truth.insert("landmarks_seen_s", seen_s);
}

Demonstration UrethraInsertionKind::demonstration() const {
    return {.columns = {{">off mm", "offset_rms", 2},
                        {">bend °", "curve_alignment", 1},
                        {">trauma", "trauma_events", 0},
                        {">seen %", "landmarks_seen", 0},
                        {">max mN·m", "torque_max", 0}},
            .legend = "off: RMS distance from the middle of the canal; bend: RMS angle between instrument "
                      "and canal round the bend; trauma: pushes\n"
                      "against the wall over the level's limit; seen: landmarks of the bladder inspected; "
                      "max mN·m: the largest torque\n",
            .comparison = OperatorComparison{.file = "operators_urethra_insertion.png",
                                             .title = "Urethra insertion: alignment in the bend by operator",
                                             .metric = "curve_alignment",
                                             .metricName = "Alignment in the bend",
                                             .unit = "°",
                                             .reference = kBendMark_deg,
                                             .referenceLabel = "pass mark, 15°"},
            .report = DemoReport{.level = kCystoscopyLevel}};
}

std::span<const SceneEvent> UrethraInsertionKind::sceneEvents() const noexcept {
    return kSceneEvents;
}

std::vector<MomentRule> UrethraInsertionKind::momentRules() const {
    using namespace mark_kinds;
    return {{.metric = "trauma_*", .by = MomentRule::By::largestMark, .marks = {kTrauma}, .unit = "N"},
            {.metric = "lateral_max", .by = MomentRule::By::largestMark, .marks = {kTrauma}, .unit = "N"},
            // A trauma that lasted too long or was too hard, where no tissue gave way.
            {.metric = "critical_errors",
             .by = MomentRule::By::largestMark,
             .marks = {kTrauma},
             .unit = "N",
             .onlyCritical = true},
            {.metric = "reversals",
             .by = MomentRule::By::largestMark,
             .marks = {kReversal},
             .factor = 1e3,
             .unit = "mm"},
            {.metric = "insertion_depth", .by = MomentRule::By::own, .own = &deepest}};
}

std::optional<double> UrethraInsertionKind::depthAt_m(const PlaybackTrack& track, double t_s) const {
    return depthIn(track, t_s);
}

} // namespace chiron::session
