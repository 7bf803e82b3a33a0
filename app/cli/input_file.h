// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>

namespace chiron::cli {

/// The bytes of a file. Failure: notFound; badInput for a folder, an unreadable file or one over the limit.
core::Result<QByteArray> readInputFile(const QString& path, qint64 largestBytes);
/// Everything on stdin. Failure: badInput over the limit.
core::Result<QByteArray> readStandardInput(qint64 largestBytes);
/// A JSON object from a file. Failure: also badInput with line and column.
core::Result<QJsonObject> readJsonObject(const QString& path);

} // namespace chiron::cli
