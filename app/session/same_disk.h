// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::session {

/// True if two paths (or their nearest existing parents) are on the same disk, as far as the system reports
/// it: on the same file system, or on two partitions of one disk. The failure of that disk would destroy
/// both. Blocks for a short time.
bool onOneDisk(const std::string& a, const std::string& b);

} // namespace chiron::session
