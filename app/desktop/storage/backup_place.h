// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::desktop {

class AppContext;

/// The folder that this station keeps its backups in: the one chosen, else "backups" beside the database.
QString backupPlace(AppContext& context);
void setBackupPlace(AppContext& context, const QString& folder);

} // namespace chiron::desktop
