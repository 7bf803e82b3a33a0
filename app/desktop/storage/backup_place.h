// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::desktop {

class AppContext;

/// The folder for this station's backups: the chosen one, else "backups" beside the database.
QString backupPlace(AppContext& context);
void setBackupPlace(AppContext& context, const QString& folder);

} // namespace chiron::desktop
