// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/whole_file.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace chiron::catalogue {

namespace {

tl::unexpected<core::Error> bad(core::ErrorCode code, const QString& text) {
    return tl::unexpected(core::Error{code, text.toStdString()});
}

} // namespace

core::Result<QByteArray> readWholeFile(const QString& path, qint64 largestBytes) {
    const QFileInfo info(path);
    if (!info.exists())
        return bad(core::ErrorCode::notFound, path + QStringLiteral(": no such file"));
    if (!info.isFile())
        return bad(
            core::ErrorCode::badInput,
            QStringLiteral("%1: is %2; expected a file")
                .arg(path, info.isDir() ? QStringLiteral("a folder") : QStringLiteral("not a regular file")));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return bad(core::ErrorCode::badInput,
                   QStringLiteral("%1: cannot be read: %2").arg(path, file.errorString()));
    QByteArray bytes;
    while (bytes.size() <= largestBytes) { // the size may change while the file is read
        const QByteArray part = file.read(largestBytes + 1 - bytes.size());
        if (part.isEmpty())
            break;
        bytes += part;
    }
    if (file.error() != QFileDevice::NoError)
        return bad(core::ErrorCode::storage,
                   QStringLiteral("%1: cannot be read to its end: %2").arg(path, file.errorString()));
    if (bytes.size() > largestBytes)
        return bad(core::ErrorCode::badInput, QStringLiteral("%1: %2 bytes; expected at most %3")
                                                  .arg(path)
                                                  .arg(std::max(info.size(), bytes.size()))
                                                  .arg(largestBytes));
    return bytes;
}

} // namespace chiron::catalogue
