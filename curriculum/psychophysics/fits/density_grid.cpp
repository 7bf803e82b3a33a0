// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/density_grid.h"

#include "psychophysics/fits/beta_binomial.h"
#include "psychophysics/fits/sigmoid_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

/// Range of a level's ψ over a grid. ψ is monotone along each axis, so its extremes lie at the corners.
struct Extent {
    double lowest = 1.0, highest = 0.0;
};

Extent extentOf(const PosteriorModel& model, const PosteriorAxes& axes, double unit) noexcept {
    const SigmoidUnits units = unitsOf(model.sigmoid);
    const auto end = [&](std::size_t axis, bool high) {
        return high ? axes.axis[axis].high() : axes.axis[axis].low();
    };
    Extent extent;
    for (unsigned corner = 0; corner < 16; ++corner) {
        const double threshold = end(PosteriorAxes::threshold, corner & 1u),
                     width = std::exp(end(PosteriorAxes::logWidth, corner & 2u));
        const double lapse = end(PosteriorAxes::lapse, corner & 4u),
                     guess = model.free.equal ? lapse : end(PosteriorAxes::guess, corner & 8u);
        const SigmoidValue s =
            sigmoidAt(model.sigmoid, units.middle + units.spread / width * (unit - threshold));
        const double reach = 1.0 - guess - lapse, psi = guess + reach * s.rise, rest = lapse + reach * s.rest;
        constexpr double kRounded = 1e-12; // below this, 1 − ψ is only a rounding error
        extent.lowest = std::min(extent.lowest, psi);
        extent.highest = std::max(extent.highest, rest > kRounded ? psi : 1.0);
    }
    return extent;
}

std::vector<BetaBinomialTable> tablesFor(const PosteriorModel& model, const PosteriorAxes& axes) {
    std::vector<BetaBinomialTable> tables;
    tables.reserve(model.levels.size());
    for (std::size_t i = 0; i < model.levels.size(); ++i) {
        const Extent extent = extentOf(model, axes, model.levels.unit[i]);
        tables.emplace_back(model.levels.right[i], model.levels.of[i], axes.axis[PosteriorAxes::eta].nodes,
                            extent.lowest, extent.highest);
    }
    return tables;
}

/// Returns the panels for the threshold over the range that the prior allows, as dense as the levels require.
std::vector<double> thresholdBreaks(const PosteriorModel& model, std::size_t panels) {
    const double low = model.priors.lowestThreshold(), high = model.priors.highestThreshold();
    std::vector<double> edges{low}, mass;
    for (const double unit : model.levels.unit) {
        if (unit > edges.back() && unit < high) {
            mass.push_back(edges.size() > 1 ? 1.0 : 0.0); // no mass before the first level
            edges.push_back(unit);
        }
    }
    mass.push_back(0.0);
    edges.push_back(high);
    return equalShares(edges, mass, panels);
}

std::vector<double> evenBreaks(double low, double high, std::size_t panels) {
    return equalShares({low, high}, {0.0}, panels);
}

} // namespace

const AxisSize& GridSize::operator[](std::size_t axis) const noexcept {
    return axis == PosteriorAxes::threshold  ? threshold
           : axis == PosteriorAxes::logWidth ? width
           : axis == PosteriorAxes::eta      ? eta
                                             : share;
}

std::size_t PosteriorAxes::cells() const noexcept {
    std::size_t product = 1;
    for (const QuadratureAxis& one : axis) {
        product *= one.size();
    }
    return product;
}

DensityGrid::DensityGrid(const PosteriorModel& model, PosteriorAxes axes)
    : m_axes(std::move(axes)), m_equal(model.free.equal), m_logs(m_axes.cells()) {
    std::size_t stride = 1;
    for (std::size_t axis = PosteriorAxes::count; axis-- > 0;) {
        m_stride[axis] = stride;
        stride *= m_axes.axis[axis].size();
    }
    fill(model);
    m_highest = *std::max_element(m_logs.begin(), m_logs.end());
}

