// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/session/palpation_kind.h"

#include "app/exercises/palpation/session/palpation_marks.h"
#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "curriculum/exercises/palpation/scoring/palpation_answer.h"
#include "database/repositories/session_types.h"
#include "modules/exercises/palpation/operators/palpation_operator.h"
#include "modules/exercises/palpation/simulation/palpation_plan.h"
#include "modules/exercises/palpation/simulation/palpation_scene.h"
#include "session/answer_events.h"
#include "session/level_cues.h"
#include "session/moment_rule.h"
#include "session/playback_track.h"
#include "session/session_setup.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

const simulation::PalpationParameters& parametersOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.as<simulation::PalpationParameters>();
}

/// Arming takes 2 s and a person may first have to move out of contact; beyond this a scripted run is stuck.
constexpr double kArmingAllowance_s = 20.0;

class PalpationSurfaces final : public TrialSurfaces {
public:
    PalpationSurfaces(const simulation::PalpationParameters& p, std::uint64_t seed)
        : m_surface(p.tissue.shape) {
        for (const simulation::PalpationTrial& trial : simulation::planPalpationTrials(p, seed)) {
            TrialObject object;
            object.p_WObject = m_surface.pointAt(core::Vec2::Zero());
            for (const simulation::Lump& lump : trial.list()) {
                const core::Vec3 above = m_surface.pointAt(lump.place_m);
                object.lumps.push_back({above - lump.depth_m * m_surface.normalAt(lump.place_m), above,
                                        lump.radius_m, std::max(lump.radius_m, p.hitRadius_m)});
            }
            m_trials.push_back(std::move(object));
        }
    }
    std::optional<TrialObject> object(int trial) const override {
        const auto index = static_cast<std::size_t>(trial);
        if (trial < 0 || index >= m_trials.size())
            return std::nullopt;
        return m_trials[index];
    }
    core::Vec3 surfacePoint(int trial, const core::Vec3& p_WT) const override {
        if (trial < 0 || static_cast<std::size_t>(trial) >= m_trials.size() || !p_WT.allFinite())
            return p_WT;
        const simulation::SurfaceFoot foot = m_surface.nearest(p_WT, p_WT.head<2>());
        return foot.depth_m > 0.0 ? foot.p_W : p_WT;
    }

private:
    simulation::TissueSurface m_surface;
    std::vector<TrialObject> m_trials;
};

operators::PalpationBriefing briefingOf(const PalpationKind& kind, std::string_view mechanism,
                                        const catalogue::ExerciseLevel& level,
                                        std::span<const devices::WorkspaceMapping> places) {
    const auto& p = parametersOf(level);
    operators::PalpationBriefing briefing;
    briefing.surface = p.tissue.shape;
    briefing.normal = p.tissue.regions; // the level's text names them
    briefing.areaHalf_m = p.areaHalf_m;
    briefing.hands = p.hands;
    briefing.fingers = p.fingers;
    briefing.fingerSpacing_m = p.fingerSpacing_m;
    briefing.bandLow_N = p.bandLow_N;
    briefing.bandHigh_N = p.bandHigh_N;
    briefing.asksSize = p.asksSize;
    briefing.asksHardness = p.asksHardness;
    briefing.asksConfidence = p.asksConfidence;
    const bool oneArm = mechanism == kind.mechanism(); // one arm per hand carries all its fingers
    for (int tool = 0; tool < p.tools(); ++tool)
        briefing.places.push_back(
            places[static_cast<std::size_t>(oneArm ? tool - tool % std::max(1, p.fingers) : tool)]);
    return briefing;
}

