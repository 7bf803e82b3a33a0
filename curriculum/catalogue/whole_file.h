// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QString>

namespace chiron::catalogue {

/// All bytes of a file that people or other programs may have put there. Failure: notFound; badInput for a folder, a device or pipe, and
/// for more than `largestBytes`, which are never read; storage where it cannot be read to its end.
core::Result<QByteArray> readWholeFile(const QString& path, qint64 largestBytes);

} // namespace chiron::catalogue
