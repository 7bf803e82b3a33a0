// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QSize>

namespace chiron::scene3d {

/// Where the pictures of an endoscopic scene lie in the window, in device pixels from its upper left corner.
struct EndoscopeLayout {
    QRect picture;  ///< square; the round picture fills it
    QRect overview; ///< empty where the level has none

    /// `bar_px`: width at the right edge that the force bar takes. Wide windows have the overview beside the picture, high
    /// ones below it; the round picture gets what is left, and at least half of the shorter side. Pure.
    static EndoscopeLayout of(const QSize& window_px, int bar_px, bool overview);
};

} // namespace chiron::scene3d
