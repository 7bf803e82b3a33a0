// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sound/sound_cues.h"

#include <QByteArray>
#include <QtGlobal>

namespace chiron::desktop {

/// Plays cues. set() never blocks.
/// Thread: GUI.
class ISoundOutput {
public:
    ISoundOutput() = default;
    ISoundOutput(const ISoundOutput&) = delete;
    ISoundOutput& operator=(const ISoundOutput&) = delete;
    virtual ~ISoundOutput() = default;

    virtual void set(const SoundCues& cues) noexcept = 0;
    /// False once the output is found to be missing or has disappeared. It is polled, after half a second at
    /// the earliest.
    virtual bool works() const noexcept = 0;
};

/// The interface between the program and the plugin that links Qt Multimedia. Both must come from the same
/// build, which this text identifies.
inline QByteArray soundAbi() {
    return QByteArrayLiteral("chiron-sound 1 Qt " QT_VERSION_STR " ") +
           QByteArray::number(qulonglong(sizeof(SoundCues)));
}

inline constexpr const char* kSoundPluginFile = "chiron_sound.so"; ///< in the folder of the program
inline constexpr const char* kSoundAbiSymbol = "chironSoundAbi";
inline constexpr const char* kSoundMakeSymbol = "chironMakeSound";

using SoundAbiFunction = const char* (*)();
/// The caller owns the returned output; nullptr if the station has no sound output.
using SoundMakeFunction = ISoundOutput* (*)();

} // namespace chiron::desktop
