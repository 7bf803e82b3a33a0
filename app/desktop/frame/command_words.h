// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::desktop {

/// Synonyms by which somebody may look for a command ("sign out" for "Log out"), in the program's language,
/// separated by commas; empty if there are none. `command` is the command's translated text, by which the
/// palette identifies it.
QString furtherWordsOf(const QString& command);

/// The synonym with a word that begins with the typed letters; empty if there is none.
QString furtherWordThatFits(const QString& typed, const QString& command);

} // namespace chiron::desktop
