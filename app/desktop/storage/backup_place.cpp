// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/backup_place.h"

#include "desktop/frame/app_context.h"
#include "session/backup_list.h"

namespace chiron::desktop {

QString backupPlace(AppContext& context) {
    const QString chosen = context.settings().backupFolder();
    return chosen.isEmpty()
               ? QString::fromStdString(session::defaultBackupFolder(context.site().file().toStdString()))
               : chosen;
}

void setBackupPlace(AppContext& context, const QString& folder) {
    context.settings().setBackupFolder(folder);
}

} // namespace chiron::desktop
