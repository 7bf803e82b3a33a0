// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>

namespace chiron::desktop {

/// A shortcut with its keys named as in every other text ("Ctrl+Page Down", "Enter"), in the language of the
/// program. Qt abbreviates some keys and has two names for Enter. Empty for an empty sequence.
/// Thread: GUI.
QString shortcutInWords(const QKeySequence& keys);

} // namespace chiron::desktop
