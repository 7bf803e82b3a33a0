// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit_types.h"

#include <string>
#include <vector>

namespace chiron::psychophysics {

/// Data ready for fitting: usable rows, equal x put together, ascending, on an axis of its own (`unit`), so that neither an offset of x
/// nor its units change what a fit does.
struct PreparedLevels {
    std::vector<double> given; ///< x in given units
    std::vector<double> axis;  ///< on the fitted axis; the first one may be minus infinity (0 on a logarithmic axis)
    std::vector<double> unit;  ///< (axis − centre)/range
    std::vector<double> right;
    std::vector<double> of;
    double centre = 0.0;       ///< of the finite levels, fitted axis
    double range = 0.0;        ///< largest − smallest finite level, fitted axis; 0: a fit is impossible
    double spacing = 0.0;      ///< smallest distance of neighbours, fitted axis
    double totalRight = 0.0;
    double total = 0.0;
    double logCoefficients = 0.0; ///< Σ ln(n choose k) over the rows as given
    std::vector<std::string> warnings;

    std::size_t size() const noexcept { return axis.size(); }
    bool usable() const noexcept { return range > 0.0; }
};

/// A finite place, whole numbers of answers, not more right than given. The others are left out, with a warning.
bool isUsableRow(double x, double right, double of) noexcept;

/// More places than this are put together, since the time of a fit grows with them.
inline constexpr std::size_t kMostFittedLevels = 256;

/// Rows closer than 1e-9 of the range (or a few units in the last place) are one level. More than
/// kMostFittedLevels places become bins of about equal numbers of answers, at their mean on the axis. Warnings: unusable_rows, off_scale,
/// binned, no_data, one_level.
PreparedLevels prepareLevels(const PsychometricData& data, StimulusScale scale);

/// ln(n!) of a whole number, from a table up to 255 and by Stirling's series beyond. Relative error below 1e-15.
double logFactorial(double n) noexcept;

} // namespace chiron::psychophysics
