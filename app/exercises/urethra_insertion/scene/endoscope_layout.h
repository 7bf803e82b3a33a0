// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QSize>

namespace chiron::scene3d {

/// The positions of the pictures of an endoscopic scene in the window, in device pixels from its upper left
/// corner.
struct EndoscopeLayout {
    QRect picture;  ///< square; the round picture fills it
    QRect overview; ///< empty if the level has none

    /// `bar_px`: width of the force bar at the right edge. Wide windows have the overview beside the picture,
    /// high ones below it. The round picture gets the remaining space, and at least half of the shorter side.
    /// Pure function.
    static EndoscopeLayout of(const QSize& window_px, int bar_px, bool overview);
};

} // namespace chiron::scene3d
