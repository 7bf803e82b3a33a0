// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "operators/laparoscopy/grasp_reach.h"
#include "operators/laparoscopy/grasp_senses.h"

#include <array>
#include <cstddef>

namespace chiron::operators {

/// What one to three hands feel and see at one look, and where their mind's own jaws stand (it moves them, so it knows).
struct GraspLook {
    static constexpr std::size_t kHands = 3;
    std::array<GraspPercept, kHands> hand;
    std::array<double, kHands> jaw_rad{}; ///< as last wanted
    std::size_t hands = 1;

    const GraspPercept& first() const noexcept { return hand[0]; }
};

using GraspWishes = std::array<GraspWish, GraspLook::kHands>; ///< W

/// What decides for all hands of one laparoscopist. Asked at every look (100 a second) of the last of its hands. Haptic thread;
/// no allocation.
class LaparoscopyMind {
public:
    LaparoscopyMind() = default;
    LaparoscopyMind(const LaparoscopyMind&) = delete;
    LaparoscopyMind& operator=(const LaparoscopyMind&) = delete;
    virtual ~LaparoscopyMind();
    virtual void think(const GraspLook& felt, GraspWishes& wishes) noexcept = 0;
};

} // namespace chiron::operators
