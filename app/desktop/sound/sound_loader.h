// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_output.h"

#include <QString>
#include <memory>

namespace chiron::desktop {

/// A sound output, or the reason why there is none. Everything audible is also shown, so training works
/// without sound.
struct LoadedSound {
    std::unique_ptr<ISoundOutput> output; ///< null: no sound
    QString whySilent;                    ///< one translated sentence; empty if sound works
};

/// Loads Qt Multimedia's plugin the first time (some 0.1 s) and opens the station's sound output. The plugin
/// is sought in CHIRON_PLUGINS if that is set, else in the program's own folder; CHIRON_NO_SOUND disables
/// sound. Call it after the window has been painted.
/// Thread: GUI.
LoadedSound loadSound();

} // namespace chiron::desktop
