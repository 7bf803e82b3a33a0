// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/object_handling/operators/object_handling_operator_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::operators {

/// Instructions to a trainee before it begins. They contain nothing beyond what the instruction on the screen
/// and the instrument in its hand say.
struct ObjectHandlingBriefing {
    bool weigh = false;              ///< the heaviest object is to be set down in the target
    double liftHeight_m = 0.030;     ///< height to which an object has to be lifted on the way
    double jawLength_m = 0.020;      ///< of the instrument in its hand
    devices::WorkspaceMapping place; ///< where the instrument enters
};

/// The names of the scripted laparoscopists of object handling: novice, intermediate, expert, unsafe. Static
/// data.
/// Thread: any.
std::span<const std::string_view> objectHandlingOperatorNames() noexcept;

/// Returns the settings of the laparoscopist with this name.
/// Errors: notFound for an unknown name, listing the known ones.
core::Result<ObjectHandlingOperatorSettings> objectHandlingOperatorSettings(std::string_view name);

/// Makes a strategy and its hand, for a SimulatedDevice at its place. It is seeded: the same seed and the
/// same perceptions give the same intentions. Allocates; not for use in the tick.
/// Errors: badInput when a setting or the briefing is out of range.
core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makeObjectHandlingOperator(const ObjectHandlingOperatorSettings& settings,
                           const ObjectHandlingBriefing& briefing, std::uint64_t seed);

} // namespace chiron::operators
