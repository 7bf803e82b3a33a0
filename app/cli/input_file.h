// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>

namespace chiron::cli {

/// Reads the bytes of a file.
/// Errors: notFound; badInput for a folder, an unreadable file or a file over the limit.
core::Result<QByteArray> readInputFile(const QString& path, qint64 largestBytes);
/// Reads stdin to its end.
/// Errors: badInput over the limit.
core::Result<QByteArray> readStandardInput(qint64 largestBytes);
/// Reads a JSON object from a file.
/// Errors: those of readInputFile(); badInput with line and column.
core::Result<QJsonObject> readJsonObject(const QString& path);

} // namespace chiron::cli
