// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/mark_look.h"

namespace chiron::desktop {

QString markIcon(const session::PlaybackMark& mark) {
    return mark.critical ? QStringLiteral("dialog-error") : markIcon(mark.kind);
}

QString markIcon(const session::PlaybackMarkKind& kind) {
    return QString::fromUtf8(kind.icon.data(), static_cast<qsizetype>(kind.icon.size()));
}

Colour markColour(const session::PlaybackMarkKind& kind) {
    switch (kind.tone) {
    case session::MarkTone::penalty:
        return Colour::bad;
    case session::MarkTone::success:
        return Colour::accent;
    case session::MarkTone::safety:
        return Colour::warning;
    case session::MarkTone::event:
        break;
    }
    return Colour::muted;
}

} // namespace chiron::desktop
