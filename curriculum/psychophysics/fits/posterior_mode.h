// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/posterior_grid.h"

namespace chiron::psychophysics {

/// Where the mode may lie: the likeliest places, each far from the others, among the best cells of a grid over the whole space and curves
/// at and between the levels (a posterior may be narrower than the grid's step), with and without lapses, guesses and overdispersion.
std::vector<CurveParameters> modeStarts(const PosteriorModel& model, const DensityGrid& whole);

/// The mode: simplex climbs (Nelder & Mead 1965) from all starts, longer ones from the best, over threshold, ln width and the roots of the
/// shares, so that a mode at a share of 0 is an inner one.
CurveParameters posteriorMode(const PosteriorModel& model, const std::vector<CurveParameters>& starts);

} // namespace chiron::psychophysics
