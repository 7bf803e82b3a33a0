// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "desktop/scene3d/scene_setup.h"

#include <QRectF>

class QPainter;

namespace chiron::scene3d {

/// The head of the pin that stands on a finding: its number on a square flag; a hit is a double ring, a false alarm a diamond. The
/// selected one has a black-and-white frame of corners round it.
struct FindingFlag {
    int number = 1; ///< as people see it
    simulation::FindingOutcome outcome = simulation::FindingOutcome::open;
    bool selected = false;

    bool operator==(const FindingFlag&) const = default;
};

/// Fills `box` (square) as far as it needs; what is round it stays as it is.
void paintFindingFlag(QPainter& painter, const QRectF& box, const FindingFlag& flag, const SceneSetup& setup);

} // namespace chiron::scene3d
