// SPDX-License-Identifier: GPL-3.0-or-later
// Makes laparoscopists for object handling. This allocates, so it is kept apart from their strategies, which
// the tick calls.
#include "modules/exercises/object_handling/operators/object_handling_operator.h"

#include "modules/exercises/object_handling/operators/handling_trainee.h"
#include "operators/laparoscopy/scripted_hand.h"
#include "operators/settings/operator_table.h"
#include "operators/settings/setting_ranges.h"

namespace chiron::operators {

namespace {

ObjectHandlingOperatorSettings novice() {
    ObjectHandlingOperatorSettings s;
    s.reach = {.acceleration_m_per_s2 = 2.0, .smoothing_s = 0.04};
    s.attention_s = 0.35;
    s.reachSpeed_m_per_s = 0.07;
    s.carrySpeed_m_per_s = 0.06;
    s.moveGain_per_s = 1.8;
    s.aim_m = 0.005;
    s.placeAim_m = 0.008;
    s.settle_s = 0.4;
    s.jawSpeed_rad_per_s = 0.7;
    s.squeezeShare = 0.85;
    s.squeezeGain_rad_per_Ns = 0.6;
    s.squeezeSpeed_rad_per_s = 0.5;
    s.squeezeTolerance = 0.35;
    s.flatteningShare = 0.32;
    s.regripFactor = 1.5;
    s.clearance_m = 0.012;
    s.setDownSpeed_m_per_s = 0.030;
    s.feelsTheBed = false;
    s.releaseHeight_m = 0.004;
    s.openSpeed_rad_per_s = 1.2;
    s.weighTime_s = 1.0;
    s.heft_m = 0.0;
    s.weighAgain = 0.0;
    return s;
}

ObjectHandlingOperatorSettings intermediate() {
    ObjectHandlingOperatorSettings s;
    s.reach = {.acceleration_m_per_s2 = 1.0, .smoothing_s = 0.08};
    s.attention_s = 0.18;
    s.carrySpeed_m_per_s = 0.05;
    s.aim_m = 0.0035;
    s.placeAim_m = 0.004;
    s.settle_s = 0.3;
    s.squeezeShare = 0.70;
    s.squeezeGain_rad_per_Ns = 0.5;
    s.squeezeSpeed_rad_per_s = 0.35;
    s.squeezeTolerance = 0.25;
    s.flatteningShare = 0.25;
    s.regripFactor = 1.3;
    s.clearance_m = 0.010;
    s.setDownSpeed_m_per_s = 0.015;
    s.openSpeed_rad_per_s = 0.8;
    s.weighTime_s = 1.8;
    s.heft_m = 0.003;
    s.weighAgain = 0.0;
    return s;
}

ObjectHandlingOperatorSettings expert() {
    return {};
}

ObjectHandlingOperatorSettings unsafe() {
    ObjectHandlingOperatorSettings s = novice();
    s.hand = mechanisms::HandParameters::firm();
    s.reach = {.acceleration_m_per_s2 = 4.0, .smoothing_s = 0.02};
    s.reachSpeed_m_per_s = 0.15;
    s.carrySpeed_m_per_s = 0.15;
    s.lowerSpeed_m_per_s = 0.08;
    s.settle_s = 0.1;
    s.jawSpeed_rad_per_s = 3.0;
    s.squeezeShare = 1.3;
    s.squeezeSpeed_rad_per_s = 1.5;
    s.flatteningShare = 0.60;
    s.setDownSpeed_m_per_s = 0.06;
    s.releaseHeight_m = 0.015;
    s.openSpeed_rad_per_s = 4.0;
    s.weighTime_s = 0.4;
    return s;
}

constexpr OperatorTable<ObjectHandlingOperatorSettings, 4> kOperators(
    {{"novice", &novice}, {"intermediate", &intermediate}, {"expert", &expert}, {"unsafe", &unsafe}});

core::Result<void> check(const ObjectHandlingOperatorSettings& s, const ObjectHandlingBriefing& b) {
    return checkRanges({{"attention_s", s.attention_s, 0.0, 2.0},
                        {"reachSpeed_m_per_s", s.reachSpeed_m_per_s, 0.005, 0.5},
                        {"carrySpeed_m_per_s", s.carrySpeed_m_per_s, 0.005, 0.5},
                        {"lowerSpeed_m_per_s", s.lowerSpeed_m_per_s, 0.002, 0.3},
                        {"moveGain_per_s", s.moveGain_per_s, 0.2, 10.0},
                        {"aim_m", s.aim_m, 0.0005, 0.02},
                        {"placeAim_m", s.placeAim_m, 0.0005, 0.02},
                        {"settle_s", s.settle_s, 0.0, 5.0},
                        {"jawSpeed_rad_per_s", s.jawSpeed_rad_per_s, 0.05, 20.0},
                        {"squeezeShare", s.squeezeShare, 0.05, 3.0},
                        {"squeezeGain_rad_per_Ns", s.squeezeGain_rad_per_Ns, 0.01, 10.0},
                        {"squeezeSpeed_rad_per_s", s.squeezeSpeed_rad_per_s, 0.01, 20.0},
                        {"squeezeTolerance", s.squeezeTolerance, 0.0, 1.0},
                        {"flatteningShare", s.flatteningShare, 0.01, 0.6},
                        {"regripFactor", s.regripFactor, 1.0, 3.0},
                        {"clearance_m", s.clearance_m, 0.0, 0.05},
                        {"setDownSpeed_m_per_s", s.setDownSpeed_m_per_s, 0.001, 0.3},
                        {"releaseHeight_m", s.releaseHeight_m, 0.0, 0.05},
                        {"openSpeed_rad_per_s", s.openSpeed_rad_per_s, 0.05, 20.0},
                        {"weighTime_s", s.weighTime_s, 0.0, 30.0},
                        {"heft_m", s.heft_m, 0.0, 0.02},
                        {"weighAgain", s.weighAgain, 0.0, 1.0},
                        {"reach.acceleration_m_per_s2", s.reach.acceleration_m_per_s2, 0.05, 20.0},
                        {"reach.smoothing_s", s.reach.smoothing_s, 0.0, 1.0},
                        {"hand.reactionDelay_s", s.hand.reactionDelay_s, 0.0, 0.5},
                        {"liftHeight_m", b.liftHeight_m, 0.0, 0.06},
                        {"jawLength_m", b.jawLength_m, 0.005, 0.1},
                        {"place.scale", b.place.scale, 0.1, 10.0}});
}

} // namespace

std::span<const std::string_view> objectHandlingOperatorNames() noexcept {
    return kOperators.names();
}

core::Result<ObjectHandlingOperatorSettings> objectHandlingOperatorSettings(std::string_view name) {
    return kOperators.settings(name);
}

core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makeObjectHandlingOperator(const ObjectHandlingOperatorSettings& settings,
                           const ObjectHandlingBriefing& briefing, std::uint64_t seed) {
    CHIRON_TRY(check(settings, briefing));
    return makeHands(std::make_unique<HandlingTrainee>(settings, briefing, seed), settings.perception,
                     settings.reach, {briefing.place}, seed);
}

HandlingTrainee::HandlingTrainee(const ObjectHandlingOperatorSettings& settings,
                                 const ObjectHandlingBriefing& briefing, std::uint64_t)
    : m_settings(settings), m_briefing(briefing) {}

HandlingTrainee::~HandlingTrainee() = default;

} // namespace chiron::operators
