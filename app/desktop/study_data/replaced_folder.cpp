// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/replaced_folder.h"

#include <QDir>
#include <QFileInfo>

namespace chiron::desktop {

namespace {

tl::unexpected<core::Error> storageError(const QString& words) {
    return core::fail(core::ErrorCode::storage, words.toStdString());
}

} // namespace

QString freeFolder(const QString& folder) {
    QString free = folder;
    for (int n = 2; QFileInfo::exists(free); ++n)
        free = QStringLiteral("%1-%2").arg(folder).arg(n);
    return free;
}

core::Result<void> inPlaceOf(const QString& folder, bool replaces,
                             const std::function<core::Result<void>()>& write) {
    if (!replaces)
        return write();
    const QString before = freeFolder(folder + QStringLiteral("-before"));
    if (!QDir().rename(folder, before))
        return storageError(folder + QStringLiteral(": the earlier export cannot be moved away"));
    auto done = write();
    if (!done) {
        if (!QDir().rename(before, folder))
            return storageError(QStringLiteral("%1; the earlier export is now %2")
                                    .arg(QString::fromStdString(done.error().message), before));
        return done;
    }
    if (!QDir(before).removeRecursively())
        return storageError(before +
                            QStringLiteral(": the earlier export cannot be removed; the new one is whole"));
    return {};
}

} // namespace chiron::desktop
