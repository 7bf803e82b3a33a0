// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "haptics/delay_probe.h"

#include <atomic>

namespace chiron::session {

/// Measures the delay of a device that renders force, with whoever holds it: opens it, shakes it gently through a loop of its own (so the
/// supervisor arms and limits as ever), closes it. A device that is stepped in the tick is run as fast as the machine can, any other in
/// real time on a thread of its own. Blocking, about 14 s of device time; a worker's task. Nothing is recorded.
/// Failure: wrongUse for a device without force; what open() says; doesNotHold where it could not be told, or the device stopped half-way;
/// cancelled by `cancel`.
core::Result<haptics::DelayEstimate> measureDelay(devices::IDevice& device, const devices::WorkspaceMapping& mapping,
                                                  const haptics::DelayProbeSettings& settings = {},
                                                  const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
