// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/density_grid.h"

namespace chiron::psychophysics {

/// Returns starting points for the search of the mode: the most likely ones, far from each other, among the
/// best cells of a grid over the whole space and among curves at and between the levels (a posterior may be
/// narrower than the grid's step), with and without lapses, guesses and overdispersion.
std::vector<CurveParameters> modeStarts(const PosteriorModel& model, const DensityGrid& whole);

/// Returns the mode. Simplex climbs (Nelder & Mead 1965) start from all starting points, and longer ones from
/// the best. They search over threshold, ln width and the square roots of the shares, so that a mode at a
/// share of 0 is an interior one.
CurveParameters posteriorMode(const PosteriorModel& model, const std::vector<CurveParameters>& starts);

} // namespace chiron::psychophysics
