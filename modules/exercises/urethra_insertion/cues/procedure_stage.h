// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::simulation {

/// Stage of a procedure that goes into the body and out again. The numbers are part of the recording's
/// format.
enum class ProcedureStage : std::uint8_t {
    outside = 0,    ///< the beak has not entered
    insertion = 1,  ///< on the way to the level's goal
    inspection = 2, ///< the main operation: landmarks are visited
    withdrawal = 3, ///< on the way out
    completed = 4,  ///< everything that the level asks for is done
};

} // namespace chiron::simulation
