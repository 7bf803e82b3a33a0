// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::psychophysics {
namespace {

/// The cubic through the four nodes around x (the nearest four at the ends), held at 0 from below.
double localCubic(const std::vector<double>& nodes, const std::vector<double>& values, double x) {
    const std::size_t order = std::min<std::size_t>(4, nodes.size());
    const auto after = static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin());
    const std::size_t first = std::min(after > order / 2 ? after - order / 2 : 0, nodes.size() - order);
    double sum = 0.0;
    for (std::size_t i = first; i < first + order; ++i) {
        double basis = 1.0;
        for (std::size_t j = first; j < first + order; ++j) {
            basis *= j == i ? 1.0 : (x - nodes[j]) / (nodes[i] - nodes[j]);
        }
        sum += basis * values[i];
    }
    return std::max(sum, 0.0);
}

} // namespace

QuadratureAxis fixedAxis(double value) { return {value, value, {value}, {1.0}}; }

QuadratureAxis trapezoidAxis(double low, double high, std::size_t nodes) {
    QuadratureAxis axis{low, high, {}, {}};
    const double step = (high - low) / static_cast<double>(nodes - 1);
    for (std::size_t i = 0; i < nodes; ++i) {
        axis.nodes.push_back(low + step * static_cast<double>(i));
        axis.weights.push_back(i == 0 || i + 1 == nodes ? 0.5 * step : step);
    }
    return axis;
}

QuadratureAxis gaussLegendreAxis(double low, double high, std::size_t nodes) {
    QuadratureAxis axis{low, high, std::vector<double>(nodes), std::vector<double>(nodes)};
    const double half = 0.5 * (high - low), count = static_cast<double>(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
        double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (count + 0.5));
        double derivative = 1.0;
        for (int step = 0; step < 8; ++step) { // Newton on Legendre's polynomial by its recurrence
            double p = 1.0, previous = 0.0;
            for (std::size_t k = 1; k <= nodes; ++k) {
                const double n = static_cast<double>(k);
                const double next = ((2.0 * n - 1.0) * x * p - (n - 1.0) * previous) / n;
                previous = p;
                p = next;
            }
            derivative = count * (x * p - previous) / (x * x - 1.0);
            x -= p / derivative;
        }
        axis.nodes[nodes - 1 - i] = low + half * (1.0 + x);
        axis.weights[nodes - 1 - i] = 2.0 * half / ((1.0 - x * x) * derivative * derivative);
    }
    return axis;
}

Marginal::Marginal(const QuadratureAxis& axis, const std::vector<double>& density) {
    constexpr int kPieces = 12; // between two nodes
    m_places.push_back(axis.low);
    for (std::size_t i = 0; i <= axis.size(); ++i) {
        const double from = i == 0 ? axis.low : axis.nodes[i - 1];
        const double to = i == axis.size() ? axis.high : axis.nodes[i];
        for (int piece = 1; piece <= kPieces && to > from; ++piece) {
            m_places.push_back(from + (to - from) * piece / kPieces);
        }
    }
    double last = localCubic(axis.nodes, density, m_places.front()), sum = 0.0;
    m_cumulative.push_back(0.0);
    for (std::size_t i = 1; i < m_places.size(); ++i) {
        const double next = localCubic(axis.nodes, density, m_places[i]);
        sum += 0.5 * (last + next) * (m_places[i] - m_places[i - 1]);
        m_cumulative.push_back(sum);
        last = next;
    }
}

double Marginal::quantile(double share) const noexcept {
    const double wanted = share * m_cumulative.back();
    const auto at = std::upper_bound(m_cumulative.begin(), m_cumulative.end(), wanted);
    if (at == m_cumulative.begin() || at == m_cumulative.end()) {
        return at == m_cumulative.begin() ? m_places.front() : m_places.back();
    }
    const auto i = static_cast<std::size_t>(at - m_cumulative.begin());
    const double part = (wanted - m_cumulative[i - 1]) / (m_cumulative[i] - m_cumulative[i - 1]);
    return m_places[i - 1] + part * (m_places[i] - m_places[i - 1]);
}

} // namespace chiron::psychophysics
