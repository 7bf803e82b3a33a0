// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::session {

/// Whether two places, or what is there of the way to them, lie on one disk, as far as the system tells: the same file system, or
/// two partitions of one disk. A disk that fails would take both. Blocking, short.
bool onOneDisk(const std::string& a, const std::string& b);

} // namespace chiron::session
