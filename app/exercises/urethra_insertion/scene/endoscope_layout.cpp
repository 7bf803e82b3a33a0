// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/endoscope_layout.h"

#include <algorithm>

namespace chiron::scene3d {

namespace {
constexpr double kOverviewShare = 0.30; // smallest fraction of the longer side
constexpr double kMostShare = 0.48;     // largest fraction
constexpr double kTallest = 1.5;        // height to width; a taller overview would be empty
} // namespace

EndoscopeLayout EndoscopeLayout::of(const QSize& window_px, int bar_px, bool overview) {
    const int wide = std::max(2, window_px.width() - bar_px);
    const int high = std::max(2, window_px.height());
    const bool beside = wide >= high;
    EndoscopeLayout layout;
    QRect room(0, 0, wide, high);
    if (overview) {
        const int longer = beside ? wide : high;
        const int left = longer - (beside ? high : wide); // the space beside the largest round picture
        const int taken = std::clamp(left, int(kOverviewShare * longer), int(kMostShare * longer));
        if (beside) {
            const int tall = std::min(high, int(kTallest * taken));
            layout.overview = QRect(wide - taken, (high - tall) / 2, taken, tall);
            room.setWidth(wide - taken);
        } else {
            layout.overview = QRect(0, high - taken, wide, taken);
            room.setHeight(high - taken);
        }
    }
    const int side = std::min(room.width(), room.height()) & ~1;
    layout.picture =
        QRect(room.x() + (room.width() - side) / 2, room.y() + (room.height() - side) / 2, side, side);
    return layout;
}

} // namespace chiron::scene3d
