// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// A stimulus in a procedure's own units, one number a dimension (log10 of a difference, dB, ...).
using Stimulus = std::vector<double>;

/// What a procedure wants presented next.
struct Choice {
    Stimulus stimulus;
    int candidate = -1; ///< row of the procedure's grid of stimuli, where it has one
    /// By how much the second best stimulus was worse (expected entropy, nats); not a number where the procedure weighs none.
    /// Below 1e-9 it was a tie, broken at the lowest index.
    double entropyMargin = std::numeric_limits<double>::quiet_NaN();
};

struct NamedEstimate {
    std::string name; ///< "threshold", "log10_sigma", "slope", "lapse", ...
    double mean = 0.0;
    double sd = 0.0;      ///< 0 where the procedure has none
    double low = 0.0;     ///< of the central 95 % interval; NaN where there is none
    double high = 0.0;
    double mode = std::numeric_limits<double>::quiet_NaN(); ///< of the joint posterior, where there is one
    int edge = 0; ///< −1, +1: the posterior is cut off by the lower, upper end of its grid (density there at least 0.147 of the largest)
};

/// What a procedure makes of its trials so far.
struct ProcedureEstimate {
    bool known = false;                    ///< false before there is anything to estimate from
    std::vector<NamedEstimate> parameters; ///< the threshold (or log10_sigma) first
    std::string method;                    ///< "mean of the last 6 reversals", "posterior mean", ...
    std::vector<std::string> warnings;     ///< "token: words": grid_edge, slope_assumed
};

/// Density at an end of a grid, as a share of the largest, from which on the answers do not tell where beyond it the value lies: what the 95 %
/// likelihood region of one parameter begins with, exp(−3.84/2).
inline constexpr double kAtGridEdge = 0.147;

/// Adds grid_edge for those of the first `most` parameters that lie at the end of their grid.
void warnOfGridEdges(ProcedureEstimate& estimate, std::size_t most);

/// One adaptive (or fixed) procedure: chooses a stimulus, takes an outcome, and again. Deterministic: the same specification, seed and
/// outcomes give the same choices. Sums over parameters run in a fixed blocked order. Not for the haptic thread. Any one thread.
/// Outcomes: 0..outcomes()-1; of two outcomes 0 is wrong (no) and 1 is right (yes).
class Procedure {
public:
    Procedure() = default;
    Procedure(const Procedure&) = delete;
    Procedure& operator=(const Procedure&) = delete;
    virtual ~Procedure() = default;

    /// Kind and version, "quest_plus@1": a new version is a new id and never continues an old run.
    virtual std::string_view id() const noexcept = 0;
    virtual int outcomes() const noexcept { return 2; }
    /// The same until something is recorded, taken back or spoiled. Undefined once done().
    virtual Choice next() const = 0;
    /// The outcome of a stimulus, which need not be the one that was asked for (as actually presented). Failure: badInput naming what
    /// was expected; nothing is changed.
    virtual core::Result<void> record(int outcome, const Stimulus& presented) = 0;
    /// Takes the last recorded outcome back. Failure: wrongUse where there is none.
    virtual core::Result<void> undo() = 0;
    /// The trial just presented does not count and is presented again (adaptive procedures: at once; fixed lists: at a random later place).
    virtual void spoiled() = 0;
    virtual bool done() const noexcept = 0;
    virtual int trials() const noexcept = 0; ///< recorded and not taken back
    virtual int reversals() const noexcept { return 0; }
    virtual ProcedureEstimate estimate() const = 0;
};

} // namespace chiron::psychophysics
