// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/urethra_insertion/operators/operator_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace chiron::operators {

/// The scripted endoscopists of urethra insertion: novice, intermediate, expert, unsafe, hesitant. Static data; any thread.
std::span<const std::string_view> urethraInsertionOperatorNames() noexcept;

/// The settings a name stands for. Fails (notFound) for an unknown name, listing the known ones.
core::Result<UrethraInsertionOperatorSettings> urethraInsertionOperatorSettings(std::string_view name);

/// A mind that inserts, inspects and withdraws by what it sees and feels, for a SimulatedEndoscopeDevice. Seeded: the same seed
/// and the same perceptions give the same intentions. Fails (notFound) for an unknown name. Allocates; not in the tick.
core::Result<std::unique_ptr<mechanisms::HandStrategy>> makeUrethraInsertionOperator(std::string_view name, std::uint64_t seed);
/// The same with settings of one's own; fails (badInput) when one of them is out of its range.
core::Result<std::unique_ptr<mechanisms::HandStrategy>>
makeUrethraInsertionOperator(const UrethraInsertionOperatorSettings& settings, std::uint64_t seed);

} // namespace chiron::operators
