// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// Returns mid-ranks, from 1: equal values share the mean of their ranks.
std::vector<double> midRanks(const std::vector<double>& values);

/// Agreement of several judges on an order of objects.
struct Concordance {
    double w = std::numeric_limits<double>::quiet_NaN();
    double chiSquare = std::numeric_limits<double>::quiet_NaN(); ///< m(k−1)W, k−1 degrees of freedom
    double pValue = std::numeric_limits<double>::quiet_NaN();    ///< of chi-square
    /// From all permutations of each judge's ranks; not a number for large designs.
    double exactP = std::numeric_limits<double>::quiet_NaN();
    int judges = 0;
    int objects = 0;
    std::vector<std::string> warnings;
};

/// Returns Kendall's W with ties (Kendall & Babington Smith 1939; Siegel & Castellan 1988): W = 12S/(m²(k³−k)
/// − mΣ(t³−t)). Rows are judges, columns objects; values are ranked within a row. Rows with a missing or
/// infinite value, or of another length than the first, are left out.
Concordance kendallW(const std::vector<std::vector<double>>& judges);

struct RankCorrelation {
    double tau = std::numeric_limits<double>::quiet_NaN();    ///< τ-b: equals τ-a without ties
    double pValue = std::numeric_limits<double>::quiet_NaN(); ///< two-sided
    bool exact = false; ///< from all permutations; else normal with the variance for ties (Kendall 1970)
    int pairs = 0;      ///< number of pairs of values used
    std::vector<std::string> warnings;
};

/// Returns Kendall's τ-b of pairs of values; pairs with a missing or infinite value are left out. p is exact
/// up to 100 pairs without ties and up to 8 pairs with ties.
RankCorrelation kendallTau(const std::vector<double>& x, const std::vector<double>& y);

/// How often orders of three objects were entirely correct, compared with the 1/6 expected from guessing.
struct CompleteOrders {
    int right = 0;
    int of = 0;
    double share = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN(); ///< 95 % Clopper–Pearson
    double high = std::numeric_limits<double>::quiet_NaN();
    double pValue = std::numeric_limits<double>::quiet_NaN(); ///< exact, one-sided: this many or more by
                                                              ///< guessing
};
CompleteOrders completeOrders(int right, int of);

} // namespace chiron::psychophysics
