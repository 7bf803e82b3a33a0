// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace chiron::psychophysics {

/// Returns the ln of the beta-binomial probability of `right` of `of` answers, without the binomial
/// coefficient, for a mean of ψ (rest = 1 − ψ) and an overdispersion η: α = ψν, β = (1 − ψ)ν, ν = 1/η² − 1
/// (Schütt et al. 2016). It tends to the binomial probability as η → 0, without cancellation.
double betaBinomialLog(double right, double of, double psi, double rest, double eta) noexcept;

/// The same for one level and several η at once, from a table over logit ψ with cubic interpolation (error
/// below 1e-4 times the square root of the level's trials over 100, at most 1e-3). An integral over hundreds
/// of thousands of curves needs this speed.
class BetaBinomialTable {
public:
    /// `lowest` and `highest` bound every ψ that will be asked for.
    BetaBinomialTable(double right, double of, const std::vector<double>& etas, double lowest,
                      double highest);

    /// Adds ln p for every η to sums. logit = ln(ψ/(1 − ψ)) is clamped to the table.
    void addTo(double logit, double* sums) const noexcept {
        double place = (logit - m_first) * m_perStep;
        place = place < 0.0 ? 0.0 : place > m_last ? m_last : place;
        std::size_t node = static_cast<std::size_t>(place);
        node = node > m_lastNode ? m_lastNode : node;
        const double f = place - static_cast<double>(node); // nodes −1, 0, 1, 2 are rows node … node + 3
        const double before = f * (f - 1.0) * (f - 2.0) * (-1.0 / 6.0);
        const double at = (f + 1.0) * (f - 1.0) * (f - 2.0) * 0.5;
        const double after = (f + 1.0) * f * (f - 2.0) * (-0.5);
        const double beyond = (f + 1.0) * f * (f - 1.0) * (1.0 / 6.0);
        const double* row = m_values.data() + node * m_columns;
        const std::size_t n = m_columns;
        for (std::size_t e = 0; e < n; ++e) {
            sums[e] += before * row[e] + at * row[e + n] + after * row[e + 2 * n] + beyond * row[e + 3 * n];
        }
    }

private:
    std::size_t m_columns;
    double m_first = 0.0; ///< logit of row 1
    double m_perStep = 0.0;
    double m_last = 0.0;
    std::size_t m_lastNode = 0;
    std::vector<double> m_values;
};

} // namespace chiron::psychophysics