/// `moved`: the research control moved the lumps of this trial.
scoring::PalpationTruth truthOf(const simulation::PalpationParameters& p,
                                const simulation::PalpationTrial& planned, bool moved) {
    const simulation::TissueSurface surface(p.tissue.shape);
    scoring::PalpationTruth truth;
    for (int i = 0; i < planned.lumps; ++i) {
        const simulation::Lump& lump = planned.lump[static_cast<std::size_t>(i)];
        const core::Vec2 place_m = moved ? simulation::palpationMovedPlace_m(p, lump.place_m) : lump.place_m;
        truth.lumps.push_back({surface.pointAt(place_m), lump.depth_m, lump.radius_m,
                               planned.hardness[static_cast<std::size_t>(i)]});
    }
    truth.areaHalf_m = p.areaHalf_m;
    truth.regionColumns = p.regionColumns;
    truth.regionRows = p.regionRows;
    truth.hitRadius_m = p.hitRadius_m;
    truth.bandLow_N = p.bandLow_N;
    truth.bandHigh_N = p.bandHigh_N;
    truth.coverForce_N = p.coverForce_N;
    truth.introduction = planned.introduction;
    truth.asksSize = p.asksSize;
    truth.asksHardness = p.asksHardness;
    return truth;
}

/// True if the research control moved this trial's lumps; the scene recorded this.
bool wasMoved(const scoring::TrialTrace& trial) {
    for (const scoring::QuantityTrace& quantity : trial.quantities)
        if (quantity.id == "lumps_moved")
            return std::any_of(quantity.values.begin(), quantity.values.end(),
                               [](double moved) { return moved > 0.5; });
    return false;
}

} // namespace

LevelTools PalpationKind::tools(const catalogue::ExerciseLevel& level) const {
    const auto& p = parametersOf(level);
    return {.count = p.tools(),
            .perHand = p.fingers,
            .spacing_m = p.fingerSpacing_m,
            .widestJaw_rad = p.pinch ? p.pinch->widest_rad : 0.0};
}

devices::WorkspaceMapping PalpationKind::toolPlace(const catalogue::ExerciseLevel& level, int tool) const {
    const auto& p = parametersOf(level);
    const int perHand = std::max(1, p.fingers);
    const double hand_m = p.hands < 2 ? 0.0 : (tool < perHand ? 0.5 : -0.5) * p.areaHalf_m.x();
    devices::WorkspaceMapping place;
    place.origin_m[0] = hand_m + (tool % perHand - 0.5 * (perHand - 1)) * p.fingerSpacing_m;
    return place;
}

// A finger that is about to palpate starts just above the skin.
std::optional<core::Vec3> PalpationKind::toolStart_W(const catalogue::ExerciseLevel& level,
                                                     const devices::WorkspaceMapping& place) const {
    constexpr double kAbove_m = 0.005;
    const core::Vec2 over_m(place.origin_m[0], place.origin_m[1]);
    const double skin_m = simulation::TissueSurface(parametersOf(level).tissue.shape).pointAt(over_m).z();
    return core::Vec3(over_m.x(), over_m.y(), skin_m + kAbove_m);
}

std::vector<core::QuantityDescription>
PalpationKind::quantities(const catalogue::ExerciseLevel& level) const {
    std::vector<core::QuantityDescription> out{{"report_count", "1", 1.0},   {"report_field", "1", 1.0},
                                               {"report_finding", "1", 1.0}, {"report_value", "1", 1.0},
                                               {"finding_x_m", "m", 1e-6},   {"finding_y_m", "m", 1e-6},
                                               {"finding_z_m", "m", 1e-6},   {"coverage", "1", 1e-4}};
    for (int i = 0; i < core::kMaxTools; ++i)
        out.push_back({"depth_" + std::to_string(i) + "_m", "m", 1e-6});
    for (int i = 0; i < core::kMaxTools; ++i)
        out.push_back({"lean_" + std::to_string(i) + "_rad", "rad", 1e-4});
    out.push_back({"lean_saturated", "1", 1.0});
    out.push_back({"lumps_moved", "1", 1.0});
    if (parametersOf(level).pinch)
        for (std::size_t hand = 0; hand < simulation::palpation_quantity::kSqueezes; ++hand)
            out.push_back({"squeeze_" + std::to_string(hand) + "_N", "N", 1e-4});
    return out;
}

std::unique_ptr<simulation::IScene> PalpationKind::makeScene(const SessionSetup& setup) const {
    simulation::PalpationParameters parameters = parametersOf(setup.level);
    parameters.cues = cueWordsOf(setup.level, setup.felt()); // if force cannot be felt, it is shown
    return std::make_unique<simulation::PalpationScene>(parameters, setup.seed);
}

