// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input_file.h"

#include "catalogue/whole_file.h"
#include "cli/cli_errors.h"

#include <QFile>
#include <QJsonDocument>
#include <cstdio>

namespace chiron::cli {

core::Result<QByteArray> readInputFile(const QString& path, qint64 largestBytes) {
    return catalogue::readWholeFile(path, largestBytes);
}

core::Result<QByteArray> readStandardInput(qint64 largestBytes) {
    QFile input;
    if (!input.open(stdin, QIODevice::ReadOnly))
        return badInput(QStringLiteral("stdin: cannot be read: %1").arg(input.errorString()));
    // A read from a pipe returns what has been written so far; only an empty read means the end.
    QByteArray bytes;
    while (bytes.size() <= largestBytes) {
        const QByteArray part = input.read(largestBytes + 1 - bytes.size());
        if (part.isEmpty())
            break;
        bytes += part;
    }
    if (input.error() != QFileDevice::NoError)
        return badInput(
            QStringLiteral("stdin: broke off after %1 bytes (%2); expected it to be readable to its end")
                .arg(bytes.size())
                .arg(input.errorString()));
    if (bytes.size() > largestBytes)
        return badInput(QStringLiteral("stdin: more than %1 bytes; expected at most that").arg(largestBytes));
    return bytes;
}

core::Result<QJsonObject> readJsonObject(const QString& path) {
    constexpr qint64 kLargest = 16 << 20;
    const auto bytes = readInputFile(path, kLargest);
    CHIRON_TRY(bytes);
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(*bytes, &error);
    if (error.error != QJsonParseError::NoError) {
        const QByteArray before = bytes->left(error.offset);
        const qsizetype line = before.count('\n') + 1;
        const qsizetype column = error.offset - (before.lastIndexOf('\n') + 1) + 1;
        return badInput(QStringLiteral("%1:%2:%3: %4; expected a JSON object")
                            .arg(path)
                            .arg(line)
                            .arg(column)
                            .arg(error.errorString()));
    }
    if (!document.isObject())
        return badInput(QStringLiteral("%1: $: an array; expected a JSON object").arg(path));
    return document.object();
}

} // namespace chiron::cli
