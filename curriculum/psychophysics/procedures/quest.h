// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/trial_log.h"

#include <utility>

namespace chiron::psychophysics {

/// Returns the ε at which p(x = T) equals the target: the solution of δγ + (1-δ)(1-(1-γ) exp(-10^(βε))). Not
/// a number if the target cannot be reached.
double questEpsilon(double target, double slope, double guess, double lapse) noexcept;

/// Returns the order of the posterior's quantile at which to test, after Pelli (1987), for a function from
/// `low` to `high`.
double optimalQuantileOrder(double low, double high) noexcept;

/// QUEST (Watson & Pelli 1983) on a grid of thresholds around the prior mean. The first trial is at the prior
/// mean, later ones at the optimal quantile, mean or mode of the posterior, within minimum..maximum.
/// Interpolation is as in the common implementations, also for ε (quest@1 used the closed form) and up to the
/// grid's last point (quest@2 left it out and lost tiny probabilities), so that it reproduces their
/// sequences.
class Quest final : public LoggedProcedure {
public:
    static core::Result<std::unique_ptr<Procedure>> make(const QuestSpec& spec);
    explicit Quest(QuestSpec spec);

    std::string_view id() const noexcept override { return "quest@3"; }
    Choice next() const override;
    bool done() const noexcept override;
    ProcedureEstimate estimate() const override;

    double mean() const;
    double mode() const;
    double sd() const;
    /// Returns the 95 % interval of the threshold (where the target is reached) without assuming the slope:
    /// from the lowest to the highest end of the central intervals for all slopes between a quarter of and
    /// four times the assumed one that are compatible with the answers (within the 95 % likelihood region).
    /// QUEST places trials where they carry little information about the slope, so an average over slopes
    /// would be too short for the flat ones. sd() assumes that the slope is known.
    std::pair<double, double> intervalWithOpenSlope() const;
    /// Returns the posterior quantile of `order` (0..1), interpolated linearly between the grid points at
    /// which the distribution rises. Monotone in `order`.
    double quantile(double order) const;
    double quantileOrder() const noexcept { return m_order; }

protected:
    void restart() override;
    core::Result<void> take(const RecordedTrial& trial) override;

private:
    void tabulate(double epsilon);
    double offset() const;
    double x(std::size_t i) const noexcept { return (static_cast<double>(i) - m_half) * m_spec.grain; }

    QuestSpec m_spec;
    double m_half = 0.0; ///< number of grid points on either side of the prior mean
    double m_order = 0.5;
    std::vector<double> m_right; ///< p(right), indexed by (stimulus - threshold)/grain + 2 m_half
    std::vector<double> m_wrong; ///< p(wrong), accurate even where it is tiny
    std::vector<double> m_pdf;
};

} // namespace chiron::psychophysics
