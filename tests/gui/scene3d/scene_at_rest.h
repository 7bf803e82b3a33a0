// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_view.h"

#include <QTest>

namespace chiron::tests {

/// Whether a time comes in which nothing is drawn. What follows a call is drawn in its own time, which on a
/// busy machine is long.
inline bool comesToRest(const scene3d::ISceneView& view) {
    constexpr int kLooks = 60, kQuiet_ms = 300;
    for (int i = 0; i < kLooks; ++i) {
        const auto before = view.framesDrawn();
        QTest::qWait(kQuiet_ms);
        QCoreApplication::processEvents(); // timers that ended while the machine did something else
        if (view.framesDrawn() == before)
            return true;
    }
    return false;
}

} // namespace chiron::tests
