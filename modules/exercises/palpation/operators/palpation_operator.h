// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/palpation/operators/operator_settings.h"
#include "simulation/palpation/tissue_parameters.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::operators {

/// What a palpator is told and shown before it begins: nothing that the instruction, the drawn surface and its own hands do not
/// say. No lump is in it; those that a level shows come with the screen's cues.
struct PalpationBriefing {
    simulation::SurfaceShape surface;    ///< as drawn
    std::vector<simulation::StiffRegion> normal; ///< where the instruction says that firmness is normal; how firm stays unread
    core::Vec2 areaHalf_m{0.040, 0.040}; ///< to be searched: |x| ≤ , |y| ≤ round W's origin
    int hands = 1;                       ///< 1..2
    int fingers = 1;                     ///< 1..2 a hand, side by side along x
    double fingerSpacing_m = 0.018;
    double bandLow_N = 0.8;              ///< how hard to press, as instructed
    double bandHigh_N = 2.5;
    bool asksSize = false;               ///< what is to be said of a finding
    bool asksHardness = false;
    bool asksConfidence = true;
    std::vector<devices::WorkspaceMapping> places; ///< of each finger's device, in the order of the tools (a hand's fingers together);
                                                   ///< those missing: D is W
};

/// The scripted palpators: novice, intermediate, expert, unsafe. Static data; any thread.
std::span<const std::string_view> palpationOperatorNames() noexcept;

/// The settings a name stands for. Fails (notFound) for an unknown name, listing the known ones.
core::Result<PalpationOperatorSettings> palpationOperatorSettings(std::string_view name);

/// A mind and its fingers, one strategy a tool. Seeded: the same seed and the same perceptions give the same intentions. Fails
/// (badInput) when a setting or the briefing is out of its range. Allocates; not in the tick.
core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makePalpationOperator(const PalpationOperatorSettings& settings, const PalpationBriefing& briefing, std::uint64_t seed);

} // namespace chiron::operators
