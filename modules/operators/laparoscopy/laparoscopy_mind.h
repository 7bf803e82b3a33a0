// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "operators/laparoscopy/grasp_reach.h"
#include "operators/laparoscopy/grasp_senses.h"

#include <array>
#include <cstddef>

namespace chiron::operators {

/// What one to three hands feel and see in one percept, and the wanted angles of their jaws, which the
/// decision model knows because it moves them.
struct GraspLook {
    static constexpr std::size_t kHands = 3;
    std::array<GraspPercept, kHands> hand;
    std::array<double, kHands> jaw_rad{}; ///< as last wanted
    std::size_t hands = 1;

    const GraspPercept& first() const noexcept { return hand[0]; }
};

using GraspWishes = std::array<GraspWish, GraspLook::kHands>; ///< W

/// Decision model for all hands of one laparoscopist. It is called after every percept (100 per second) of
/// the last hand.
/// Thread: haptic; allocates nothing.
class LaparoscopyMind {
public:
    LaparoscopyMind() = default;
    LaparoscopyMind(const LaparoscopyMind&) = delete;
    LaparoscopyMind& operator=(const LaparoscopyMind&) = delete;
    virtual ~LaparoscopyMind();
    virtual void think(const GraspLook& felt, GraspWishes& wishes) noexcept = 0;
};

} // namespace chiron::operators
