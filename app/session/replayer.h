// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/session_view.h"

#include <cstdint>
#include <optional>
#include <string>

namespace chiron::session {

struct ReplayReport {
    std::uint64_t frames = 0; ///< re-simulated
    bool identical = false;   ///< the hash of unrounded forces agrees for every chunk
    bool comparable = true;   ///< same models id, compiler and CPU class; only then must the bits agree
    /// Largest force difference at the stored resolution, tissue or commanded.
    double maximumDifference_N = 0.0;
    std::optional<std::uint64_t> firstDifferentTick; ///< start of the first chunk that differs
    std::string note; ///< the reason why it is not comparable, or why the replay ended
};

/// Re-simulates a session from its recorded inputs through the same loop, scene and supervisor, and compares
/// the forces.
/// Errors: those of the reader (damaged chunks); badInput if the recording has gaps.
core::Result<ReplayReport> replaySession(SessionView& session);

} // namespace chiron::session
