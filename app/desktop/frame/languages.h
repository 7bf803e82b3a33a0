// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <utility>
#include <vector>

class QCoreApplication;

namespace chiron::desktop {

/// Puts the catalogues of this language in the place of those that are installed: Qt's own where the system has them, then
/// ours. GUI thread.
void installLanguage(QCoreApplication& application, const QString& language);
/// In its own words, so that whoever reads it finds it: "English", "Deutsch", "Ελληνικά"; others as the system calls them.
QString languageName(const QString& language);
/// The languages that the interface can be in, each as its id ("de") and its name in its own words, English first.
std::vector<std::pair<QString, QString>> languageChoices();

} // namespace chiron::desktop