simulation::YieldLaw PalpationKind::yieldLaw(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).yield;
}

core::Result<ScriptedTrainee> PalpationKind::makeOperator(const catalogue::ExerciseLevel& level,
                                                          const std::string& name, std::uint64_t seed,
                                                          const HeldDevices& held) const {
    auto settings = operators::palpationOperatorSettings(name);
    CHIRON_TRY(settings);
    auto strategies = operators::makePalpationOperator(
        *settings, briefingOf(*this, held.mechanism, level, held.places), seed);
    CHIRON_TRY(strategies);
    return ScriptedTrainee{std::move(*strategies), settings->hand};
}

std::vector<std::string> PalpationKind::operatorNames() const {
    const auto names = operators::palpationOperatorNames();
    return {names.begin(), names.end()};
}

int PalpationKind::trialCount(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).trials;
}

double PalpationKind::forceLimit_N(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).maximumForce_N;
}

std::uint64_t PalpationKind::tickLimit(const catalogue::ExerciseLevel& level) const {
    const auto& p = parametersOf(level);
    return static_cast<std::uint64_t>(
        std::ceil(1000.0 * p.trials * (p.trialLimit_s + p.betweenTrials_s + kArmingAllowance_s)));
}

void PalpationKind::addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                             scoring::TrialTrace& trial) const {
    const auto& p = parametersOf(level);
    const auto plan = simulation::planPalpationTrials(p, seed);
    const auto index = static_cast<std::size_t>(trial.trial);
    if (trial.trial < 0 || index >= plan.size())
        return;
    trial.truth = scoring::valuesOf(truthOf(p, plan[index], wasMoved(trial)));
}

std::unique_ptr<TrialSurfaces> PalpationKind::makeSurfaces(const catalogue::ExerciseLevel& level,
                                                           std::uint64_t seed) const {
    return std::make_unique<PalpationSurfaces>(parametersOf(level), seed);
}

core::Result<void> PalpationKind::addMarks(const SessionSetup&, const scoring::SessionTrace* trace,
                                           PlaybackTrack& track) const {
    // Movement and force do not depend on the findings: if these cannot be read, the track is used without
    // them.
    if (const auto outcomes = palpationOutcomes(*trace))
        addPalpationMarks(track, *outcomes);
    return {};
}

void PalpationKind::addAnswerEvents(const scoring::TrialTrace& trial, const database::TrialRecord& record,
                                    AnswerEvents& events) const {
    const auto judged = scoring::judgePalpation(trial);
    if (!judged.answer)
        return;
    const scoring::PalpationAnswer& answer = *judged.answer;
    for (const std::size_t report : falseAlarmReports(answer))
        events.addFrom(answer.reports[report].t_s, "false_alarm",
                       "{\"trial\":" + std::to_string(trial.trial) +
                           ",\"finding\":" + std::to_string(answer.reports[report].finding + 1) + "}");
    if (!trial.completed && !trial.timedOut)
        // For an aborted search, it is unknown what it would have found.
        return;
    for (std::size_t lump = 0; lump < answer.truth.lumps.size(); ++lump)
        if (scoring::foundBy(answer.matches, static_cast<int>(lump)) == nullptr)
            events.addAt(record.lastTick, "lump_missed", trial.trial);
}

Demonstration PalpationKind::demonstration() const {
    return {.columns = {{">found", "palpation_hits", 0},
                        {">missed", "palpation_misses", 0},
                        {">false", "palpation_false_alarms", 0},
                        {">off mm", "localisation_error", 1},
                        {">covered %", "coverage", 0}},
            .legend = "found, missed, false: lumps found and missed, and marks where there is none; off: "
                      "mean distance between mark and lump;\n"
                      "covered: share of the area that was pressed\n"};
}

std::vector<MomentRule> PalpationKind::momentRules() const {
    using namespace mark_kinds;
    return {{.metric = "palpation_hits", .marks = {kLumpMissed}, .ofWholeTrial = true},
            {.metric = "palpation_misses", .marks = {kLumpMissed}, .ofWholeTrial = true},
            {.metric = "palpation_false_alarms", .marks = {kFalseAlarm}}};
}

} // namespace chiron::session
