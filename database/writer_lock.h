// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QLockFile>
#include <memory>
#include <string>

namespace chiron::database {

/// Takes "<file>.lock", which is held until the result is destroyed. A lock becomes stale only through the
/// death of its holder, never through age.
/// Errors: locked, within 1 s, naming program and pid; storage if the lock file cannot be made.
core::Result<std::unique_ptr<QLockFile>> takeWriterLock(const std::string& file);

} // namespace chiron::database
