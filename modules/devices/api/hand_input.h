// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/endoscope_mailbox.h"
#include "devices/api/pointer_mailbox.h"

#include <variant>

namespace chiron::devices {

/// Where a window puts a person's mouse and key input, for a device that is moved in this way; std::monostate
/// if something else moves the device. It belongs to the device.
/// Thread: as the mailboxes say.
using HandInput = std::variant<std::monostate, PointerMailbox*, EndoscopeMailbox*>;

} // namespace chiron::devices
