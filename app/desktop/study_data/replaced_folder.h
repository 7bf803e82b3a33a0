// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>
#include <functional>

namespace chiron::desktop {

/// "study-csv", or the first of "study-csv-2", "study-csv-3", ... that does not exist.
QString freeFolder(const QString& folder);

/// Writes a folder by `write`, with `replaces` in the place of the one that is there: that one goes only once the new one is whole, and is
/// back where it was if writing failed. Failure: that of `write`; storage, where the earlier one cannot be moved away, back or removed.
core::Result<void> inPlaceOf(const QString& folder, bool replaces, const std::function<core::Result<void>()>& write);

} // namespace chiron::desktop
