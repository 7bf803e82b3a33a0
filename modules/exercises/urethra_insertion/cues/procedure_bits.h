// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// The events that only this scene has, in every frame (TickHeader::events). core::event_bits leave their
/// bits free. The numbers are part of the recording's format.
namespace chiron::simulation::procedure_bits {

inline constexpr std::uint32_t kLandmarkSeen = 1u << 9; ///< one more landmark was inspected

} // namespace chiron::simulation::procedure_bits
