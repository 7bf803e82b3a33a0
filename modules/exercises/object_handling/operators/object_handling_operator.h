// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/object_handling/operators/operator_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::operators {

/// What a trainee is told before it begins: nothing that the instruction and the instrument in its hand do not say.
struct ObjectHandlingBriefing {
    bool weigh = false;           ///< the heaviest is to be set down in the target
    double liftHeight_m = 0.030;  ///< to be lifted so high on the way
    double jawLength_m = 0.020;   ///< of the instrument in its hand
    devices::WorkspaceMapping place; ///< where it enters
};

/// The scripted laparoscopists of object handling: novice, intermediate, expert, unsafe. Static data; any thread.
std::span<const std::string_view> objectHandlingOperatorNames() noexcept;

/// The settings a name stands for. Fails (notFound) for an unknown name, listing the known ones.
core::Result<ObjectHandlingOperatorSettings> objectHandlingOperatorSettings(std::string_view name);

/// A mind and its hand, for a SimulatedDevice at its place. Seeded: the same seed and the same perceptions give the same
/// intentions. Fails (badInput) when a setting or the briefing is out of its range. Allocates; not in the tick.
core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makeObjectHandlingOperator(const ObjectHandlingOperatorSettings& settings, const ObjectHandlingBriefing& briefing,
                           std::uint64_t seed);

} // namespace chiron::operators