void DensityGrid::fill(const PosteriorModel& model) {
    const auto tables = tablesFor(model, m_axes);
    const auto& axis = m_axes.axis;
    const std::size_t etas = axis[PosteriorAxes::eta].size(), levels = model.levels.size();
    const SigmoidUnits units = unitsOf(model.sigmoid);
    std::vector<SigmoidValue> s(levels);
    double* cell = m_logs.data();
    const auto fillAsymptotes = [&](double prior) {
        for (const double guessNode : axis[PosteriorAxes::guess].nodes) {
            for (const double lapse : axis[PosteriorAxes::lapse].nodes) {
                const double guess = m_equal ? lapse : guessNode, reach = 1.0 - guess - lapse;
                const double shares = prior + (model.free.lapse ? model.priors.logShare(lapse) : 0.0) +
                                      (model.free.guess ? model.priors.logShare(guess) : 0.0);
                for (std::size_t e = 0; e < etas; ++e) {
                    cell[e] = shares + model.priors.logShare(axis[PosteriorAxes::eta].nodes[e]);
                }
                for (std::size_t i = 0; i < levels; ++i) {
                    tables[i].addTo(std::log((guess + reach * s[i].rise) / (lapse + reach * s[i].rest)),
                                    cell);
                }
                cell += etas;
            }
        }
    };
    const std::size_t inner = m_stride[PosteriorAxes::logWidth];
    shapes::withShape(model.sigmoid, [&]<class Shape>() {
        for (const double threshold : axis[PosteriorAxes::threshold].nodes) {
            for (const double logWidth : axis[PosteriorAxes::logWidth].nodes) {
                const double width = std::exp(logWidth), slope = units.spread / width;
                const double prior = model.priors.logThreshold(threshold) + model.priors.logWidth(width);
                if (!std::isfinite(prior)) {
                    std::fill(cell, cell + inner, kImpossible);
                    cell += inner;
                    continue;
                }
                for (std::size_t i = 0; i < levels; ++i) {
                    s[i] = Shape::at(units.middle + slope * (model.levels.unit[i] - threshold));
                }
                fillAsymptotes(prior);
            }
        }
    });
}

CurveParameters DensityGrid::parametersAt(std::size_t cell) const noexcept {
    const auto node = [&](std::size_t axis) { return m_axes.axis[axis].nodes[nodeOf(cell, axis)]; };
    const double lapse = node(PosteriorAxes::lapse);
    return {node(PosteriorAxes::threshold), std::exp(node(PosteriorAxes::logWidth)), lapse,
            m_equal ? lapse : node(PosteriorAxes::guess), node(PosteriorAxes::eta)};
}

Masses massesOf(const DensityGrid& grid, double reference) {
    using Axes = PosteriorAxes;
    const auto& axis = grid.axes().axis;
    Masses masses;
    masses.cell.resize(grid.logs().size());
    for (std::size_t a = 0; a < Axes::count; ++a) {
        masses.node[a].assign(axis[a].size(), 0.0);
    }
    const double unit = std::exp(grid.highest() - reference);
    std::size_t cell = 0;
    for (std::size_t t = 0; t < axis[Axes::threshold].size(); ++t) {
        for (std::size_t w = 0; w < axis[Axes::logWidth].size(); ++w) {
            const double outer = axis[Axes::threshold].weights[t] * axis[Axes::logWidth].weights[w] *
                                 std::exp(axis[Axes::logWidth].nodes[w]);
            for (std::size_t g = 0; g < axis[Axes::guess].size(); ++g) {
                for (std::size_t l = 0; l < axis[Axes::lapse].size(); ++l) {
                    const double inner = outer * axis[Axes::guess].weights[g] * axis[Axes::lapse].weights[l];
                    double sum = 0.0;
                    for (std::size_t e = 0; e < axis[Axes::eta].size(); ++e, ++cell) {
                        const double log = grid.logs()[cell] - grid.highest();
                        const double mass =
                            log > -40.0 ? unit * inner * axis[Axes::eta].weights[e] * std::exp(log) : 0.0;
                        masses.cell[cell] = mass;
                        masses.node[Axes::eta][e] += mass;
                        sum += mass;
                    }
                    masses.node[Axes::threshold][t] += sum;
                    masses.node[Axes::logWidth][w] += sum;
                    masses.node[Axes::guess][g] += sum;
                    masses.node[Axes::lapse][l] += sum;
                    masses.total += sum;
                }
            }
        }
    }
    return masses;
}

PosteriorAxes wholeSpace(const PosteriorModel& model, const GridSize& size) {
    const FitPriors& priors = model.priors;
    PosteriorAxes axes;
    const auto even = [](double low, double high, const AxisSize& cut) {
        return panelAxis(evenBreaks(low, high, cut.panels), cut.nodes);
    };
    axes.axis[PosteriorAxes::threshold] =
        panelAxis(thresholdBreaks(model, size.threshold.panels), size.threshold.nodes);
    axes.axis[PosteriorAxes::logWidth] =
        even(std::log(priors.lowestWidth()), std::log(priors.largestWidth()), size.width);
    axes.axis[PosteriorAxes::guess] =
        model.free.guess ? even(0.0, model.free.largestGuess, size.share) : fixedAxis(model.guess);
    axes.axis[PosteriorAxes::lapse] =
        model.free.lapse ? even(0.0, model.free.largestLapse, size.share) : fixedAxis(model.lapse);
    axes.axis[PosteriorAxes::eta] = model.overdispersion ? even(0.0, kMostEta, size.eta) : fixedAxis(0.0);
    return axes;
}

} // namespace chiron::psychophysics
