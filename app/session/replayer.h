// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/session_view.h"

#include <cstdint>
#include <optional>
#include <string>

namespace chiron::session {

struct ReplayReport {
    std::uint64_t frames = 0;       ///< re-simulated
    bool identical = false;         ///< every chunk's hash of unrounded forces is the recorded one
    bool comparable = true;         ///< same models id, compiler and CPU class: only then must bits agree
    double maximumDifference_N = 0.0; ///< largest force difference at the stored resolution, tissue or commanded
    std::optional<std::uint64_t> firstDifferentTick; ///< start of the first chunk that differs
    std::string note;               ///< why it is not comparable, or what ended the replay
};

/// Re-simulates a session from its recorded inputs through the same loop, scene and supervisor, and compares the
/// forces. Failure: the reader's (damaged chunks), badInput where the recording has gaps.
core::Result<ReplayReport> replaySession(SessionView& session);

} // namespace chiron::session
