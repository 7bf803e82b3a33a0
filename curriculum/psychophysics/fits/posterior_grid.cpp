// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_grid.h"

#include "psychophysics/fits/beta_binomial.h"
#include "psychophysics/fits/sigmoid_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();
constexpr double kNegligible = 14.0; ///< e^−14: 1e-6 of the largest density

std::vector<BetaBinomialTable> tablesFor(const PosteriorModel& model, const PosteriorAxes& axes) {
    std::vector<BetaBinomialTable> tables;
    tables.reserve(model.levels.size());
    const double lowest = model.free.equal ? axes.axis[PosteriorAxes::lapse].low : axes.axis[PosteriorAxes::guess].low;
    const double highest = 1.0 - axes.axis[PosteriorAxes::lapse].low;
    for (std::size_t i = 0; i < model.levels.size(); ++i) {
        tables.emplace_back(model.levels.right[i], model.levels.of[i], axes.axis[PosteriorAxes::eta].nodes, lowest, highest);
    }
    return tables;
}

/// The axis' own kind of nodes over another interval.
QuadratureAxis nodesOver(std::size_t axis, double low, double high, std::size_t nodes) {
    if (axis == PosteriorAxes::threshold || axis == PosteriorAxes::logWidth) {
        return trapezoidAxis(low, high, nodes);
    }
    return gaussLegendreAxis(low, high, nodes);
}

double coordinate(const CurveParameters& at, std::size_t axis) noexcept {
    switch (axis) {
    case PosteriorAxes::threshold: return at.threshold;
    case PosteriorAxes::logWidth: return std::log(at.width);
    case PosteriorAxes::guess: return at.guess;
    case PosteriorAxes::lapse: return at.lapse;
    default: return at.eta;
    }
}

/// From the node before the first that matters to the node after the last, with `inside` inside.
std::pair<double, double> mattering(const QuadratureAxis& axis, const std::vector<double>& profile, double highest, double inside) noexcept {
    std::size_t first = 0, last = axis.size() - 1;
    while (first < last && profile[first] < highest - kNegligible) {
        ++first;
    }
    while (last > first && profile[last] < highest - kNegligible) {
        --last;
    }
    const double low = first > 0 ? axis.nodes[first - 1] : axis.low;
    const double high = last + 1 < axis.size() ? axis.nodes[last + 1] : axis.high;
    const double margin = 0.02 * (high - low);
    return {std::max(axis.low, std::min(low, inside - margin)), std::min(axis.high, std::max(high, inside + margin))};
}

} // namespace

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
                const double shares = prior + (model.free.lapse ? model.priors.logShare(lapse) : 0.0) + (model.free.guess ? model.priors.logShare(guess) : 0.0);
                for (std::size_t e = 0; e < etas; ++e) {
                    cell[e] = shares + model.priors.logShare(axis[PosteriorAxes::eta].nodes[e]);
                }
                for (std::size_t i = 0; i < levels; ++i) {
                    tables[i].addTo(std::log((guess + reach * s[i].rise) / (lapse + reach * s[i].rest)), cell);
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

std::vector<double> DensityGrid::profile(std::size_t axis) const {
    std::vector<double> most(m_axes.axis[axis].size(), kImpossible);
    for (std::size_t cell = 0; cell < m_logs.size(); ++cell) {
        double& here = most[nodeOf(cell, axis)];
        here = std::max(here, m_logs[cell]);
    }
    return most;
}

CurveParameters DensityGrid::parametersAt(std::size_t cell) const noexcept {
    const auto node = [&](std::size_t axis) { return m_axes.axis[axis].nodes[nodeOf(cell, axis)]; };
    const double lapse = node(PosteriorAxes::lapse);
    return {node(PosteriorAxes::threshold), std::exp(node(PosteriorAxes::logWidth)), lapse, m_equal ? lapse : node(PosteriorAxes::guess),
            node(PosteriorAxes::eta)};
}

PosteriorAxes wholeSpace(const PosteriorModel& model, const GridSize& size) {
    const FitPriors& priors = model.priors;
    PosteriorAxes axes;
    axes.axis[PosteriorAxes::threshold] = trapezoidAxis(priors.lowestThreshold(), priors.highestThreshold(), size.threshold);
    axes.axis[PosteriorAxes::logWidth] = trapezoidAxis(std::log(priors.spacing), std::log(priors.largestWidth()), size.width);
    axes.axis[PosteriorAxes::guess] = model.free.guess ? gaussLegendreAxis(0.0, model.free.largestGuess, size.share) : fixedAxis(model.guess);
    axes.axis[PosteriorAxes::lapse] = model.free.lapse ? gaussLegendreAxis(0.0, model.free.largestLapse, size.share) : fixedAxis(model.lapse);
    constexpr double kMostEta = 0.999;
    axes.axis[PosteriorAxes::eta] = model.overdispersion ? gaussLegendreAxis(0.0, kMostEta, size.eta) : fixedAxis(0.0);
    return axes;
}

PosteriorAxes posteriorRegion(const PosteriorModel& model, const DensityGrid& whole, const CurveParameters& mode,
                              const GridSize& fine) {
    PosteriorAxes axes = whole.axes();
    const DensityGrid* grid = &whole;
    std::vector<DensityGrid> pass;
    pass.reserve(1);
    constexpr int kMostPasses = 24;
    for (int i = 0; i < kMostPasses; ++i) {
        bool smaller = false;
        for (std::size_t a = 0; a < PosteriorAxes::count; ++a) {
            const QuadratureAxis& before = grid->axes().axis[a];
            if (!before.fixed()) {
                const auto [low, high] = mattering(before, grid->profile(a), grid->highest(), coordinate(mode, a));
                smaller = smaller || high - low < 0.7 * (before.high - before.low);
                axes.axis[a] = nodesOver(a, low, high, before.size());
            }
        }
        if (!smaller) {
            break;
        }
        pass.clear();
        pass.emplace_back(model, axes);
        grid = &pass.front();
    }
    const std::array<std::size_t, PosteriorAxes::count> nodes{fine.threshold, fine.width, fine.share, fine.share, fine.eta};
    for (std::size_t a = 0; a < PosteriorAxes::count; ++a) {
        QuadratureAxis& axis = axes.axis[a];
        if (!axis.fixed()) {
            axis = nodesOver(a, axis.low, axis.high, nodes[a]);
        }
    }
    return axes;
}

} // namespace chiron::psychophysics
