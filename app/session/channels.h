// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/channel_table.h"
#include "session/session_setup.h"

namespace chiron::session {

/// The channel table of a session's recording, from its devices' axes and what its kind of exercise records of the scene.
/// Failure: an exercise that does not exist; what ChannelTable::forTools refuses.
core::Result<recording::ChannelTable> channelTableFor(const SessionSetup& setup);

} // namespace chiron::session
