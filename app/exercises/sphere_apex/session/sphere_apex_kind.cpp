// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/session/sphere_apex_kind.h"

#include "app/exercises/sphere_apex/session/apex_marks.h"
#include "app/exercises/sphere_apex/session/apex_sessions.h"
#include "curriculum/exercises/sphere_apex/scoring/apex_answer.h"
#include "database/repositories/session_types.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"
#include "session/answer_events.h"
#include "session/moment_rule.h"
#include "session/playback_track.h"
#include "session/session_setup.h"

#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <optional>

namespace chiron::session {

namespace {

constexpr int kFeltAloneLevel = 2; // P2's condition: no visible object

const simulation::SphereApexParameters& parametersOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.as<simulation::SphereApexParameters>();
}

/// Arming takes 2 s and a person may first have to move out of contact; beyond this a scripted run is stuck.
constexpr double kArmingAllowance_s = 20.0;

bool meshed(const simulation::SphereApexParameters& p) {
    return p.surface != simulation::ApexSurface::exact;
}

class SphereApexSurfaces final : public TrialSurfaces {
public:
    SphereApexSurfaces(const simulation::SphereApexParameters& p, std::uint64_t seed) {
        const auto trials = simulation::planSphereApexTrials(p, seed);
        if (meshed(p))
            if (auto dome = simulation::TouchedDome::make(p, trials))
                m_dome = std::move(*dome);
        for (const simulation::SphereApexTrial& trial : trials) {
            TrialObject object{{trial.centre_m.x(), trial.centre_m.y(), p.planeHeight_m},
                               p.radius_m,
                               {},
                               meshed(p) ? trial.turn_rad : 0.0};
            if (p.dimpleDepth_m > 0.0)
                object.dimpleCentre_m = trial.dimpleCentre_m;
            m_objects.push_back(object);
            m_contacts.emplace_back(simulation::sphereApexContact(p, trial));
        }
    }
    std::optional<TrialObject> object(int trial) const override {
        const auto index = static_cast<std::size_t>(trial);
        if (trial < 0 || index >= m_objects.size())
            return std::nullopt;
        return m_objects[index];
    }
    core::Vec3 surfacePoint(int trial, const core::Vec3& p_WT) const override {
        const auto index = static_cast<std::size_t>(trial);
        if (trial < 0 || index >= m_contacts.size() || !p_WT.allFinite())
            return p_WT;
        if (m_dome)
            return m_dome->restPoint(index, p_WT);
        return m_contacts[index].respond(p_WT, core::Vec3::Zero()).surfacePoint;
    }

private:
    std::vector<TrialObject> m_objects;
    std::vector<simulation::HemisphereContact> m_contacts;
    std::unique_ptr<simulation::TouchedDome> m_dome; ///< for a level on meshes: the dome in its rest shape
};

/// An answer beside the sphere or in the air is a miss (as apex_misses counts it); its mark follows the mark
/// of the answer.
void noteMisses(PlaybackTrack& track) {
    std::vector<PlaybackMark> marks;
    for (const PlaybackMark& mark : track.marks) {
        marks.push_back(mark);
        const PlaybackTrial* trial = mark.kind == mark_kinds::kMarked ? track.trial(mark.trial) : nullptr;
        if (trial == nullptr || !trial->object)
            continue;
        const core::Vec3 d = trial->p_WEnd - trial->object->p_WObject;
        if (trial->endedInContact && std::hypot(d.x(), d.y()) <= trial->object->radius_m)
            continue;
        marks.push_back(mark);
        marks.back().kind = mark_kinds::kMissed;
    }
    track.marks = std::move(marks);
}

/// Horizontal distance of the answer from the truth, m; 0 where there is no truth.
double missOf(const PlaybackTrial& trial) {
    if (!trial.object)
        return 0.0;
    const core::Vec3 d = trial.p_WEnd - trial.object->p_WObject;
    return std::hypot(d.x(), d.y());
}

/// The answer farthest from the apex, in per cent of the sphere's radius.
std::optional<WorstMoment> farthestAnswer(const PlaybackTrack& track) {
    const auto found = std::max_element(
        track.trials.begin(), track.trials.end(),
        [](const PlaybackTrial& a, const PlaybackTrial& b) { return missOf(a) < missOf(b); });
    if (found == track.trials.end() || !found->object || found->object->radius_m <= 0.0)
        return std::nullopt;
    WorstMoment worst;
    worst.t_s = found->end_s;
    worst.trial = found->index;
    worst.value = 100.0 * missOf(*found) / found->object->radius_m;
    worst.unit = "%";
    return worst;
}

} // namespace

std::unique_ptr<simulation::IScene> SphereApexKind::makeScene(const SessionSetup& setup) const {
    return std::make_unique<simulation::SphereApexScene>(parametersOf(setup.level), setup.seed);
}

