// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFileDialog;

namespace chiron::desktop {

class Settings;

/// Lets a file dialog begin where something was chosen last for this purpose ("reports"), the first time in `usual`, or else in the
/// person's documents; and remembers on this station what is chosen now. A folder that is gone is no place to begin. Call it before a
/// file is suggested (QFileDialog::selectFile). GUI thread.
void beginInLastFolder(Settings& settings, QFileDialog& dialog, const QString& purpose, const QString& usual = {});

} // namespace chiron::desktop
