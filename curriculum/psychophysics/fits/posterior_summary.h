// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/density_grid.h"

namespace chiron::psychophysics {

/// Fills mean and error of the result with the posterior's mean and standard deviation, computed from its
/// parts.
void addMeans(FitResult& result, const std::vector<DensityGrid>& grids, const PreparedLevels& levels,
              const FitOptions& options);

/// Fills only intervals, draws and the influence of the prior; mean and error keep their values.
void addIntervals(FitResult& result, const std::vector<DensityGrid>& grids, const FitPriors& priors,
                  const PreparedLevels& levels, const FitOptions& options);

/// Returns the share of the posterior whose width (threshold) on the unit axis lies below `width`
/// (`threshold`).
double widthBelow(const std::vector<DensityGrid>& grids, double width);
/// Returns the width on the unit axis below which this share of the posterior lies.
double widthQuantile(const std::vector<DensityGrid>& grids, double share);
double thresholdBelow(const std::vector<DensityGrid>& grids, double threshold);

} // namespace chiron::psychophysics
