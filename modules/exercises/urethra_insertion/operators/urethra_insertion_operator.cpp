// SPDX-License-Identifier: GPL-3.0-or-later
// Makes endoscopists. This allocates, so it is kept apart from their strategies, which the tick calls.
#include "modules/exercises/urethra_insertion/operators/urethra_insertion_operator.h"

#include "modules/exercises/urethra_insertion/operators/scripted_endoscopist.h"
#include "operators/settings/operator_table.h"
#include "operators/settings/setting_ranges.h"

namespace chiron::operators {

namespace {

UrethraInsertionOperatorSettings novice() {
    UrethraInsertionOperatorSettings s;
    s.steering = SteeringKind::centresLate;
    s.insertSpeed_m_per_s = 0.012;
    s.withdrawSpeed_m_per_s = 0.015;
    s.turnGain_per_s = 2.0;
    s.turnRate_rad_per_s = 0.5;
    s.deadZone_rad = 0.38;
    s.overshoot_rad = 0.10;
    s.stopAngle_rad = 3.2;
    s.stopsBlind = false;
    s.pushLimit_N = 5.0;
    s.acrossLimit_N = 5.0;
    s.reliefGain_m_per_Ns = 0.0;
    s.reliefTurn_rad_per_Nms = 0.0;
    s.lookRate_rad_per_s = 0.6;
    s.lookWithin_rad = 0.05;
    s.searchAngle_rad = 0.45;
    s.stopsWhenCounted = false;
    s.anticipation_s = 0.0;
    s.centringGain_per_s = 0.0;
    s.alignsBeforeWithdrawal = false;
    return s;
}

UrethraInsertionOperatorSettings intermediate() {
    UrethraInsertionOperatorSettings s;
    s.steering = SteeringKind::centres;
    s.insertSpeed_m_per_s = 0.009;
    s.withdrawSpeed_m_per_s = 0.010;
    s.turnGain_per_s = 1.0;
    s.turnRate_rad_per_s = 0.4;
    s.stopAngle_rad = 0.6;
    s.pushLimit_N = 3.5;
    s.acrossLimit_N = 2.5;
    s.reliefGain_m_per_Ns = 0.004;
    s.reliefTurn_rad_per_Nms = 1.0;
    s.lookRate_rad_per_s = 0.4;
    s.lookWithin_rad = 0.10;
    s.stopsWhenCounted = false;
    s.anticipation_s = 0.25;
    s.centringGain_per_s = 0.4;
    return s;
}

UrethraInsertionOperatorSettings expert() {
    return {};
}

UrethraInsertionOperatorSettings unsafe() {
    UrethraInsertionOperatorSettings s = novice();
    s.hand = mechanisms::HandParameters::firm();
    s.insertSpeed_m_per_s = 0.025;
    s.withdrawSpeed_m_per_s = 0.025;
    s.turnRate_rad_per_s = 0.8;
    s.deadZone_rad = 0.40;
    s.pushLimit_N = 12.0;
    s.acrossLimit_N = 12.0;
    s.lookRate_rad_per_s = 1.0;
    return s;
}

/// Draws back from a felt force and tries again. Without an operator that turns back, nothing would show that
/// reversals are counted.
UrethraInsertionOperatorSettings hesitant() {
    UrethraInsertionOperatorSettings s = intermediate();
    s.drawsBackAt_N = 0.4;
    return s;
}

constexpr OperatorTable<UrethraInsertionOperatorSettings, 5> kOperators({{"novice", &novice},
                                                                         {"intermediate", &intermediate},
                                                                         {"expert", &expert},
                                                                         {"unsafe", &unsafe},
                                                                         {"hesitant", &hesitant}});

core::Result<void> check(const UrethraInsertionOperatorSettings& s) {
    return checkRanges({{"insertSpeed_m_per_s", s.insertSpeed_m_per_s, 0.001, 0.1},
                        {"withdrawSpeed_m_per_s", s.withdrawSpeed_m_per_s, 0.001, 0.1},
                        {"curveGain", s.curveGain, 0.2, 3.0},
                        {"turnGain_per_s", s.turnGain_per_s, 0.1, 5.0},
                        {"turnRate_rad_per_s", s.turnRate_rad_per_s, 0.05, 2.0},
                        {"deadZone_rad", s.deadZone_rad, 0.0, 1.0},
                        {"overshoot_rad", s.overshoot_rad, 0.0, 0.5},
                        {"stopAngle_rad", s.stopAngle_rad, 0.1, 3.2},
                        {"pushLimit_N", s.pushLimit_N, 0.2, 20.0},
                        {"acrossLimit_N", s.acrossLimit_N, 0.2, 20.0},
                        {"reliefGain_m_per_Ns", s.reliefGain_m_per_Ns, 0.0, 0.05},
                        {"reliefTurn_rad_per_Nms", s.reliefTurn_rad_per_Nms, 0.0, 20.0},
                        {"lookRate_rad_per_s", s.lookRate_rad_per_s, 0.05, 2.0},
                        {"lookWithin_rad", s.lookWithin_rad, 0.01, 0.6},
                        {"searchAngle_rad", s.searchAngle_rad, 0.05, 0.6},
                        {"anticipation_s", s.anticipation_s, 0.0, 2.0},
                        {"centringGain_per_s", s.centringGain_per_s, 0.0, 3.0},
                        {"drawsBackAt_N", s.drawsBackAt_N, 0.0, 20.0},
                        {"hand.reactionDelay_s", s.hand.reactionDelay_s, 0.0, 0.5}});
}

} // namespace

std::span<const std::string_view> urethraInsertionOperatorNames() noexcept {
    return kOperators.names();
}

core::Result<UrethraInsertionOperatorSettings> urethraInsertionOperatorSettings(std::string_view name) {
    return kOperators.settings(name);
}

core::Result<std::unique_ptr<mechanisms::HandStrategy>> makeUrethraInsertionOperator(std::string_view name,
                                                                                     std::uint64_t seed) {
    const auto settings = urethraInsertionOperatorSettings(name);
    CHIRON_TRY(settings);
    return makeUrethraInsertionOperator(*settings, seed);
}

core::Result<std::unique_ptr<mechanisms::HandStrategy>>
makeUrethraInsertionOperator(const UrethraInsertionOperatorSettings& settings, std::uint64_t seed) {
    CHIRON_TRY(check(settings));
    return std::make_unique<ScriptedEndoscopist>(settings, seed);
}

ScriptedEndoscopist::ScriptedEndoscopist(const UrethraInsertionOperatorSettings& settings, std::uint64_t seed)
    : m_settings(settings), m_senses(settings.perception, seed), m_lookWithin_rad(settings.lookWithin_rad) {}

ScriptedEndoscopist::~ScriptedEndoscopist() = default;

} // namespace chiron::operators
