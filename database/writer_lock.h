// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QLockFile>
#include <memory>
#include <string>

namespace chiron::database {

/// Takes "<file>.lock", held until destroyed. Age never makes it stale, only the death of its holder.
/// Failure: locked, within 1 s, naming program and pid; storage when the lock file cannot be made.
core::Result<std::unique_ptr<QLockFile>> takeWriterLock(const std::string& file);

} // namespace chiron::database
