// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/urethra_insertion/operators/urethra_insertion_operator_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace chiron::operators {

/// The names of the scripted endoscopists of urethra insertion: novice, intermediate, expert, unsafe,
/// hesitant. Static data.
/// Thread: any.
std::span<const std::string_view> urethraInsertionOperatorNames() noexcept;

/// Returns the settings of the endoscopist with this name.
/// Errors: notFound for an unknown name, listing the known ones.
core::Result<UrethraInsertionOperatorSettings> urethraInsertionOperatorSettings(std::string_view name);

/// Makes a strategy that inserts, inspects and withdraws by what it sees and feels, for a
/// SimulatedEndoscopeDevice. It is seeded: the same seed and the same perceptions give the same intentions.
/// Allocates; not for use in the tick.
/// Errors: notFound for an unknown name.
core::Result<std::unique_ptr<mechanisms::HandStrategy>> makeUrethraInsertionOperator(std::string_view name,
                                                                                     std::uint64_t seed);
/// Makes the same with the caller's own settings.
/// Errors: badInput when one of them is out of range.
core::Result<std::unique_ptr<mechanisms::HandStrategy>>
makeUrethraInsertionOperator(const UrethraInsertionOperatorSettings& settings, std::uint64_t seed);

} // namespace chiron::operators
