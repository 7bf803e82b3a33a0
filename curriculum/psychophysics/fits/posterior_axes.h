// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace chiron::psychophysics {

/// How an axis is cut: panels of so many Gauss–Legendre nodes each.
struct AxisSize {
    std::size_t panels = 1;
    std::size_t nodes = 1; ///< of a panel
};

/// Nodes and weights of a one-dimensional integral, and the panels they stand in.
struct QuadratureAxis {
    std::vector<double> breaks; ///< ends of the panels, ascending
    std::vector<double> nodes;
    std::vector<double> weights;
    double low() const noexcept { return breaks.front(); }
    double high() const noexcept { return breaks.back(); }
    std::size_t size() const noexcept { return nodes.size(); }
    bool fixed() const noexcept { return nodes.size() == 1; }
    /// Ends of the intervals that the nodes stand for: as long as their weights, one more than nodes.
    std::vector<double> edges() const;
};

QuadratureAxis fixedAxis(double value); ///< one node of weight 1
/// Gauss–Legendre in every panel: exact for what is a polynomial of degree 2 nodes − 1 in each.
QuadratureAxis panelAxis(std::vector<double> breaks, std::size_t nodes);
/// Ends of panels that hold equal shares, each half of mass and half of length; `mass` lies evenly between `edges` (one more).
std::vector<double> equalShares(const std::vector<double>& edges, const std::vector<double>& mass, std::size_t panels);

/// A marginal's mass below any place, known from the masses of an axis' nodes: local cubics through the logarithms of its densities.
class Marginal {
public:
    Marginal(const QuadratureAxis& axis, const std::vector<double>& mass);
    double below(double x) const noexcept;
    double total() const noexcept { return m_cumulative.back(); }
    double low() const noexcept { return m_places.front(); }
    double high() const noexcept { return m_places.back(); }

private:
    void addPanel(const QuadratureAxis& axis, const std::vector<double>& logs, std::size_t panel, double held);
    std::vector<double> m_places, m_cumulative;
    std::vector<double> m_from, m_to; ///< densities at the ends of the piece after each place
};
/// Where so large a share of all parts' mass lies below.
double quantile(const std::vector<Marginal>& parts, double share) noexcept;

} // namespace chiron::psychophysics
