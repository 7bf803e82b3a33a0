// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QCoreApplication;

namespace chiron::desktop {

/// Puts the catalogues of this language in the place of those that are installed: Qt's own where the system has them, then
/// ours. GUI thread.
void installLanguage(QCoreApplication& application, const QString& language);
/// In its own words, so that whoever reads it finds it: "English", "Deutsch", "Ελληνικά"; others as the system calls them.
QString languageName(const QString& language);

} // namespace chiron::desktop
