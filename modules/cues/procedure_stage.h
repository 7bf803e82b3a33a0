// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::core {

/// Stage of a procedure that goes into the body and out again. The numbers are part of the recording's
/// format.
enum class ProcedureStage : std::uint8_t {
    outside = 0,    ///< the beak has not entered
    insertion = 1,  ///< on the way to the level's goal
    inspection = 2, ///< the main operation: landmarks are visited
    withdrawal = 3, ///< on the way out
    completed = 4,  ///< everything that the level asks for is done
};

/// The event of the scene that only such a procedure has, in every frame (TickHeader::events, beside
/// core::event_bits, which leave this bit free). Its number is part of the recording's format.
namespace procedure_bits {
inline constexpr std::uint32_t kLandmarkSeen = 1u << 9; ///< one more landmark was inspected
} // namespace procedure_bits

} // namespace chiron::core
