// SPDX-License-Identifier: GPL-3.0-or-later
// Makes palpators. This allocates, so it is kept apart from their strategies, which the tick calls.
#include "modules/exercises/palpation/operators/palpation_operator.h"

#include "core/random.h"
#include "modules/exercises/palpation/operators/palpating_finger.h"
#include "modules/exercises/palpation/operators/palpation_trainee.h"
#include "operators/settings/operator_table.h"
#include "operators/settings/setting_ranges.h"

#include <string>
#include <utility>

namespace chiron::operators {

namespace {

PalpationOperatorSettings novice() {
    PalpationOperatorSettings s;
    s.search = SearchKind::random;
    s.reach = 0.85;
    s.searchShare = 0.45;
    s.pressTime_s = 1.1;
    s.aimSd_m = 0.003;
    s.forceShare = 0.30;
    s.pressSd = 0.40;
    s.reachSpeed_m_per_s = 0.10;
    s.pressSpeed_m_per_s = 0.05;
    s.hover_m = 0.005;
    s.hold_s = 0.25;
    s.revisits = 0;
    s.criterion = 2.8;
    return s;
}

PalpationOperatorSettings intermediate() {
    PalpationOperatorSettings s;
    s.search = SearchKind::spiral;
    s.searchShare = 0.55;
    s.aimSd_m = 0.0015;
    s.pressSd = 0.15;
    s.hold_s = 0.28;
    s.revisits = 1;
    s.criterion = 3.3;
    return s;
}

PalpationOperatorSettings expert() {
    PalpationOperatorSettings s;
    s.spacing_m = 0.005; // the radius of a pad, if there is time; on an organ of 40 mm there is
    return s;
}

PalpationOperatorSettings unsafe() {
    PalpationOperatorSettings s = novice();
    s.hand = mechanisms::HandParameters::firm();
    s.forceShare = 1.9;
    s.reachSpeed_m_per_s = 0.20;
    s.pressSpeed_m_per_s = 0.12;
    return s;
}

constexpr OperatorTable<PalpationOperatorSettings, 4> kOperators(
    {{"novice", &novice}, {"intermediate", &intermediate}, {"expert", &expert}, {"unsafe", &unsafe}});

core::Result<void> check(const PalpationOperatorSettings& s) {
    return checkRanges({{"spacing_m", s.spacing_m, 0.002, 0.05},
                        {"reach", s.reach, 0.1, 1.0},
                        {"searchShare", s.searchShare, 0.1, 0.9},
                        {"pressTime_s", s.pressTime_s, 0.2, 10.0},
                        {"aimSd_m", s.aimSd_m, 0.0, 0.02},
                        {"forceShare", s.forceShare, 0.0, 5.0},
                        {"pressSd", s.pressSd, 0.0, 1.0},
                        {"pressures", static_cast<double>(s.pressures), 1.0, 3.0},
                        {"reachSpeed_m_per_s", s.reachSpeed_m_per_s, 0.01, 0.8},
                        {"pressSpeed_m_per_s", s.pressSpeed_m_per_s, 0.005, 0.5},
                        {"hover_m", s.hover_m, 0.001, 0.05},
                        {"hold_s", s.hold_s, 0.15, 5.0},
                        {"revisits", static_cast<double>(s.revisits), 0.0, 6.0},
                        {"revisitRadius_m", s.revisitRadius_m, 0.001, 0.03},
                        {"revisitAbove", s.revisitAbove, 0.0, 20.0},
                        {"criterion", s.criterion, 0.0, 20.0},
                        {"perception.touch_N", s.perception.touch_N, 0.001, 1.0},
                        {"hand.reactionDelay_s", s.hand.reactionDelay_s, 0.0, 0.5}});
}

core::Result<void> check(const PalpationBriefing& b) {
    return checkRanges({{"areaHalf_m.x", b.areaHalf_m.x(), 0.005, 0.2},
                        {"areaHalf_m.y", b.areaHalf_m.y(), 0.005, 0.2},
                        {"hands", static_cast<double>(b.hands), 1.0, 2.0},
                        {"fingers", static_cast<double>(b.fingers), 1.0, 2.0},
                        {"fingerSpacing_m", b.fingerSpacing_m, 0.008, 0.05},
                        {"bandLow_N", b.bandLow_N, 0.05, 10.0},
                        {"bandHigh_N", b.bandHigh_N, b.bandLow_N, 20.0}});
}

} // namespace

std::span<const std::string_view> palpationOperatorNames() noexcept {
    return kOperators.names();
}

core::Result<PalpationOperatorSettings> palpationOperatorSettings(std::string_view name) {
    return kOperators.settings(name);
}

core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makePalpationOperator(const PalpationOperatorSettings& settings, const PalpationBriefing& briefing,
                      std::uint64_t seed) {
    CHIRON_TRY(check(settings));
    CHIRON_TRY(check(briefing));
    const auto mind = std::make_shared<PalpationTrainee>(settings, briefing, seed);
    std::vector<std::unique_ptr<mechanisms::HandStrategy>> fingers;
    const auto tools = static_cast<std::size_t>(briefing.hands * briefing.fingers);
    for (std::size_t tool = 0; tool < tools; ++tool)
        fingers.push_back(std::make_unique<PalpatingFinger>(
            mind, tool, settings,
            tool < briefing.places.size() ? briefing.places[tool] : devices::WorkspaceMapping{},
            core::Random::mix(seed, "finger " + std::to_string(tool)), briefing.surface));
    return fingers;
}

PalpationTrainee::PalpationTrainee(const PalpationOperatorSettings& settings,
                                   const PalpationBriefing& briefing, std::uint64_t seed)
    : m_settings(settings), m_briefing(briefing), m_surface(briefing.surface),
      m_random(core::Random::stream(seed, "palpation/trainee")), m_map(briefing.areaHalf_m),
      m_yield_m_per_N(0.0025 / (0.5 * (briefing.bandLow_N + briefing.bandHigh_N))) {
    // Of two hands, the one that stands farther right takes the right half
    const auto& places = briefing.places;
    const auto second = static_cast<std::size_t>(briefing.fingers);
    m_rightFirst =
        briefing.hands > 1 && places.size() > second && places[0].origin_m[0] > places[second].origin_m[0];
}

PalpatingFinger::PalpatingFinger(std::shared_ptr<PalpationTrainee> mind, std::size_t tool,
                                 const PalpationOperatorSettings& settings,
                                 const devices::WorkspaceMapping& place, std::uint64_t seed,
                                 const simulation::SurfaceShape& drawn)
    : m_mind(std::move(mind)), m_tool(tool), m_map(place),
      m_senses(settings.perception, settings.hand, place, seed, drawn) {}

PalpatingFinger::~PalpatingFinger() = default;

} // namespace chiron::operators
