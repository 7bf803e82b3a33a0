// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/comparison_kind.h"

#include "operators/comparison/comparison_explorer.h"
#include "operators/settings/operator_table.h"
#include "session/playback_track.h"
#include "session/session_setup.h"
#include "session/study/comparison_marks.h"
#include "simulation/comparison/comparison_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::session {

namespace {

const simulation::ComparisonParameters& parametersOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.as<simulation::ComparisonParameters>();
}

constexpr std::array<std::string_view, 1> kOperators{"participant"};

/// A single object at the middle position. The felt values are in the recorded quantities.
class ComparisonSurfaces final : public TrialSurfaces {
public:
    explicit ComparisonSurfaces(const simulation::ComparisonParameters& p) {
        m_object.p_WObject = core::Vec3(0.0, 0.0, simulation::isHooked(p.attribute) ? p.hookHeight_m : 0.0);
    }
    std::optional<TrialObject> object(int trial) const override {
        return trial < 0 ? std::nullopt : std::optional(m_object);
    }
    core::Vec3 surfacePoint(int, const core::Vec3& p_WT) const override { return p_WT; }

private:
    TrialObject m_object;
};

/// The largest value of a recorded quantity in a trial; 0 where there is none.
double largest(const scoring::TrialTrace& trial, std::string_view id) {
    for (const scoring::QuantityTrace& quantity : trial.quantities)
        if (quantity.id == id && !quantity.values.empty())
            return *std::max_element(quantity.values.begin(), quantity.values.end());
    return 0.0;
}

} // namespace

std::vector<core::QuantityDescription> ComparisonKind::quantities(const catalogue::ExerciseLevel&) const {
    return {{"place", "1", 1.0},
            {"candidate", "1", 1.0},
            {"arrangement", "1", 1.0},
            {"answer", "1", 1.0},
            {"touched_places", "1", 1.0},
            {"displacement_m", "m", 1e-7},
            {"depth_m", "m", 1e-7},
            {"velocity_x_m_per_s", "m/s", 1e-6},
            {"velocity_y_m_per_s", "m/s", 1e-6},
            {"velocity_z_m_per_s", "m/s", 1e-6}};
}

std::unique_ptr<simulation::IScene> ComparisonKind::makeScene(const SessionSetup& setup) const {
    return std::make_unique<simulation::ComparisonScene>(parametersOf(setup.level), setup.seed);
}

simulation::YieldLaw ComparisonKind::yieldLaw(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).yield;
}

std::vector<std::string> ComparisonKind::operatorNames() const {
    return {kOperators.begin(), kOperators.end()};
}

core::Result<ScriptedTrainee> ComparisonKind::makeOperator(const catalogue::ExerciseLevel& level,
                                                           const std::string& name, std::uint64_t,
                                                           const HeldDevices&) const {
    if (name != kOperators[0])
        return operators::unknownOperator(name, kOperators);
    auto explorer = operators::makeComparisonExplorer(operators::comparisonBriefing(parametersOf(level)));
    CHIRON_TRY(explorer);
    return oneHanded(std::move(*explorer), operators::comparisonHand());
}

double ComparisonKind::forceLimit_N(const catalogue::ExerciseLevel& level) const {
    return parametersOf(level).maximumForce_N;
}

/// The duration of ten scripted presentations. Only a study's runner presents anything, and it has no such
/// limit.
std::uint64_t ComparisonKind::tickLimit(const catalogue::ExerciseLevel&) const {
    return 10000;
}

void ComparisonKind::addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                              scoring::TrialTrace& trial) const {
    const auto& p = parametersOf(level);
    const core::PresentationWord word{static_cast<int>(std::lround(largest(trial, "candidate"))) - 1,
                                      static_cast<int>(std::lround(largest(trial, "arrangement"))) - 1};
    trial.truth = {{"attribute", static_cast<double>(p.attribute)},
                   {"places", static_cast<double>(p.places)},
                   {"candidate", static_cast<double>(word.candidate)},
                   {"arrangement", static_cast<double>(word.arrangement)},
                   {"answer", largest(trial, "answer") - 1.0}};
    if (word.candidate < 0 || word.arrangement < 0)
        return;
    const simulation::ComparisonScene scene(p, seed);
    for (int place = 0; place < p.places; ++place)
        if (const auto value = scene.valueAt(word, place))
            trial.truth.push_back({"value_" + std::to_string(place), *value});
}

std::unique_ptr<TrialSurfaces> ComparisonKind::makeSurfaces(const catalogue::ExerciseLevel& level,
                                                            std::uint64_t) const {
    return std::make_unique<ComparisonSurfaces>(parametersOf(level));
}

core::Result<void> ComparisonKind::addMarks(const SessionSetup&, const scoring::SessionTrace*,
                                            PlaybackTrack& track) const {
    for (PlaybackMark& mark : track.marks)
        if (mark.kind == mark_kinds::kYielded)
            mark.kind = mark_kinds::kCameOff;
    return {};
}

} // namespace chiron::session
