// SPDX-License-Identifier: GPL-3.0-or-later
// Makes hands and their decision model. This allocates, so it is kept apart from the code that the tick
// calls.
#include "core/random.h"
#include "operators/laparoscopy/scripted_hand.h"

#include <algorithm>
#include <string>
#include <utility>

namespace chiron::operators {

LaparoscopyMind::~LaparoscopyMind() = default;

SharedMind::SharedMind(std::unique_ptr<LaparoscopyMind> mind, std::size_t hands) noexcept
    : m_mind(std::move(mind)) {
    m_look.hands = std::min(hands, GraspLook::kHands);
}

ScriptedHand::ScriptedHand(std::shared_ptr<SharedMind> mind, std::size_t hand,
                           const GraspPerceptionSettings& perception, const GraspReachSettings& reach,
                           const devices::WorkspaceMapping& place, std::uint64_t seed)
    : m_mind(std::move(mind)), m_hand(hand), m_map(place), m_senses(perception, hand, place, seed),
      m_reach(reach) {}

ScriptedHand::~ScriptedHand() = default;

std::vector<std::unique_ptr<mechanisms::HandStrategy>>
makeHands(std::unique_ptr<LaparoscopyMind> mind, const GraspPerceptionSettings& perception,
          const GraspReachSettings& reach, const std::vector<devices::WorkspaceMapping>& places,
          std::uint64_t seed) {
    std::vector<std::unique_ptr<mechanisms::HandStrategy>> hands;
    const std::size_t count = std::min(places.size(), GraspLook::kHands);
    const auto shared = std::make_shared<SharedMind>(std::move(mind), count);
    for (std::size_t hand = 0; hand < count; ++hand)
        hands.push_back(
            std::make_unique<ScriptedHand>(shared, hand, perception, reach, places[hand],
                                           core::Random::mix(seed, "hand " + std::to_string(hand))));
    return hands;
}

} // namespace chiron::operators
