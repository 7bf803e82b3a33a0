// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the trainees by name. This allocates, so it is kept apart from the code of the tick.
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator.h"

#include "modules/exercises/sphere_apex/operators/midpoints_technique.h"
#include "modules/exercises/sphere_apex/operators/scripted_trainee.h"
#include "modules/exercises/sphere_apex/operators/slope_crossings_technique.h"
#include "modules/exercises/sphere_apex/operators/wander_technique.h"
#include "operators/settings/operator_table.h"
#include "operators/settings/setting_ranges.h"

#include <utility>

namespace chiron::operators {

namespace {

SphereApexOperatorSettings novice() {
    SphereApexOperatorSettings s;
    s.technique = ApexTechniqueKind::wander;
    s.climbSpeed_m_per_s = 0.03;
    s.sweepSpeed_m_per_s = 0.035;
    s.wanderRadius_m = 0.012;
    s.force_N = 1.5;
    s.controlsForce = false;
    s.pressDepth_m = 0.003;
    s.topSlope = 0.42; // 25°: satisfied with less
    s.settle_s = 0.1;
    s.patience_s = 40.0;
    return s;
}

SphereApexOperatorSettings intermediate() {
    SphereApexOperatorSettings s;
    s.technique = ApexTechniqueKind::midpoints;
    s.climbSpeed_m_per_s = 0.030;
    s.sweepSpeed_m_per_s = 0.018;
    s.force_N = 1.3;
    return s;
}

SphereApexOperatorSettings expert() {
    SphereApexOperatorSettings s;
    // When it scans into the side of a ball that it does not expect, it moves on for its reaction delay
    // (0.18 s) and the time that it needs to be sure (0.1 s). At this speed the arm (300 N/m) then presses
    // the hardest ball (1 kN/m) with 2.6 N, well below the 4 N that the level states; at the 0.08 m/s of the
    // others it would be 5.2 N.
    s.scanSpeed_m_per_s = 0.04;
    s.force_N = 1.2;
    return s;
}

SphereApexOperatorSettings unsafe() {
    SphereApexOperatorSettings s = novice();
    s.hand = mechanisms::HandParameters::firm();
    s.reachSpeed_m_per_s = 0.25;
    s.lowerSpeed_m_per_s = 0.08;
    s.scanSpeed_m_per_s = 0.15;
    s.climbSpeed_m_per_s = 0.05;
    s.sweepSpeed_m_per_s = 0.06;
    s.force_N = 2.2;
    s.pressDepth_m = 0.012;
    s.wanderTime_s = 4.0;
    return s;
}

constexpr OperatorTable<SphereApexOperatorSettings, 4> kOperators(
    {{"novice", &novice}, {"intermediate", &intermediate}, {"expert", &expert}, {"unsafe", &unsafe}});

core::Result<void> check(const SphereApexOperatorSettings& s) {
    return checkRanges({{"reachSpeed_m_per_s", s.reachSpeed_m_per_s, 0.01, 0.8},
                        {"lowerSpeed_m_per_s", s.lowerSpeed_m_per_s, 0.005, 0.5},
                        {"scanSpeed_m_per_s", s.scanSpeed_m_per_s, 0.01, 0.5},
                        {"climbSpeed_m_per_s", s.climbSpeed_m_per_s, 0.005, 0.2},
                        {"sweepSpeed_m_per_s", s.sweepSpeed_m_per_s, 0.002, 0.3},
                        {"startHeight_m", s.startHeight_m, 0.0, 0.09},
                        {"scanRadius_m", s.scanRadius_m, 0.01, 0.08},
                        {"scanHeight_m", s.scanHeight_m, 0.002, 0.04},
                        {"scanSpacing_m", s.scanSpacing_m, 0.002, 0.08},
                        {"force_N", s.force_N, 0.1, 20.0},
                        {"pressDepth_m", s.pressDepth_m, 0.0, 0.05},
                        {"forceGain_m_per_Ns", s.forceGain_m_per_Ns, 0.001, 0.1},
                        {"topSlope", s.topSlope, 0.05, 2.0},
                        {"edgeSlope", s.edgeSlope, 0.1, 5.0},
                        {"sweepHalfWidth_m", s.sweepHalfWidth_m, 0.002, 0.03},
                        {"crosses", static_cast<double>(s.crosses), 1.0, 6.0},
                        {"wanderRadius_m", s.wanderRadius_m, 0.002, 0.04},
                        {"wanderTime_s", s.wanderTime_s, 0.5, 60.0},
                        {"settle_s", s.settle_s, 0.0, 5.0},
                        {"patience_s", s.patience_s, 1.0, 600.0},
                        {"hand.reactionDelay_s", s.hand.reactionDelay_s, 0.0, 0.5}});
}

std::unique_ptr<ApexTechnique> makeTechnique(const SphereApexOperatorSettings& settings, std::uint64_t seed) {
    switch (settings.technique) {
    case ApexTechniqueKind::wander:
        return std::make_unique<WanderTechnique>(settings, seed);
    case ApexTechniqueKind::midpoints:
        return std::make_unique<MidpointsTechnique>(settings);
    case ApexTechniqueKind::slopeCrossings:
        break;
    }
    return std::make_unique<SlopeCrossingsTechnique>(settings);
}

} // namespace

std::span<const std::string_view> sphereApexOperatorNames() noexcept {
    return kOperators.names();
}

core::Result<SphereApexOperatorSettings> sphereApexOperatorSettings(std::string_view name) {
    return kOperators.settings(name);
}

core::Result<std::unique_ptr<mechanisms::HandStrategy>> makeSphereApexOperator(std::string_view name,
                                                                               std::uint64_t seed) {
    const auto settings = sphereApexOperatorSettings(name);
    CHIRON_TRY(settings);
    return makeSphereApexOperator(*settings, seed);
}

core::Result<std::unique_ptr<mechanisms::HandStrategy>>
makeSphereApexOperator(const SphereApexOperatorSettings& settings, std::uint64_t seed) {
    CHIRON_TRY(check(settings));
    return std::make_unique<ScriptedTrainee>(settings, seed, makeTechnique(settings, seed));
}

ScriptedTrainee::ScriptedTrainee(const SphereApexOperatorSettings& settings, std::uint64_t seed,
                                 std::unique_ptr<ApexTechnique> technique)
    : m_settings(settings), m_senses(settings.perception, seed),
      m_random(core::Random::stream(seed, "sphere_apex/trainee")), m_technique(std::move(technique)),
      m_path(settings.scanRadius_m, settings.scanSpacing_m) {}

ScriptedTrainee::~ScriptedTrainee() = default;
WanderTechnique::~WanderTechnique() = default;
MidpointsTechnique::~MidpointsTechnique() = default;
SlopeCrossingsTechnique::~SlopeCrossingsTechnique() = default;

} // namespace chiron::operators
