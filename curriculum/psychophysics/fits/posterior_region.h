// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/density_grid.h"

namespace chiron::psychophysics {

/// Divides the posterior into parts by overdispersion and, where widths may span a large range, by width. The
/// bounds of overdispersion double from the one at which it equals the scatter of chance, because the less
/// overdispersion there is, the narrower is everything else (a funnel). Each part has axes of its own, found
/// by passes of a coarse grid that start from the part with more overdispersion, with more nodes where there
/// is more mass. Parts that hold less than 1e-4 of the mass are left out. The result is never empty. `fine`
/// is the size of a part.
std::vector<DensityGrid> posteriorParts(const PosteriorModel& model, const GridSize& fine);

} // namespace chiron::psychophysics
