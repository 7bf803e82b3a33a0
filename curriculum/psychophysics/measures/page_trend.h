// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// Result of Page's test of whether judges rank objects in the expected order (Page 1963): L = Σ j R_j.
struct PageTrend {
    double l = std::numeric_limits<double>::quiet_NaN();
    double expected = std::numeric_limits<double>::quiet_NaN(); ///< m k (k+1)²/4
    double z = std::numeric_limits<double>::quiet_NaN();
    /// P(L at least this large); not a number for more than 7 objects or very many judges.
    double exactP = std::numeric_limits<double>::quiet_NaN();
    double normalP = std::numeric_limits<double>::quiet_NaN(); ///< one-sided, with the variance for ties
    double pValue = std::numeric_limits<double>::quiet_NaN();  ///< exact if available, else normal
    int judges = 0;
    int objects = 0;
    std::vector<std::string> warnings;
};

/// Computes Page's test. Rows are judges, columns objects in the expected ascending order; values are ranked
/// within a row (ties: mid-ranks). Rows with a missing value or of another length than the first are left
/// out.
PageTrend pageTrend(const std::vector<std::vector<double>>& judges);

/// Returns P(L ≥ l), exact, for judges who rank at random and without ties. Not a number for fewer than 2 or
/// more than 7 objects, or for very many judges.
double pageUpperTail(int objects, int judges, double l);

} // namespace chiron::psychophysics
