// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_output.h"

#include <QString>
#include <memory>

namespace chiron::desktop {

/// A way to be heard, or why there is none. Everything that can be heard is shown as well, so training goes on without.
struct LoadedSound {
    std::unique_ptr<ISoundOutput> output; ///< null: silent
    QString whySilent;                    ///< one translated sentence; empty where it plays
};

/// Loads Qt Multimedia's plugin the first time (some 0.1 s) and opens the station's sound output. Sought in CHIRON_PLUGINS if
/// that is set, else in the program's own folder; CHIRON_NO_SOUND switches it off. Call it after the window has been
/// painted. GUI thread.
LoadedSound loadSound();

} // namespace chiron::desktop
