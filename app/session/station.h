// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device.h"
#include "devices/drivers/replay/replay_device.h"
#include "scoring/trace_rows.h"
#include "session/exercise_kind.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace chiron::session {

/// The tools a session is done with: one device each, and where each workspace lies in W. Moved, not copied.
struct Station {
    std::vector<std::unique_ptr<devices::IDevice>> devices;
    std::vector<devices::WorkspaceMapping> mappings;
    std::string operatorName; ///< scripted operator or "trace:<file>"; empty: a person's own hand
    const devices::ReplayDevice* trace = nullptr; ///< of `devices`, where a trace is played: its end ends the session
};

/// P2's simulated gimbal with a scripted operator on it. Failure: wrongUse naming the operators that exist.
core::Result<Station> scriptedStation(const ExerciseKind& kind, const std::string& operatorName, std::uint64_t seed);

/// A recorded trace as input device (class "shown": nobody feels anything). Failure: badInput naming file and row.
core::Result<Station> traceStation(const scoring::TraceRows& rows);

} // namespace chiron::session
