// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "operators/laparoscopy/laparoscopy_mind.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::operators {

/// One decision model that several hands share. It receives the percept of each hand and decides once the
/// last of them has reported. Tool 0 is called first in a tick, so a decision moves the first hand in the
/// next tick.
class SharedMind {
public:
    SharedMind(std::unique_ptr<LaparoscopyMind> mind, std::size_t hands) noexcept;
    void hear(std::size_t hand, const GraspPercept& felt, double jaw_rad) noexcept;
    const GraspWish& wishOf(std::size_t hand) const noexcept { return m_wishes[hand]; }

private:
    std::unique_ptr<LaparoscopyMind> m_mind;
    GraspLook m_look;
    GraspWishes m_wishes{};
};

/// One hand of a scripted laparoscopist, with its own senses and reach and the decision model that it shares
/// with the other hands.
/// Thread: haptic; allocates nothing after construction.
class ScriptedHand final : public mechanisms::HandStrategy {
public:
    ScriptedHand(std::shared_ptr<SharedMind> mind, std::size_t hand,
                 const GraspPerceptionSettings& perception, const GraspReachSettings& reach,
                 const devices::WorkspaceMapping& place, std::uint64_t seed);
    ~ScriptedHand() override;
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override;

private:
    /// Shared because the hands are in different devices; it is destroyed with the last of them.
    std::shared_ptr<SharedMind> m_mind;
    std::size_t m_hand;
    devices::WorkspaceMap m_map;
    GraspSenses m_senses;
    GraspReach m_reach;
};

/// Makes the hands in the order of the tools, each at its instrument's position. Allocates; not for the tick.
std::vector<std::unique_ptr<mechanisms::HandStrategy>>
makeHands(std::unique_ptr<LaparoscopyMind> mind, const GraspPerceptionSettings& perception,
          const GraspReachSettings& reach, const std::vector<devices::WorkspaceMapping>& places,
          std::uint64_t seed);

} // namespace chiron::operators
