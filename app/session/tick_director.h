// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "haptics/live_inputs.h"

namespace chiron::session {

/// Runs a scripted session from inside: it gets each executed tick's frame, after the devices, and hands commands to the loop with
/// `inputs.postOwn()`, which takes them in the next tick. So an as-fast run is the same every time. Thread: haptic; as-fast runs only,
/// where it may allocate and wait.
class ITickDirector : public core::IFrameSink {
public:
    virtual void connect(haptics::LiveInputs& inputs) noexcept = 0; ///< before the first tick; outlives the run
};

} // namespace chiron::session
