// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/gauge_painter.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"

namespace chiron::scene3d {

/// The force bar, with the target band if the level shows it. Pure function.
inline GaugeDial forceDial(const SceneSetup& setup, const simulation::PalpationCues& cues) {
    GaugeDial dial = forceDial(setup);
    if (cues.present && cues.bandShown) {
        dial.bandLow_N = cues.bandLow_N;
        dial.bandHigh_N = cues.bandHigh_N;
    }
    return dial;
}

} // namespace chiron::scene3d
