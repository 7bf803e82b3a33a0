// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "haptics/display_state.h"
#include "session/session_view.h"
#include "simulation/scene.h"

#include <functional>

namespace chiron::tests {

/// One tick of a stored session, simulated again.
struct TickAgain {
    const core::HapticFrame& recorded;
    const core::HapticFrame& frame;       ///< the same with its forces as they were, not rounded
    const simulation::SceneOutput& scene; ///< what the scene answered, of which a recording has a part
    const haptics::DisplayState& shown;   ///< what a window would have got
};

/// Runs a session from its recorded inputs through its own loop, scene and supervisor, as
/// session::replaySession does, and lets every tick be looked at. Failure: the reader's.
core::Result<void> simulateAgain(session::SessionView& session,
                                 const std::function<void(const TickAgain&)>& look);

} // namespace chiron::tests
