// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "haptics/delay_probe.h"

#include <atomic>

namespace chiron::session {

/// Measures the delay of a device that renders force while somebody holds it: opens it, applies a gentle
/// excitation force through a loop of its own (so that the supervisor arms and limits as usual), and closes
/// it. A device that is stepped in the tick runs faster than real time, any other device in real time on a
/// separate thread. Records nothing. Blocks for about 14 s of device time; call it on a worker.
/// Errors: wrongUse for a device without force; those of open(); doesNotHold if the delay could not be
///   determined or the device stopped half-way; cancelled by `cancel`.
core::Result<haptics::DelayEstimate> measureDelay(devices::IDevice& device,
                                                  const devices::WorkspaceMapping& mapping,
                                                  const haptics::DelayProbeSettings& settings = {},
                                                  const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
