// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_types.h"

#include <string>
#include <vector>

namespace chiron::psychophysics {

/// Data ready for fitting: usable rows, with equal x merged, in ascending order, on a normalised axis
/// (`unit`), so that neither an offset of x nor its units change the fit.
struct PreparedLevels {
    std::vector<double> given; ///< x in given units
    std::vector<double> axis;  ///< on the fitted axis; the first one may be minus infinity (x = 0 on a
                               ///< logarithmic axis)
    std::vector<double> unit;  ///< (axis − centre)/range
    std::vector<double> right;
    std::vector<double> of;
    double centre = 0.0;  ///< of the finite levels, fitted axis
    double range = 0.0;   ///< largest − smallest finite level, fitted axis; 0: no fit is possible
    double spacing = 0.0; ///< smallest distance between neighbours, fitted axis
    double totalRight = 0.0;
    double total = 0.0;
    double logCoefficients = 0.0; ///< Σ ln(n choose k) over the rows as given
    std::vector<std::string> warnings;

    std::size_t size() const noexcept { return axis.size(); }
    bool usable() const noexcept { return range > 0.0; }
};

/// Returns whether a row is usable: a finite position, whole numbers of answers, and no more right answers
/// than answers. The others are left out, with a warning.
bool isUsableRow(double x, double right, double of) noexcept;

/// If there are more positions than this they are merged, because the time of a fit grows with their number.
inline constexpr std::size_t kMostFittedLevels = 256;

/// Prepares the data. Rows closer than 1e-9 of the range (or a few units in the last place) become one level.
/// More than kMostFittedLevels positions become bins with about equal numbers of answers, at the mean of
/// their positions on the axis. Warnings: unusable_rows, off_scale, binned, no_data, one_level.
PreparedLevels prepareLevels(const PsychometricData& data, StimulusScale scale);

/// Returns ln(n!) of a whole number, from a table up to 255 and by Stirling's series beyond. Relative error
/// below 1e-15.
double logFactorial(double n) noexcept;

} // namespace chiron::psychophysics
