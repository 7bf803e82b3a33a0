// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace chiron::psychophysics {
namespace {

/// Nodes and weights over [−1, 1], ascending.
struct Rule {
    std::vector<double> nodes, weights;
};

Rule gaussLegendre(std::size_t nodes) {
    Rule rule{std::vector<double>(nodes), std::vector<double>(nodes)};
    const double count = static_cast<double>(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
        double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (count + 0.5));
        double derivative = 1.0;
        for (int step = 0; step < 8; ++step) { // Newton's method on the Legendre polynomial, evaluated by its
                                               // recurrence
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
        rule.nodes[nodes - 1 - i] = x;
        rule.weights[nodes - 1 - i] = 2.0 / ((1.0 - x * x) * derivative * derivative);
    }
    return rule;
}

/// Returns the cubic through the four nodes around x (the nearest four at the ends), limited to little more
/// than the largest of their values.
double localCubic(const std::vector<double>& nodes, const std::vector<double>& values, double x) noexcept {
    const std::size_t order = std::min<std::size_t>(4, nodes.size());
    const auto after =
        static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin());
    const std::size_t first = std::min(after > order / 2 ? after - order / 2 : 0, nodes.size() - order);
    double sum = 0.0, most = values[first];
    for (std::size_t i = first; i < first + order; ++i) {
        double basis = 1.0;
        for (std::size_t j = first; j < first + order; ++j) {
            basis *= j == i ? 1.0 : (x - nodes[j]) / (nodes[i] - nodes[j]);
        }
        sum += basis * values[i];
        most = std::max(most, values[i]);
    }
    constexpr double kOver = 1.0; // a peak between two nodes may be higher than both
    return std::min(sum, most + kOver);
}

} // namespace

std::vector<double> QuadratureAxis::edges() const {
    std::vector<double> ends{low()};
    for (const double weight : weights) {
        ends.push_back(ends.back() + weight);
    }
    ends.back() = high();
    return ends;
}

QuadratureAxis fixedAxis(double value) {
    return {{value, value}, {value}, {1.0}};
}

QuadratureAxis panelAxis(std::vector<double> breaks, std::size_t nodes) {
    const Rule rule = gaussLegendre(nodes);
    QuadratureAxis axis{std::move(breaks), {}, {}};
    for (std::size_t panel = 0; panel + 1 < axis.breaks.size(); ++panel) {
        const double from = axis.breaks[panel], half = 0.5 * (axis.breaks[panel + 1] - from);
        for (std::size_t i = 0; i < nodes; ++i) {
            axis.nodes.push_back(from + half * (1.0 + rule.nodes[i]));
            axis.weights.push_back(half * rule.weights[i]);
        }
    }
    return axis;
}

std::vector<double> equalShares(const std::vector<double>& edges, const std::vector<double>& mass,
                                std::size_t panels) {
    double total = 0.0;
    for (const double one : mass) {
        total += one;
    }
    const double length = edges.back() - edges.front(), each = 1.0 / static_cast<double>(panels);
    std::vector<double> breaks{edges.front()};
    double before = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        const double step = edges[i + 1] - edges[i];
        const double share =
            0.5 * step / length + (total > 0.0 ? 0.5 * mass[i] / total : 0.5 * step / length);
        while (breaks.size() < panels && before + share >= each * static_cast<double>(breaks.size())) {
            const double part = (each * static_cast<double>(breaks.size()) - before) / share;
            breaks.push_back(edges[i] + std::clamp(part, 0.0, 1.0) * step);
        }
        before += share;
    }
    breaks.push_back(edges.back());
    return breaks;
}

Marginal::Marginal(const QuadratureAxis& axis, const std::vector<double>& mass)
    : m_places{axis.low()}, m_cumulative{0.0} {
    constexpr double kLeast = 1e-6, kTiny = 1e-300; // relative to the highest density, and absolute
    std::vector<double> logs(mass.size());
    double highest = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        logs[i] = mass[i] / axis.weights[i];
        highest = std::max(highest, logs[i]);
    }
    for (double& log : logs) {
        log = std::log(std::max({log, kLeast * highest, kTiny}));
    }
    const std::size_t panels = axis.breaks.size() - 1, nodes = axis.size() / panels;
    for (std::size_t panel = 0; panel < panels; ++panel) {
        double held = 0.0;
        for (std::size_t i = panel * nodes; i < (panel + 1) * nodes; ++i) {
            held += mass[i];
        }
        addPanel(axis, logs, panel, held);
    }
}

void Marginal::addPanel(const QuadratureAxis& axis, const std::vector<double>& logs, std::size_t panel,
                        double held) {
    constexpr std::size_t kPieces = 40;
    const double from = axis.breaks[panel], step = (axis.breaks[panel + 1] - from) / kPieces;
    std::array<double, kPieces + 1> density;
    double sum = 0.0;
    for (std::size_t piece = 0; piece <= kPieces; ++piece) {
        density[piece] = std::exp(localCubic(axis.nodes, logs, from + step * static_cast<double>(piece)));
        sum += (piece == 0 || piece == kPieces ? 0.5 : 1.0) * density[piece] * step;
    }
    const double scale = sum > 0.0 ? held / sum : 0.0; // the quadrature's sum is the more accurate one
    for (std::size_t piece = 0; piece < kPieces; ++piece) {
        m_from.push_back(scale * density[piece]);
        m_to.push_back(scale * density[piece + 1]);
        m_places.push_back(piece + 1 == kPieces ? axis.breaks[panel + 1]
                                                : from + step * static_cast<double>(piece + 1));
        m_cumulative.push_back(m_cumulative.back() + 0.5 * (m_from.back() + m_to.back()) * step);
    }
}

double Marginal::below(double x) const noexcept {
    const auto after = std::upper_bound(m_places.begin(), m_places.end(), x);
    if (after == m_places.begin() || after == m_places.end()) {
        return after == m_places.begin() ? 0.0 : m_cumulative.back();
    }
    const auto i = static_cast<std::size_t>(after - m_places.begin());
    const double part = (x - m_places[i - 1]) / (m_places[i] - m_places[i - 1]);
    const double step = m_places[i] - m_places[i - 1];
    return m_cumulative[i - 1] + step * part * (m_from[i - 1] + 0.5 * part * (m_to[i - 1] - m_from[i - 1]));
}

double quantile(const std::vector<Marginal>& parts, double share) noexcept {
    double low = parts.front().low(), high = parts.front().high(), total = 0.0;
    for (const Marginal& part : parts) {
        low = std::min(low, part.low());
        high = std::max(high, part.high());
        total += part.total();
    }
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        double below = 0.0;
        for (const Marginal& part : parts) {
            below += part.below(middle);
        }
        (below < share * total ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace chiron::psychophysics
