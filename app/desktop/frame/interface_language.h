// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <utility>
#include <vector>

class QCoreApplication;

namespace chiron::desktop {

/// Replaces the installed translation catalogues with those of this language: Qt's own, if the system has
/// them, then Chiron's.
/// Thread: GUI.
void installLanguage(QCoreApplication& application, const QString& language);
/// The name of a language in that language, so that its speakers recognise it: "English", "Deutsch",
/// "Ελληνικά"; other languages as the system names them.
QString languageName(const QString& language);
/// The languages of the interface, each with its id ("de") and its name in that language; English comes
/// first.
std::vector<std::pair<QString, QString>> languageChoices();

} // namespace chiron::desktop
