// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/posterior_grid.h"

namespace chiron::psychophysics {

/// Posterior mean and standard deviation, credible intervals, draws and the band of the curve, from the posterior's parts; fills mean, error, ci,
/// draws and curve of the result as the options ask for.
void addPosterior(FitResult& result, const std::vector<DensityGrid>& grids, const PreparedLevels& levels, const FitOptions& options);

} // namespace chiron::psychophysics
