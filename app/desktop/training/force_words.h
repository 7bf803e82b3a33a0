// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/display_state.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// What force is doing, and what it waits for, in words with a kind of kit::notice.
struct ForceWords {
    const char* kind = "info"; ///< info, good, warning, bad
    QString title;
    QString text;
    bool operator==(const ForceWords& other) const { return title == other.title && text == other.text; }
};

/// What somebody has asked for, beside the loop's state.
struct AskedFor {
    bool felt = true;     ///< the device renders force
    bool ownHand = true;  ///< false: a demonstration or a trace is watched
    bool paused = false;
    bool stopped = false;
    bool endoscope = false; ///< the tool is one
    bool grasper = false;   ///< the tools are
};

/// Pure.
ForceWords forceWords(const haptics::DisplayState& state, const AskedFor& asked, const QLocale& locale);

} // namespace chiron::desktop
