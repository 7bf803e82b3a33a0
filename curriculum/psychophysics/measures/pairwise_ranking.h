// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// One object was preferred to all the others in a list, `count` times. With a single loser this is a pair
/// (Bradley–Terry).
struct Selection {
    int winner = 0;
    std::vector<int> losers;
    double count = 1.0;
};

/// Returns the selections of an order given best first, complete or partial (objects that are left out carry
/// no information).
std::vector<Selection> selectionsOf(const std::vector<int>& bestFirst, double count = 1.0);

struct WorthOptions {
    /// > 0: this many wins of every object over every other are added, which makes any data estimable but
    /// pulls the worths together. 0: data whose graph of wins is not strongly connected are refused, because
    /// no finite maximum exists (Ford 1957; Hunter 2004).
    double regularisation = 0.0;
    int mostIterations = 20000;
};

/// Estimated worths γ of objects: P(i chosen from a set) = γ_i / Σ γ.
struct WorthEstimate {
    bool fitted = false;
    std::vector<double> logWorth;      ///< ln γ, with mean 0; not numbers if the data were refused
    std::vector<double> standardError; ///< of the centred ln γ, from the observed information
    double logLikelihood = std::numeric_limits<double>::quiet_NaN(); ///< of the data alone
    int iterations = 0;
    std::vector<std::string> warnings; ///< not_connected, regularised, left_out, no_data, not_converged
};

/// Fits Plackett–Luce (for pairs: Bradley–Terry) by maximum likelihood, with minorisation–maximisation
/// (Hunter 2004, Annals of Statistics 32:384–406) finished by Newton steps. Selections with unknown or
/// repeated objects, or without a finite count above 0, are left out.
WorthEstimate fitPlackettLuce(int objects, const std::vector<Selection>& selections,
                              const WorthOptions& options = {});

/// Counts of a pair with ties: `wins` of first over second, `losses` and `ties`.
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
    double tie = std::numeric_limits<double>::quiet_NaN();              ///< ν or θ
    double tieStandardError = std::numeric_limits<double>::quiet_NaN(); ///< of ln ν, or of ln(θ − 1)
};

/// Fits by maximum likelihood with Newton's method. Data are refused if the graph of wins and ties (a tie
/// counts in both directions) is not strongly connected, or if nothing or everything is tied.
TiedWorthEstimate fitTiedPairs(TieModel model, int objects, const std::vector<PairCount>& pairs);

/// Fits Thurstone's case V to pairs: P(i over j) = Φ(s_i − s_j); the unit is the sd of one difference (σ√2).
/// Maximum likelihood, mean 0.
WorthEstimate fitThurstonePairs(int objects, const std::vector<Selection>& pairs);
/// The same for orders, each decomposed into its pairs. These are not independent, so there are no standard
/// errors (use a bootstrap over judges).
WorthEstimate fitThurstoneOrders(int objects, const std::vector<std::vector<int>>& bestFirst);

} // namespace chiron::psychophysics
