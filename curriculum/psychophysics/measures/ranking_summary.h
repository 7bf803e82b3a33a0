// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/agreement.h"
#include "psychophysics/measures/page_trend.h"
#include "psychophysics/measures/pairwise_ranking.h"
#include "psychophysics/study/run_estimate.h"

#include <vector>

namespace chiron::psychophysics {

/// One ranking of three: the rank (1 least .. 3 most; tied objects their mean) that was said of each object in its true order (reference, D more, 2D more).
using SaidRanks = std::vector<double>;

/// What rankings of three objects say together, of one participant (a row is a trial) or of a group (a row is a participant's mean ranks).
/// The differences of the trials are pooled: worths are of the objects as presented, and say as much of them as of who ranked.
struct RankingSummary {
    int rankings = 0; ///< trials used
    int tied = 0;     ///< of these, with objects called equal
    int judges = 0;   ///< rows of W and L: trials of a participant, participants of a group
    CompleteOrders complete;
    Concordance agreement; ///< Kendall's W
    double wLow = std::numeric_limits<double>::quiet_NaN(); ///< 95 % of W: participants drawn with replacement (BCa), from three on; of one person none
    double wHigh = std::numeric_limits<double>::quiet_NaN();
    bool adaptive = false; ///< of one person whose answers decided what came next: no intervals and p, as trials are not independent
    PageTrend trend;       ///< Page's L, towards the true order
    double tau = std::numeric_limits<double>::quiet_NaN(); ///< mean Kendall's τ_a with the true order (a tied pair counts nothing); of a group the mean of its participants' means
    double tauLow = std::numeric_limits<double>::quiet_NaN(); ///< 95 %, Student's t over trials (participants), within -1..1
    double tauHigh = std::numeric_limits<double>::quiet_NaN();
    WorthEstimate bradleyTerry; ///< each ranking taken apart into its three pairs; with ties Davidson's model
    double davidsonTie = std::numeric_limits<double>::quiet_NaN(); ///< its ν; none without ties
    WorthEstimate plackettLuce; ///< most chosen first; a ranking with ties is shared out among the orders that agree with it
    WorthEstimate thurstone;    ///< case V, no standard errors; a tie is half of each order
};

/// The rankings among a run's counted trials; what is none (no answer) is left out. Of tasks rank3 and rank3_ties.
std::vector<SaidRanks> saidRanks(const std::vector<ScoredTrial>& trials);

/// `adaptive`: each trial's difference was chosen by the answers before. Then trials are not independent draws, and there is neither an interval nor a p.
RankingSummary summariseRankings(const std::vector<SaidRanks>& rankings, bool adaptive = false);
/// One element a participant; those without a ranking are left out. Participants are what is drawn anew: the intervals of W and of the share of whole
/// orders, and its p (t), are over them, whatever their trials were chosen by; below three participants there are none. Worths are fitted to all rankings as if each were anybody's.
RankingSummary summariseGroupRankings(const std::vector<std::vector<SaidRanks>>& participants);

} // namespace chiron::psychophysics
