// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "haptics/live_inputs.h"

namespace chiron::session {

/// Controls a scripted session from inside: it receives the frame of each executed tick, after the devices,
/// and sends commands to the loop with `inputs.postOwn()`, which takes effect in the next tick. A run faster
/// than real time is therefore reproducible.
/// Thread: haptic; only in runs faster than real time, in which it may allocate and wait.
class ITickDirector : public core::IFrameSink {
public:
    /// Called before the first tick; `inputs` outlives the run.
    virtual void connect(haptics::LiveInputs& inputs) noexcept = 0;
};

} // namespace chiron::session
