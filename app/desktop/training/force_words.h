// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/display_state.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// The state of the force and what it is waiting for, as text for a notice; `kind` as in kit::notice.
struct ForceWords {
    const char* kind = "info"; ///< info, good, warning, bad
    QString title;
    QString text;
    bool operator==(const ForceWords& other) const { return title == other.title && text == other.text; }
};

/// The person's requests and the circumstances, in addition to the loop's state.
struct AskedFor {
    bool felt = true;    ///< the device renders force
    bool ownHand = true; ///< false: a demonstration or a trace is being watched
    bool paused = false;
    bool stopped = false;
    bool endoscope = false; ///< the tool is an endoscope
    bool grasper = false;   ///< the tools are graspers
};

/// Describes the state of the force. Pure.
ForceWords forceWords(const haptics::DisplayState& state, const AskedFor& asked, const QLocale& locale);

} // namespace chiron::desktop
