// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/posterior_grid.h"
#include "psychophysics/procedures/psychometric_functions.h"

#include <memory>
#include <span>
#include <vector>

namespace chiron::psychophysics {

/// The stimulus that leaves the least entropy to be expected.
struct BestStimulus {
    int index = -1;      ///< the lowest of those within kEntropyTie of the least
    double gain = 0.0;   ///< the least: expected entropy after it, less the entropy now (nats, at most 0)
    double margin = std::numeric_limits<double>::quiet_NaN(); ///< the second least less the least
};
using Rows = std::span<const int>; ///< of the grid of stimuli, ascending
inline constexpr double kEntropyTie = 1e-9;

/// p(outcome | stimulus, cell), and what QUEST+ makes of it. Because outcomes sum to one (Watson 2017, eq. 5, rearranged),
/// EH(x) = H(p) + Σ_r P_r ln P_r - (M p)(x), P_r = L_r p, M = Σ_r L_r ln L_r, which is set up once: no logarithm a cell at a trial.
/// Immutable; may be shared by any number of procedures and threads.
class OutcomeTables {
public:
    OutcomeTables() = default;
    OutcomeTables(const OutcomeTables&) = delete;
    OutcomeTables& operator=(const OutcomeTables&) = delete;
    virtual ~OutcomeTables() = default;

    virtual int outcomes() const noexcept = 0;
    virtual std::size_t stimuli() const noexcept = 0;
    /// Σ_r P_r ln P_r - (M p)(x) of every stimulus.
    virtual std::vector<double> gains(const PosteriorGrid& posterior) const = 0;
    /// The best one but those left out.
    virtual BestStimulus best(const PosteriorGrid& posterior, const Rows& excluded) const;
    /// One number a cell, padded with zeros.
    virtual void likelihood(std::size_t stimulus, int outcome, std::vector<double>& to) const = 0;

protected:
    /// The same of the entropy of the parameters that are no nuisance (Prins 2013); logarithms at each trial.
    std::vector<double> marginalGains(const PosteriorGrid& posterior) const;
};

/// Least, lowest of ties, margin.
BestStimulus bestOf(std::vector<double> gains, const Rows& excluded);

/// Two outcomes of a psychometric function over a grid whose parameters are the function's, in its order.
/// Failure: badInput (asymptotes outside 0..1, a function that is not a number somewhere).
core::Result<std::shared_ptr<const OutcomeTables>> psychometricTables(const PsychometricFunction& function,
                                                                      const std::vector<Stimulus>& stimuli, const PosteriorGrid& grid);

/// Any outcomes: [outcome][stimulus][cell], each cell in the grid's order. Failure: badInput (sizes, negative, sums that are not 1).
core::Result<std::shared_ptr<const OutcomeTables>> generalTables(const std::vector<std::vector<std::vector<double>>>& probabilities,
                                                                 const PosteriorGrid& grid);

} // namespace chiron::psychophysics