simulation::YieldLaw SphereApexKind::yieldLaw(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).yield;
}

core::Result<ScriptedTrainee> SphereApexKind::makeOperator(const catalogue::ExerciseLevel&,
                                                           const std::string& name, std::uint64_t seed,
                                                           const HeldDevices&) const {
    auto settings = operators::sphereApexOperatorSettings(name);
    CHIRON_TRY(settings);
    auto strategy = operators::makeSphereApexOperator(*settings, seed);
    CHIRON_TRY(strategy);
    return oneHanded(std::move(*strategy), settings->hand);
}

std::vector<std::string> SphereApexKind::operatorNames() const {
    const auto names = operators::sphereApexOperatorNames();
    return {names.begin(), names.end()};
}

int SphereApexKind::trialCount(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).trials;
}

double SphereApexKind::forceLimit_N(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).maximumForce_N;
}

std::uint64_t SphereApexKind::tickLimit(const catalogue::ExerciseLevel& level) const {
    const auto& p = parametersOf(level);
    return static_cast<std::uint64_t>(
        std::ceil(1000.0 * p.trials * (p.trialLimit_s + p.betweenTrials_s + kArmingAllowance_s)));
}

std::vector<core::QuantityDescription>
SphereApexKind::quantities(const catalogue::ExerciseLevel& level) const {
    if (parametersOf(level).surface != simulation::ApexSurface::organ)
        return {};
    return {{"prediction_error_m", "m", 1e-7}, {"held_error_m", "m", 1e-7}};
}

bool SphereApexKind::recordsEnergy(const catalogue::ExerciseLevel& level) const {
    return meshed(parametersOf(level));
}

void SphereApexKind::addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                              scoring::TrialTrace& trial) const {
    const auto& p = parametersOf(level);
    const auto plan = simulation::planSphereApexTrials(p, seed);
    const auto index = static_cast<std::size_t>(trial.trial);
    if (index < plan.size())
        trial.target = scoring::TargetTruth{plan[index].centre_m.x(), plan[index].centre_m.y(), p.radius_m};
}

std::unique_ptr<TrialSurfaces> SphereApexKind::makeSurfaces(const catalogue::ExerciseLevel& level,
                                                            std::uint64_t seed) const {
    return std::make_unique<SphereApexSurfaces>(parametersOf(level), seed);
}

core::Result<void> SphereApexKind::addMarks(const SessionSetup&, const scoring::SessionTrace*,
                                            PlaybackTrack& track) const {
    noteMisses(track);
    return {};
}

void SphereApexKind::addAnswerEvents(const scoring::TrialTrace& trial, const database::TrialRecord& record,
                                     AnswerEvents& events) const {
    if (!trial.target || !trial.marked || trial.tools.empty())
        return;                      // a trial without a mark already has an event
    scoring::PreparedTrial prepared; // the answer reads only position and truth from it
    prepared.trial = &trial;
    prepared.tool = &trial.tools.front();
    if (const auto answer = scoring::apexAnswer(prepared); answer && answer->miss)
        events.addAt(record.lastTick, "missed", trial.trial);
}

void SphereApexKind::storeTruth(const scoring::TrialTrace& trial, QJsonObject& truth) const {
    if (!trial.target)
        return;
    truth.insert("apex_x_m", trial.target->x_m);
    truth.insert("apex_y_m", trial.target->y_m);
    truth.insert("radius_m", trial.target->radius_m);
}

Demonstration SphereApexKind::demonstration() const {
    return {.columns = {{">apex error %", "apex_error_mean", 1},
                        {">SD %", "apex_error_sd", 1},
                        {">misses", "apex_misses", 0}},
            .legend = "apex error: mean distance between mark and true highest point, in % of the sphere's "
                      "radius; SD: its spread over the\n"
                      "trials; misses: marked off the sphere, without touching, or not in time\n",
            .comparison = OperatorComparison{.file = "operators.png",
                                             .title = "Apex error by operator, by touch alone",
                                             .metric = "apex_error_mean",
                                             .metricName = "Apex error",
                                             .unit = "% of R",
                                             .level = kFeltAloneLevel,
                                             .reference = 14.2,
                                             .referenceLabel = "published mean of five people, 14.2 %"},
            .report = DemoReport{.level = kFeltAloneLevel, .plots = true}};
}

const MarkSessions* SphereApexKind::markSessions(const psychophysics::Condition& condition) const {
    static const ApexSessions sessions;
    return looksForApex(condition) ? &sessions : nullptr;
}

std::vector<MomentRule> SphereApexKind::momentRules() const {
    using namespace mark_kinds;
    return {{.metric = "apex_misses", .marks = {kMissed, kTimedOut}},
            {.metric = "apex_*", .by = MomentRule::By::own, .own = &farthestAnswer}};
}

} // namespace chiron::session
