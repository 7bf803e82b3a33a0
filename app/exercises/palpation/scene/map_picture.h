// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "desktop/scene3d/scene_setup.h"
#include "simulation/palpation/map_bands.h"
#include "simulation/palpation/surface_map.h"

#include <QColor>
#include <QImage>

namespace chiron::scene3d {

/// The level's edges of a map's steps.
simulation::MapBands mapBandsOf(const SceneSetup& setup);

/// A step's colour over tissue, with its opacity: one hue from the background to the theme's accent.
QColor mapColour(const SceneColours& colours, simulation::SurfaceMapKind kind, simulation::MapBand band);

/// What was not searched is hatched (this line's colour), what was pressed too hard hatched the other way.
QColor mapHatch(const SceneColours& colours, bool over);

inline constexpr int kMapPixels = 4; ///< a cell, each way

/// The map as a translucent picture over the search area, x to the right, y up: steps, hatching, a line round what was searched,
/// and faintly the regions. Not premultiplied. Pure; about 0.2 ms.
QImage mapPicture(const simulation::SurfaceMap& map, const SceneSetup& setup, simulation::SurfaceMapKind kind);

} // namespace chiron::scene3d
