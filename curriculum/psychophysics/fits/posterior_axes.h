// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace chiron::psychophysics {

/// How an axis is divided: a number of panels with a number of Gauss–Legendre nodes each.
struct AxisSize {
    std::size_t panels = 1;
    std::size_t nodes = 1; ///< per panel
};

/// Nodes and weights of a one-dimensional integral, and the panels that contain them.
struct QuadratureAxis {
    std::vector<double> breaks; ///< ends of the panels, ascending
    std::vector<double> nodes;
    std::vector<double> weights;
    double low() const noexcept { return breaks.front(); }
    double high() const noexcept { return breaks.back(); }
    std::size_t size() const noexcept { return nodes.size(); }
    bool fixed() const noexcept { return nodes.size() == 1; }
    /// Returns the ends of the intervals that the nodes represent. Each interval is as long as its node's
    /// weight; there is one more end than there are nodes.
    std::vector<double> edges() const;
};

QuadratureAxis fixedAxis(double value); ///< one node of weight 1
/// Places Gauss–Legendre nodes in every panel. The integral is exact for functions that are polynomials of
/// degree 2 nodes − 1 in each panel.
QuadratureAxis panelAxis(std::vector<double> breaks, std::size_t nodes);
/// Returns the ends of panels that each contain an equal share, where half of a share is mass and half is
/// length. `mass` is uniform within each interval of `edges`, which has one more element.
std::vector<double> equalShares(const std::vector<double>& edges, const std::vector<double>& mass,
                                std::size_t panels);

/// The cumulative distribution of a marginal, interpolated from the masses of an axis' nodes by local cubics
/// through the logarithms of its densities.
class Marginal {
public:
    Marginal(const QuadratureAxis& axis, const std::vector<double>& mass);
    double below(double x) const noexcept;
    double total() const noexcept { return m_cumulative.back(); }
    double low() const noexcept { return m_places.front(); }
    double high() const noexcept { return m_places.back(); }

private:
    void addPanel(const QuadratureAxis& axis, const std::vector<double>& logs, std::size_t panel,
                  double held);
    std::vector<double> m_places, m_cumulative;
    std::vector<double> m_from, m_to; ///< densities at the ends of the piece after each position
};
/// Returns the position below which this share of the mass of all parts lies.
double quantile(const std::vector<Marginal>& parts, double share) noexcept;

} // namespace chiron::psychophysics
