// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFileDialog;

namespace chiron::desktop {

class Settings;

/// Opens a file dialog in the folder that was last used for this purpose ("reports"), and remembers on this
/// station the folder that is chosen now. The first time it opens in `usual`, or else in the person's
/// documents folder. A remembered folder that no longer exists is ignored. Call it before suggesting a file
/// name (QFileDialog::selectFile).
/// Thread: GUI.
void beginInLastFolder(Settings& settings, QFileDialog& dialog, const QString& purpose,
                       const QString& usual = {});

} // namespace chiron::desktop
