// SPDX-License-Identifier: GPL-3.0-or-later
// Implements sound_output.h with Qt Multimedia, in a plugin, so that the program starts without loading it.
#include "desktop/sound/plugin/audio_sink_output.h"

#include <QMediaDevices>

using namespace chiron::desktop;

extern "C" Q_DECL_EXPORT const char* chironSoundAbi() {
    static const QByteArray text = soundAbi();
    return text.constData();
}

extern "C" Q_DECL_EXPORT ISoundOutput* chironMakeSound() {
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    return device.isNull() ? nullptr : new AudioSinkOutput(device);
}
