// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/palpation/operators/palpation_operator_settings.h"
#include "simulation/palpation/tissue_parameters.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::operators {

/// Instructions to a palpator before it begins. They contain nothing beyond what the instruction on the
/// screen, the drawn surface and its own hands say. They name no lump; lumps that a level shows come with the
/// screen's cues.
struct PalpationBriefing {
    simulation::SurfaceShape surface; ///< as drawn
    /// Where the instruction says that firmness is normal; the strategy does not read how firm.
    std::vector<simulation::StiffRegion> normal;
    core::Vec2 areaHalf_m{0.040, 0.040}; ///< area to be searched: |x| ≤ , |y| ≤ around W's origin
    int hands = 1;                       ///< 1..2
    int fingers = 1;                     ///< 1..2 per hand, side by side along x
    double fingerSpacing_m = 0.018;
    double bandLow_N = 0.8; ///< instructed force band for pressing
    double bandHigh_N = 2.5;
    bool asksSize = false; ///< what has to be stated about a finding
    bool asksHardness = false;
    bool asksConfidence = true;
    /// Mapping of each finger's device, in the order of the tools (a hand's fingers together); for missing
    /// ones D is W.
    std::vector<devices::WorkspaceMapping> places;
};

/// The names of the scripted palpators: novice, intermediate, expert, unsafe. Static data.
/// Thread: any.
std::span<const std::string_view> palpationOperatorNames() noexcept;

/// Returns the settings of the palpator with this name.
/// Errors: notFound for an unknown name, listing the known ones.
core::Result<PalpationOperatorSettings> palpationOperatorSettings(std::string_view name);

/// Makes a palpator with its fingers, one HandStrategy per tool. It is seeded: the same seed and the same
/// perceptions give the same intentions. Allocates; not for use in the tick.
/// Errors: badInput when a setting or the briefing is out of range.
core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makePalpationOperator(const PalpationOperatorSettings& settings, const PalpationBriefing& briefing,
                      std::uint64_t seed);

} // namespace chiron::operators
