// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/posterior_grid.h"

namespace chiron::psychophysics {

/// The posterior in parts by overdispersion, in steps of two beyond what chance itself scatters: the less there is, the narrower is everything else
/// (a funnel); and by width, where widths may span much. Each has axes of its own, found by passes of a coarse grid from the part of more
/// overdispersion, with more nodes where there is more mass. Parts that hold less than 1e-4 are left out; never empty. `fine` is the size of a part.
std::vector<DensityGrid> posteriorParts(const PosteriorModel& model, const GridSize& fine);

} // namespace chiron::psychophysics
