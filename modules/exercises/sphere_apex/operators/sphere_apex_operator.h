// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/sphere_apex/operators/operator_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace chiron::operators {

/// The scripted trainees of the sphere-apex exercise: novice, intermediate, expert, unsafe. Static data; any
/// thread.
std::span<const std::string_view> sphereApexOperatorNames() noexcept;

/// The settings a name stands for. Fails (notFound) for an unknown name, listing the known ones.
core::Result<SphereApexOperatorSettings> sphereApexOperatorSettings(std::string_view name);

/// A mind that searches for the apex by what it feels (SphereApexOperator's page in README.md), for a
/// SimulatedDevice. Seeded: the same seed and the same perceptions give the same intentions. Fails (notFound)
/// for an unknown name. Allocates; not in the tick.
core::Result<std::unique_ptr<mechanisms::HandStrategy>> makeSphereApexOperator(std::string_view name,
                                                                               std::uint64_t seed);
/// The same with settings of one's own; fails (badInput) when one of them is out of its range.
core::Result<std::unique_ptr<mechanisms::HandStrategy>>
makeSphereApexOperator(const SphereApexOperatorSettings& settings, std::uint64_t seed);

} // namespace chiron::operators
