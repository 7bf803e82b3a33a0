// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/posterior_grid.h"
#include "psychophysics/procedures/psychometric_functions.h"

#include <memory>
#include <span>
#include <vector>

namespace chiron::psychophysics {

/// The stimulus after which the least entropy is expected.
struct BestStimulus {
    int index = -1;    ///< lowest index among the stimuli within kEntropyTie of the minimum
    double gain = 0.0; ///< minimum of the expected entropy after the trial minus the entropy now (nats, at
                       ///< most 0)
    double margin = std::numeric_limits<double>::quiet_NaN(); ///< second smallest value minus the smallest
};
using Rows = std::span<const int>; ///< rows of the grid of stimuli, ascending
inline constexpr double kEntropyTie = 1e-9;

/// The probabilities p(outcome | stimulus, cell) and the computations of QUEST+ based on them. Because the
/// outcomes sum to one (Watson 2017, eq. 5, rearranged), EH(x) = H(p) + Σ_r P_r ln P_r - (M p)(x), with P_r =
/// L_r p and M = Σ_r L_r ln L_r. M is set up once, so that a trial needs no logarithm per cell. Immutable;
/// any number of procedures and threads may share it.
class OutcomeTables {
public:
    OutcomeTables() = default;
    OutcomeTables(const OutcomeTables&) = delete;
    OutcomeTables& operator=(const OutcomeTables&) = delete;
    virtual ~OutcomeTables() = default;

    virtual int outcomes() const noexcept = 0;
    virtual std::size_t stimuli() const noexcept = 0;
    /// Returns Σ_r P_r ln P_r - (M p)(x) for every stimulus.
    virtual std::vector<double> gains(const PosteriorGrid& posterior) const = 0;
    /// Returns the best stimulus that is not excluded.
    virtual BestStimulus best(const PosteriorGrid& posterior, const Rows& excluded) const;
    /// Returns one number per cell, padded with zeros.
    virtual void likelihood(std::size_t stimulus, int outcome, std::vector<double>& to) const = 0;

protected:
    /// Returns the gains for the entropy of the parameters that are not nuisance parameters (Prins 2013);
    /// this needs logarithms at each trial.
    std::vector<double> marginalGains(const PosteriorGrid& posterior) const;
};

/// Returns the smallest gain, the lowest index among ties, and the margin.
BestStimulus bestOf(std::vector<double> gains, const Rows& excluded);

/// Makes tables for the two outcomes of a psychometric function. The grid's parameters are those of the
/// function, in its order.
/// Errors: badInput (asymptotes outside 0..1, or a function value that is not a number).
core::Result<std::shared_ptr<const OutcomeTables>> psychometricTables(const PsychometricFunction& function,
                                                                      const std::vector<Stimulus>& stimuli,
                                                                      const PosteriorGrid& grid);

/// Makes tables for any outcomes: [outcome][stimulus][cell], with the cells in the grid's order.
/// Errors: badInput (sizes, negative values, sums that are not 1).
core::Result<std::shared_ptr<const OutcomeTables>>
generalTables(const std::vector<std::vector<std::vector<double>>>& probabilities, const PosteriorGrid& grid);

} // namespace chiron::psychophysics
