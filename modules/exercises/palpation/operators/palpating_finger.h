// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/workspace_map.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/palpation/operators/finger_reach.h"
#include "modules/exercises/palpation/operators/finger_senses.h"
#include "modules/exercises/palpation/operators/palpation_trainee.h"

#include <cstdint>
#include <memory>

namespace chiron::operators {

/// One finger of a scripted palpator: its own senses and reach, and the PalpationTrainee (strategy) that it
/// shares with the other fingers. Tool 0 is evaluated first in a tick, so a decision made in a tick moves the
/// first finger in the next tick.
/// Thread: haptic; allocates nothing after construction.
class PalpatingFinger final : public mechanisms::HandStrategy {
public:
    PalpatingFinger(std::shared_ptr<PalpationTrainee> mind, std::size_t tool,
                    const PalpationOperatorSettings& settings, const devices::WorkspaceMapping& place,
                    std::uint64_t seed, const simulation::SurfaceShape& drawn);
    ~PalpatingFinger() override;
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override;

private:
    /// Shared, because the fingers live in different devices; destroyed with the last finger.
    std::shared_ptr<PalpationTrainee> m_mind;
    std::size_t m_tool;
    devices::WorkspaceMap m_map;
    FingerSenses m_senses;
    FingerReach m_reach;
    core::Quat m_turn = core::Quat::Identity(); ///< D
    bool m_awake = false;
};

} // namespace chiron::operators
