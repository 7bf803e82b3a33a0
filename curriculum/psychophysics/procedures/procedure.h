// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// A stimulus in a procedure's own units, one number per dimension (log10 of a difference, dB, ...).
using Stimulus = std::vector<double>;

/// The stimulus that a procedure wants to be presented next.
struct Choice {
    Stimulus stimulus;
    int candidate = -1; ///< row of the procedure's grid of stimuli, if it has one
    /// How much worse the second best stimulus was (expected entropy, nats); not a number if the procedure
    /// does not compare stimuli. Below 1e-9 it was a tie, decided in favour of the lowest index.
    double entropyMargin = std::numeric_limits<double>::quiet_NaN();
};

struct NamedEstimate {
    std::string name; ///< "threshold", "log10_sigma", "slope", "lapse", ...
    double mean = 0.0;
    double sd = 0.0;  ///< 0 if the procedure has none
    double low = 0.0; ///< of the central 95 % interval; NaN if there is none
    double high = 0.0;
    double mode = std::numeric_limits<double>::quiet_NaN(); ///< of the joint posterior, if there is one
    /// The lower or the upper end of the grid cuts off the posterior (its density there is at least
    /// kAtGridEdge of the largest).
    bool cutBelow = false, cutAbove = false;
};

/// A procedure's estimate from its trials so far.
struct ProcedureEstimate {
    bool known = false;                    ///< false while there is nothing to estimate from
    std::vector<NamedEstimate> parameters; ///< the threshold (or log10_sigma) first
    std::string method;                    ///< "mean of the last 6 reversals", "posterior mean", ...
    std::vector<std::string> warnings;     ///< "token: words": grid_edge, slope_assumed
};

/// Relative density at an end of a grid from which on the answers do not determine how far beyond it the
/// value lies: the bound of the 95 % likelihood region of one parameter, exp(−3.84/2).
inline constexpr double kAtGridEdge = 0.147;

/// Adds grid_edge for those of the first `most` parameters whose posterior an end of their grid, or both, cut
/// off.
void warnOfGridEdges(ProcedureEstimate& estimate, std::size_t most);

/// One adaptive (or fixed) procedure, which alternately chooses a stimulus and takes an outcome.
/// Deterministic: the same specification, seed and outcomes give the same choices, and sums over parameters
/// run in a fixed blocked order. Outcomes are 0..outcomes()-1; of two outcomes, 0 is wrong (no) and 1 is
/// right (yes).
/// Thread: any single one, but not the haptic thread.
class Procedure {
public:
    Procedure() = default;
    Procedure(const Procedure&) = delete;
    Procedure& operator=(const Procedure&) = delete;
    virtual ~Procedure() = default;

    /// Kind and version, "quest_plus@1". A new version is a new id and never continues an old run.
    virtual std::string_view id() const noexcept = 0;
    virtual int outcomes() const noexcept { return 2; }
    /// Returns the next choice. It stays the same until a trial is recorded, taken back or spoiled. Undefined
    /// once done().
    virtual Choice next() const = 0;
    /// Records the outcome of a stimulus as actually presented, which need not be the one that was asked for.
    /// Errors: badInput naming what was expected; nothing is changed.
    virtual core::Result<void> record(int outcome, const Stimulus& presented) = 0;
    /// Takes the last recorded outcome back.
    /// Errors: wrongUse if there is none.
    virtual core::Result<void> undo() = 0;
    /// Says that the trial just presented does not count. It is presented again (adaptive procedures: at
    /// once; fixed lists: at a random later position).
    virtual void spoiled() = 0;
    virtual bool done() const noexcept = 0;
    virtual int trials() const noexcept = 0; ///< recorded and not taken back
    virtual int reversals() const noexcept { return 0; }
    virtual ProcedureEstimate estimate() const = 0;
};

} // namespace chiron::psychophysics
