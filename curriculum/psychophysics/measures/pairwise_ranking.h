// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// One object was chosen before each of the others in a list, `count` times. A pair: one loser (Bradley–Terry).
struct Selection {
    int winner = 0;
    std::vector<int> losers;
    double count = 1.0;
};

/// The selections of an order given best first, whole or partial (objects left out say nothing).
std::vector<Selection> selectionsOf(const std::vector<int>& bestFirst, double count = 1.0);

struct WorthOptions {
    /// > 0: so many wins of every object over every other are added, which makes any data estimable (and pulls worths together). 0: data whose
    /// graph of wins is not strongly connected are refused, since no finite maximum exists (Ford 1957; Hunter 2004).
    double regularisation = 0.0;
    int mostIterations = 20000;
};

/// Worths γ of objects: P(i chosen from a set) = γ_i / Σ γ.
struct WorthEstimate {
    bool fitted = false;
    std::vector<double> logWorth;      ///< ln γ, their mean 0; not numbers where refused
    std::vector<double> standardError; ///< of the centred ln γ, from the observed information
    double logLikelihood = std::numeric_limits<double>::quiet_NaN(); ///< of the data alone
    int iterations = 0;
    std::vector<std::string> warnings; ///< not_connected, regularised, left_out, no_data, not_converged
};

/// Maximum likelihood of Plackett–Luce (of pairs: Bradley–Terry) by minorisation–maximisation (Hunter 2004, Annals of Statistics 32:384–406),
/// finished by Newton steps. Selections with unknown or repeated objects or no finite count above 0 are left out.
WorthEstimate fitPlackettLuce(int objects, const std::vector<Selection>& selections, const WorthOptions& options = {});

/// Pairs with ties: `wins` of first over second, `losses`, `ties`.
struct PairCount {
    int first = 0;
    int second = 0;
    double wins = 0.0;
    double losses = 0.0;
    double ties = 0.0;
};

enum class TieModel {
    davidson, ///< tie ∝ ν √(γ_i γ_j) (Davidson 1970)
    raoKupper ///< i wins γ_i/(γ_i + θ γ_j), θ ≥ 1 (Rao & Kupper 1967)
};

struct TiedWorthEstimate : WorthEstimate {
    double tie = std::numeric_limits<double>::quiet_NaN(); ///< ν or θ
    double tieStandardError = std::numeric_limits<double>::quiet_NaN(); ///< of ln ν, or of ln(θ − 1)
};

/// Maximum likelihood by Newton's method. Refused where the graph of wins and ties (a tie counts both ways) is not strongly connected, or
/// nothing or everything is tied.
TiedWorthEstimate fitTiedPairs(TieModel model, int objects, const std::vector<PairCount>& pairs);

/// Thurstone's case V from pairs: P(i over j) = Φ(s_i − s_j); unit: sd of one difference (σ√2). Maximum likelihood, mean 0.
WorthEstimate fitThurstonePairs(int objects, const std::vector<Selection>& pairs);
/// The same of orders, each taken apart into its pairs. Those are not independent: no standard errors (bootstrap judges).
WorthEstimate fitThurstoneOrders(int objects, const std::vector<std::vector<int>>& bestFirst);

} // namespace chiron::psychophysics
