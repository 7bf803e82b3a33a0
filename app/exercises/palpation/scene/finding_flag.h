// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"

#include <QRectF>

class QPainter;

namespace chiron::scene3d {

/// The head of the pin at a finding: its number on a square flag. A hit has a double ring, a false alarm a
/// diamond. The selected one has a black-and-white frame of corner marks.
struct FindingFlag {
    int number = 1; ///< as displayed
    simulation::FindingOutcome outcome = simulation::FindingOutcome::open;
    bool selected = false;

    bool operator==(const FindingFlag&) const = default;
};

/// Paints into `box` (square) only as far as the flag needs; the surrounding pixels are unchanged.
void paintFindingFlag(QPainter& painter, const QRectF& box, const FindingFlag& flag, const SceneSetup& setup);

} // namespace chiron::scene3d
