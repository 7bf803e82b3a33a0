// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/posterior_grid.h"

namespace chiron::psychophysics {

/// Posterior mean and standard deviation, from the posterior's parts; fills mean and error of the result.
void addMeans(FitResult& result, const std::vector<DensityGrid>& grids, const PreparedLevels& levels, const FitOptions& options);

/// Intervals, draws and how much the prior decided alone: mean and error stay.
void addIntervals(FitResult& result, const std::vector<DensityGrid>& grids, const FitPriors& priors, const PreparedLevels& levels, const FitOptions& options);

/// Share of the posterior whose width (threshold), on the unit axis, lies below so much.
double widthBelow(const std::vector<DensityGrid>& grids, double width);
/// The width, on the unit axis, below which so much of the posterior lies.
double widthQuantile(const std::vector<DensityGrid>& grids, double share);
double thresholdBelow(const std::vector<DensityGrid>& grids, double threshold);

} // namespace chiron::psychophysics
