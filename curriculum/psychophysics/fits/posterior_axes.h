// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace chiron::psychophysics {

/// Nodes and weights of a one-dimensional integral, and the interval they stand for.
struct QuadratureAxis {
    double low = 0.0;
    double high = 0.0;
    std::vector<double> nodes;
    std::vector<double> weights;
    std::size_t size() const noexcept { return nodes.size(); }
    bool fixed() const noexcept { return nodes.size() == 1; }
};

QuadratureAxis fixedAxis(double value);                                           ///< one node of weight 1
QuadratureAxis trapezoidAxis(double low, double high, std::size_t nodes);         ///< both ends are nodes
QuadratureAxis gaussLegendreAxis(double low, double high, std::size_t nodes);     ///< ends are none

/// A marginal density known at an axis' nodes: local cubics between them.
class Marginal {
public:
    Marginal(const QuadratureAxis& axis, const std::vector<double>& density);
    double quantile(double share) const noexcept;

private:
    std::vector<double> m_places, m_cumulative;
};

} // namespace chiron::psychophysics
