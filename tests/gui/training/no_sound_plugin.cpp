// SPDX-License-Identifier: GPL-3.0-or-later
// The sound part of Chiron on a station without a sound output, or (OTHER_VERSION) of another version.
#include "desktop/sound/sound_output.h"

extern "C" Q_DECL_EXPORT const char* chironSoundAbi() {
#ifdef OTHER_VERSION
    return "chiron-sound 0";
#else
    static const QByteArray text = chiron::desktop::soundAbi();
    return text.constData();
#endif
}

extern "C" Q_DECL_EXPORT chiron::desktop::ISoundOutput* chironMakeSound() {
    return nullptr;
}
