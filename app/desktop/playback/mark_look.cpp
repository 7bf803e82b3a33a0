// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/mark_look.h"

namespace chiron::desktop {

using session::PlaybackMarkKind;

QString markIcon(const session::PlaybackMark& mark) {
    return mark.critical ? QStringLiteral("dialog-error") : markIcon(mark.kind);
}

QString markIcon(PlaybackMarkKind kind) {
    switch (kind) {
    case PlaybackMarkKind::trialStarted:
        return QStringLiteral("go-next");
    case PlaybackMarkKind::marked:
        return QStringLiteral("flag");
    case PlaybackMarkKind::timedOut:
        return QStringLiteral("chronometer");
    case PlaybackMarkKind::traceEnded:
        return QStringLiteral("media-playback-stop");
    case PlaybackMarkKind::contact:
        return QStringLiteral("draw-circle");
    case PlaybackMarkKind::overLimit:
        return QStringLiteral("dialog-warning");
    case PlaybackMarkKind::paused:
        return QStringLiteral("media-playback-pause");
    case PlaybackMarkKind::forceStopped:
        return QStringLiteral("process-stop");
    case PlaybackMarkKind::rearmed:
        return QStringLiteral("media-playback-start");
    case PlaybackMarkKind::guard:
        return QStringLiteral("security-medium");
    case PlaybackMarkKind::fault:
        return QStringLiteral("dialog-error");
    case PlaybackMarkKind::ended:
        return QStringLiteral("media-playback-stop");
    case PlaybackMarkKind::completed:
        return QStringLiteral("flag");
    case PlaybackMarkKind::stageChanged:
        return QStringLiteral("go-next");
    case PlaybackMarkKind::landmarkSeen:
        return QStringLiteral("view-visible");
    case PlaybackMarkKind::trauma:
        return QStringLiteral("dialog-warning");
    case PlaybackMarkKind::reversal:
        return QStringLiteral("edit-undo");
    case PlaybackMarkKind::offCentre:
        return QStringLiteral("dialog-warning");
    case PlaybackMarkKind::overTorque:
        return QStringLiteral("dialog-warning");
    case PlaybackMarkKind::grasped:
        return QStringLiteral("object-locked");
    case PlaybackMarkKind::released:
        return QStringLiteral("object-unlocked");
    case PlaybackMarkKind::slipped:
        return QStringLiteral("go-down");
    case PlaybackMarkKind::damaged:
        return QStringLiteral("dialog-warning");
    case PlaybackMarkKind::yielded:
        return QStringLiteral("dialog-error");
    case PlaybackMarkKind::found:
        return QStringLiteral("flag");
    case PlaybackMarkKind::takenBack:
        return QStringLiteral("edit-undo");
    case PlaybackMarkKind::failed:
        return QStringLiteral("dialog-error");
    case PlaybackMarkKind::limited:
        return QStringLiteral("security-medium");
    case PlaybackMarkKind::missed:
        return QStringLiteral("dialog-close");
    case PlaybackMarkKind::falseAlarm:
        return QStringLiteral("dialog-close");
    case PlaybackMarkKind::lumpMissed:
        return QStringLiteral("dialog-close");
    }
    return {};
}

Colour markColour(PlaybackMarkKind kind) {
    if (session::isPenalty(kind))
        return Colour::bad;
    if (kind == PlaybackMarkKind::marked || kind == PlaybackMarkKind::completed ||
        kind == PlaybackMarkKind::landmarkSeen)
        return Colour::accent;
    return kind == PlaybackMarkKind::guard || kind == PlaybackMarkKind::limited ? Colour::warning
                                                                                : Colour::muted;
}

} // namespace chiron::desktop
