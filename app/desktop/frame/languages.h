// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QCoreApplication;

namespace chiron::desktop {

/// Puts the catalogues of this language in the place of those that are installed: Qt's own where the system has them, then
/// ours. GUI thread.
void installLanguage(QCoreApplication& application, const QString& language);

} // namespace chiron::desktop
