// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/agreement.h"
#include "psychophysics/measures/page_trend.h"
#include "psychophysics/measures/pairwise_ranking.h"
#include "psychophysics/study/run_estimate.h"

#include <vector>

namespace chiron::psychophysics {

/// One ranking of three objects: the rank (1 least .. 3 most; tied objects share their mean rank) given to
/// each object, in the objects' true order (reference, D more, 2D more).
using SaidRanks = std::vector<double>;

/// Summary of rankings of three objects, either of one participant (a row is a trial) or of a group (a row is
/// a participant's mean ranks). The differences D of the trials are pooled: the worths belong to the objects
/// as presented, and depend on these as much as on the person who ranked.
struct RankingSummary {
    int rankings = 0; ///< trials used
    int tied = 0;     ///< of these, trials with objects called equal
    int judges = 0;   ///< rows of W and L: trials of a participant, or participants of a group
    CompleteOrders complete;
    Concordance agreement; ///< Kendall's W
    /// 95 % interval of W for a group of at least three: participants are drawn with replacement (BCa). None
    /// for one person.
    double wLow = std::numeric_limits<double>::quiet_NaN();
    double wHigh = std::numeric_limits<double>::quiet_NaN();
    /// For one person whose answers decided the next trial: no intervals and no p, because the trials are not
    /// independent.
    bool adaptive = false;
    PageTrend trend; ///< Page's L, towards the true order
    /// Mean of Kendall's τ_a with the true order (a tied pair counts 0); for a group, the mean of its
    /// participants' means.
    double tau = std::numeric_limits<double>::quiet_NaN();
    /// 95 % interval by Student's t over trials (for a group: over participants), within -1..1.
    double tauLow = std::numeric_limits<double>::quiet_NaN();
    double tauHigh = std::numeric_limits<double>::quiet_NaN();
    WorthEstimate bradleyTerry; ///< each ranking decomposed into its three pairs; with ties, Davidson's model
    double davidsonTie = std::numeric_limits<double>::quiet_NaN(); ///< ν of that model; none without ties
    /// The object with most is chosen first; a ranking with ties is divided among the orders that agree with
    /// it.
    WorthEstimate plackettLuce;
    WorthEstimate thurstone; ///< case V, without standard errors; a tie counts half for each order
};

/// Returns the rankings among a run's scored trials, for the tasks rank3 and rank3_ties. Trials without an
/// answer are left out.
std::vector<SaidRanks> saidRanks(const std::vector<ScoredTrial>& trials);

/// Summarises the rankings of one participant. `adaptive`: the earlier answers chose each trial's difference.
/// Trials are then not independent draws, and there is neither an interval nor a p.
RankingSummary summariseRankings(const std::vector<SaidRanks>& rankings, bool adaptive = false);
/// Summarises the rankings of a group, with one element per participant; participants without a ranking are
/// left out. The bootstrap draws participants: the intervals of W and of the share of complete orders, and
/// the p of the latter (t test), are over participants, however their trials were chosen. With fewer than
/// three participants there are none. Worths are fitted to all rankings without regard to who gave them.
RankingSummary summariseGroupRankings(const std::vector<std::vector<SaidRanks>>& participants);

} // namespace chiron::psychophysics
