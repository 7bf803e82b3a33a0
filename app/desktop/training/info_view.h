// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "haptics/display_state.h"
#include "session/level_cues.h"
#include "session/live_sample.h"

#include <QFrame>
#include <QLocale>
#include <span>

namespace chiron::desktop {

/// What is measured right now, as far as the level allows it: one class a kind of exercise. GUI thread.
class InfoView : public QFrame {
public:
    using QFrame::QFrame;
    /// Each frame: the newest state and every sample since the frame before.
    virtual void show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) = 0;
};

} // namespace chiron::desktop
