// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace chiron::operators {

/// The names of the scripted trainees of the sphere-apex exercise: novice, intermediate, expert, unsafe.
/// Static data.
/// Thread: any.
std::span<const std::string_view> sphereApexOperatorNames() noexcept;

/// Returns the settings of the trainee with this name.
/// Errors: notFound for an unknown name, listing the known ones.
core::Result<SphereApexOperatorSettings> sphereApexOperatorSettings(std::string_view name);

/// Makes the strategy of an operator that searches for the apex by what it feels (README.md), for a
/// SimulatedDevice. It is seeded: the same seed and the same perceptions give the same intentions. Allocates;
/// not for use in the tick.
/// Errors: notFound for an unknown name.
core::Result<std::unique_ptr<mechanisms::HandStrategy>> makeSphereApexOperator(std::string_view name,
                                                                               std::uint64_t seed);
/// Makes the same with the caller's own settings.
/// Errors: badInput when one of them is out of range.
core::Result<std::unique_ptr<mechanisms::HandStrategy>>
makeSphereApexOperator(const SphereApexOperatorSettings& settings, std::uint64_t seed);

} // namespace chiron::operators
