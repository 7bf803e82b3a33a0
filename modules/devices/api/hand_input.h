// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/endoscope_mailbox.h"
#include "devices/api/pointer_mailbox.h"

#include <variant>

namespace chiron::devices {

/// Where a window puts what a person does with mouse and keys, for a device that is moved that way; std::monostate: the device is
/// moved by something else. Belongs to the device. Threads: as the mailboxes say.
using HandInput = std::variant<std::monostate, PointerMailbox*, EndoscopeMailbox*>;

} // namespace chiron::devices
