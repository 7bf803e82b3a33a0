// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// The event of the scene that only such a procedure has, in every frame (TickHeader::events, beside
/// core::event_bits, which leave this bit free). Its number is part of the recording's format.
namespace chiron::simulation::procedure_bits {

inline constexpr std::uint32_t kLandmarkSeen = 1u << 9; ///< one more landmark was inspected

} // namespace chiron::simulation::procedure_bits
