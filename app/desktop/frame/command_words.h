// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::desktop {

/// Further words by which somebody may look for a command ("sign out" for "Log out"), in the language of the program, with commas between
/// them; empty where there are none. `command`: its translated text, which is what the palette knows a command by.
QString furtherWordsOf(const QString& command);

/// The one of them that the letters begin a word of; empty: none does.
QString furtherWordThatFits(const QString& typed, const QString& command);

} // namespace chiron::desktop
