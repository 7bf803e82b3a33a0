// SPDX-License-Identifier: GPL-3.0-or-later
// Makes laparoscopists for the tube. This allocates, so it is kept apart from their strategies, which the
// tick calls.
#include "modules/exercises/elastic_tube/operators/elastic_tube_operator.h"

#include "modules/exercises/elastic_tube/operators/tube_trainee.h"
#include "operators/laparoscopy/scripted_hand.h"
#include "operators/settings/operator_table.h"
#include "operators/settings/setting_ranges.h"

#include <algorithm>
#include <string>

namespace chiron::operators {

namespace {

constexpr double kJawWandering_s = 3.0; ///< assumption

ElasticTubeOperatorSettings novice() {
    ElasticTubeOperatorSettings s;
    s.reach = {.acceleration_m_per_s2 = 2.0, .smoothing_s = 0.04};
    s.attention_s = 0.35;
    s.reachSpeed_m_per_s = 0.07;
    s.moveGain_per_s = 1.8;
    s.aim_m = 0.0055;
    s.settle_s = 0.5;
    s.jawSpeed_rad_per_s = 1.0;
    s.heldJaw_rad = 0.08;
    s.jawUnsteadySd_rad = 0.07;
    s.pullSpeed_m_per_s = 0.025;
    s.correctionRate_per_s = 1.8;
    s.learnsStiffness = false;
    s.deadZone = 0.8;
    s.searchSpeed_m_per_s = 0.010;
    s.longestRatio = 10.0;
    s.bringSpeed_m_per_s = 0.05;
    return s;
}

ElasticTubeOperatorSettings intermediate() {
    ElasticTubeOperatorSettings s;
    s.reach = {.acceleration_m_per_s2 = 1.0, .smoothing_s = 0.08};
    s.attention_s = 0.18;
    s.aim_m = 0.004;
    s.settle_s = 0.3;
    s.jawSpeed_rad_per_s = 1.5;
    s.jawUnsteadySd_rad = 0.03;
    s.pullSpeed_m_per_s = 0.020;
    s.correctionRate_per_s = 1.5;
    s.deadZone = 0.4;
    s.searchSpeed_m_per_s = 0.007;
    s.longestRatio = 1.8;
    s.bringSpeed_m_per_s = 0.04;
    return s;
}

ElasticTubeOperatorSettings expert() {
    return {};
}

ElasticTubeOperatorSettings unsafe() {
    ElasticTubeOperatorSettings s = novice();
    s.hand = mechanisms::HandParameters::firm();
    s.reach = {.acceleration_m_per_s2 = 4.0, .smoothing_s = 0.02};
    s.reachSpeed_m_per_s = 0.15;
    s.settle_s = 0.1;
    s.jawSpeed_rad_per_s = 3.0;
    s.heldJaw_rad = 0.12;
    s.jawUnsteadySd_rad = 0.09;
    s.pullSpeed_m_per_s = 0.06;
    s.correctionRate_per_s = 2.5;
    s.searchSpeed_m_per_s = 0.03;
    s.bringSpeed_m_per_s = 0.12;
    s.retractShare = 1.9; // as for the unsafe palpator: beyond the band by 90 % of its width
    return s;
}

constexpr OperatorTable<ElasticTubeOperatorSettings, 4> kOperators(
    {{"novice", &novice}, {"intermediate", &intermediate}, {"expert", &expert}, {"unsafe", &unsafe}});

core::Result<void> check(const ElasticTubeOperatorSettings& s) {
    return checkRanges({{"attention_s", s.attention_s, 0.0, 2.0},
                        {"reachSpeed_m_per_s", s.reachSpeed_m_per_s, 0.005, 0.5},
                        {"moveGain_per_s", s.moveGain_per_s, 0.2, 10.0},
                        {"aim_m", s.aim_m, 0.001, 0.03},
                        {"settle_s", s.settle_s, 0.0, 5.0},
                        {"jawSpeed_rad_per_s", s.jawSpeed_rad_per_s, 0.05, 20.0},
                        {"openJaw_rad", s.openJaw_rad, 0.1, 1.6},
                        {"heldJaw_rad", s.heldJaw_rad, 0.0, 0.5},
                        {"jawUnsteadySd_rad", s.jawUnsteadySd_rad, 0.0, 0.5},
                        {"pullSpeed_m_per_s", s.pullSpeed_m_per_s, 0.001, 0.3},
                        {"correctionRate_per_s", s.correctionRate_per_s, 0.1, 10.0},
                        {"assumedStiffness_N_per_m", s.assumedStiffness_N_per_m, 1.0, 1000.0},
                        {"deadZone", s.deadZone, 0.0, 2.0},
                        {"searchSpeed_m_per_s", s.searchSpeed_m_per_s, 0.0005, 0.1},
                        {"longestRatio", s.longestRatio, 1.0, 100.0},
                        {"bringSpeed_m_per_s", s.bringSpeed_m_per_s, 0.002, 0.3},
                        {"retractShare", s.retractShare, 0.0, 5.0},
                        {"reach.acceleration_m_per_s2", s.reach.acceleration_m_per_s2, 0.05, 20.0},
                        {"reach.smoothing_s", s.reach.smoothing_s, 0.0, 1.0},
                        {"hand.reactionDelay_s", s.hand.reactionDelay_s, 0.0, 0.5}});
}

} // namespace

std::span<const std::string_view> elasticTubeOperatorNames() noexcept {
    return kOperators.names();
}

core::Result<ElasticTubeOperatorSettings> elasticTubeOperatorSettings(std::string_view name) {
    return kOperators.settings(name);
}

core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makeElasticTubeOperator(const ElasticTubeOperatorSettings& settings, const ElasticTubeBriefing& briefing,
                        std::uint64_t seed) {
    CHIRON_TRY(check(settings));
    const std::size_t hands =
        briefing.places.size() - (briefing.retracts && !briefing.places.empty() ? 1 : 0);
    if (hands < 1 || hands > 2)
        return core::fail(core::ErrorCode::badInput,
                          "operator: " + std::to_string(briefing.places.size()) +
                              " instruments, expected one or two, and one more for a fold");
    return makeHands(std::make_unique<TubeTrainee>(settings, briefing, seed), settings.perception,
                     settings.reach, briefing.places, seed);
}

TubeTrainee::TubeTrainee(const ElasticTubeOperatorSettings& settings, const ElasticTubeBriefing& briefing,
                         std::uint64_t seed)
    : m_settings(settings), m_briefing(briefing),
      m_random(core::Random::stream(seed, "elastic_tube/trainee")), m_tension(settings),
      m_retraction(settings), m_all(std::clamp<std::size_t>(briefing.places.size(), 1, GraspLook::kHands)),
      m_count(m_all - (briefing.retracts ? 1 : 0)) {
    // At least two, to keep the random numbers as they were drawn before there was a third hand
    for (std::size_t i = 0; i < std::max<std::size_t>(m_all, 2); ++i)
        m_hands[i].jaw =
            mechanisms::MarkovNoise(settings.jawUnsteadySd_rad, kJawWandering_s, Senses::kLook_s, m_random);
}

TubeTrainee::~TubeTrainee() = default;

} // namespace chiron::operators
