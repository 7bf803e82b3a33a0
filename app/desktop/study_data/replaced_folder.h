// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>
#include <functional>

namespace chiron::desktop {

/// "study-csv", or the first of "study-csv-2", "study-csv-3", ... that does not exist.
QString freeFolder(const QString& folder);

/// Writes a folder by `write`. With `replaces` it replaces an existing folder: the old one is removed only
/// once the new one is complete, and put back if writing failed.
/// Errors: those of `write`; storage if the earlier folder cannot be moved away, moved back or removed.
core::Result<void> inPlaceOf(const QString& folder, bool replaces,
                             const std::function<core::Result<void>()>& write);

} // namespace chiron::desktop
