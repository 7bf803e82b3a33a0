// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/trial_log.h"

#include <utility>

namespace chiron::psychophysics {

/// The ε for which p(x = T) is the target: δγ + (1-δ)(1-(1-γ) exp(-10^(βε))), solved. Not a number where the target is out of reach.
double questEpsilon(double target, double slope, double guess, double lapse) noexcept;

/// Pelli's (1987) order of the posterior's quantile to test at, of a function from `low` to `high`.
double optimalQuantileOrder(double low, double high) noexcept;

/// QUEST (Watson & Pelli 1983) on a grid of thresholds around the prior mean. The first trial is at the prior mean; then at the optimal
/// quantile, mean or mode of the posterior, within minimum..maximum. Interpolation as in the common implementations, also of ε (quest@1 had
/// it in closed form) and to the grid's last point (quest@2 left it out, and lost tiny probabilities), whose sequences it gives.
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
    /// 95 % interval of the threshold (where the target is reached) with the slope left open: from the lowest to the highest end of the central intervals
    /// of all slopes, from a quarter of the assumed one to four times it, that the answers leave possible (within the 95 % likelihood region).
    /// QUEST places trials where they say little of the slope, so an average over slopes would be too short for the flat ones. Its own sd takes the
    /// slope for known.
    std::pair<double, double> intervalWithOpenSlope() const;
    /// Failure of a flat stretch aside, monotone in `order` (0..1).
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
    double m_half = 0.0;         ///< grid points on either side of the prior mean
    double m_order = 0.5;
    std::vector<double> m_right; ///< p(right) by (stimulus - threshold)/grain + 2 m_half
    std::vector<double> m_wrong; ///< p(wrong), as exact where it is tiny
    std::vector<double> m_pdf;
};

} // namespace chiron::psychophysics
