// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/channel_table.h"
#include "session/session_setup.h"

namespace chiron::session {

/// The channel table of a session's recording, from the axes of its devices and the scene quantities that its
/// exercise records.
/// Errors: notFound for an unknown exercise; those of ChannelTable::forTools.
core::Result<recording::ChannelTable> channelTableFor(const SessionSetup& setup);

} // namespace chiron::session
