// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "simulation/palpation/map_bands.h"
#include "simulation/palpation/surface_map.h"

#include <QColor>
#include <QImage>

namespace chiron::scene3d {

/// The boundaries between the steps of the level's map.
simulation::MapBands mapBandsOf(const SceneSetup& setup);

/// The colour of a step over the tissue, with its opacity: one hue from the background to the theme's accent.
QColor mapColour(const SceneColours& colours, simulation::SurfaceMapKind kind, simulation::MapBand band);

/// The colour of the hatching: unsearched areas are hatched, and areas that were pressed too hard are hatched
/// in the other direction.
QColor mapHatch(const SceneColours& colours, bool over);

inline constexpr int kMapPixels = 4; ///< pixels per cell in each direction

/// The map as a translucent picture over the search area, x to the right, y up: steps, hatching, an outline
/// of the searched area, and the regions as faint lines. The alpha is not premultiplied. Pure function; takes
/// about 0.2 ms.
QImage mapPicture(const simulation::SurfaceMap& map, const SceneSetup& setup,
                  simulation::SurfaceMapKind kind);

} // namespace chiron::scene3d
