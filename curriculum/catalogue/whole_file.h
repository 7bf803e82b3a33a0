// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QString>

namespace chiron::catalogue {

/// Reads all bytes of a file that a person or another program may have put there.
/// Errors: notFound; badInput for a folder, a device or a pipe, and for more than `largestBytes`, which are
/// never read; storage if the file cannot be read to its end.
core::Result<QByteArray> readWholeFile(const QString& path, qint64 largestBytes);

} // namespace chiron::catalogue
