// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"

namespace chiron::scene3d {

/// The camera of the overview: beside the patient, so that the way in runs from left to right and up.
struct OverviewFit {
    core::Vec3 p_WEye = core::Vec3::Zero();    ///< m
    core::Vec3 p_WTarget = core::Vec3::Zero(); ///< m
    core::Vec3 up_W = core::Vec3::UnitZ();
    double fieldOfView_deg = 24.0; ///< vertical
};

/// The nearest such camera position from which canal, bladder and the last part of the shaft outside are
/// visible. `aspect` = width/height > 0. Pure function.
OverviewFit fitOverview(const UrethraDrawing& drawing, double aspect);

} // namespace chiron::scene3d
