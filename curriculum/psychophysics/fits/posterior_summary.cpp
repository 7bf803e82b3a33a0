// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_summary.h"

#include "core/random.h"
#include "psychophysics/fits/fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chiron::psychophysics {
namespace {

using Axes = PosteriorAxes;

/// Mass of each cell, and marginal mass of each node of every axis.
struct Masses {
    std::vector<double> cell;
    std::array<std::vector<double>, Axes::count> node;
    double total = 0.0;
};

Masses massesOf(const DensityGrid& grid) {
    const auto& axis = grid.axes().axis;
    Masses masses;
    masses.cell.resize(grid.logs().size());
    for (std::size_t a = 0; a < Axes::count; ++a) {
        masses.node[a].assign(axis[a].size(), 0.0);
    }
    std::size_t cell = 0;
    for (std::size_t t = 0; t < axis[Axes::threshold].size(); ++t) {
        for (std::size_t w = 0; w < axis[Axes::logWidth].size(); ++w) {
            const double outer = axis[Axes::threshold].weights[t] * axis[Axes::logWidth].weights[w] * std::exp(axis[Axes::logWidth].nodes[w]);
            for (std::size_t g = 0; g < axis[Axes::guess].size(); ++g) {
                for (std::size_t l = 0; l < axis[Axes::lapse].size(); ++l) {
                    const double inner = outer * axis[Axes::guess].weights[g] * axis[Axes::lapse].weights[l];
                    double sum = 0.0;
                    for (std::size_t e = 0; e < axis[Axes::eta].size(); ++e, ++cell) {
                        const double log = grid.logs()[cell] - grid.highest();
                        const double mass = log > -40.0 ? inner * axis[Axes::eta].weights[e] * std::exp(log) : 0.0;
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

struct Moments {
    double mean, sd;
};

Moments momentsOf(const QuadratureAxis& axis, const std::vector<double>& mass, double total, bool logarithm) {
    double first = 0.0, second = 0.0;
    for (std::size_t i = 0; i < axis.size(); ++i) {
        first += mass[i] / total * (logarithm ? std::exp(axis.nodes[i]) : axis.nodes[i]);
    }
    for (std::size_t i = 0; i < axis.size(); ++i) {
        const double away = (logarithm ? std::exp(axis.nodes[i]) : axis.nodes[i]) - first;
        second += mass[i] / total * away * away;
    }
    return {first, std::sqrt(second)};
}

FitInterval percentiles(const QuadratureAxis& axis, const std::vector<double>& mass, double confidence) {
    if (axis.fixed()) {
        return {axis.low, axis.low};
    }
    std::vector<double> density(mass.size());
    for (std::size_t i = 0; i < mass.size(); ++i) {
        density[i] = mass[i] / axis.weights[i];
    }
    const Marginal marginal(axis, density);
    const double tail = 0.5 * (1.0 - confidence);
    return {marginal.quantile(tail), marginal.quantile(1.0 - tail)};
}

/// The extent along each axis of the joint region of highest density.
std::array<FitInterval, Axes::count> projections(const DensityGrid& grid, const Masses& masses, double confidence) {
    std::vector<std::size_t> order(masses.cell.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return grid.logs()[a] > grid.logs()[b]; });
    std::array<FitInterval, Axes::count> extent;
    double sum = 0.0;
    for (const std::size_t cell : order) {
        for (std::size_t a = 0; a < Axes::count; ++a) {
            const double at = grid.axes().axis[a].nodes[grid.nodeOf(cell, a)];
            extent[a].low = std::isnan(extent[a].low) ? at : std::min(extent[a].low, at);
            extent[a].high = std::isnan(extent[a].high) ? at : std::max(extent[a].high, at);
        }
        sum += masses.cell[cell];
        if (sum >= confidence * masses.total) {
            break;
        }
    }
    return extent;
}

void addIntervals(FitResult& result, const DensityGrid& grid, const Masses& masses, const PreparedLevels& levels, const FitOptions& options) {
    std::array<FitInterval, Axes::count> interval;
    if (options.credible == CredibleMethod::projection) {
        interval = projections(grid, masses, options.confidence);
    } else {
        for (std::size_t a = 0; a < Axes::count; ++a) {
            interval[a] = percentiles(grid.axes().axis[a], masses.node[a], options.confidence);
        }
    }
    const auto given = [&](double unit) { return fromScale(levels.centre + levels.range * unit, result.scale); };
    result.ci.threshold = {given(interval[Axes::threshold].low), given(interval[Axes::threshold].high)};
    result.ci.width = {levels.range * std::exp(interval[Axes::logWidth].low), levels.range * std::exp(interval[Axes::logWidth].high)};
    result.ci.lapse = interval[Axes::lapse];
    result.ci.guess = freeParameters(options).equal ? interval[Axes::lapse] : interval[Axes::guess];
    result.ci.eta = interval[Axes::eta];
}

/// A place inside the interval that a node stands for.
double within(const QuadratureAxis& axis, std::size_t node, double share) noexcept {
    if (axis.fixed()) {
        return axis.low;
    }
    double from = axis.low;
    for (std::size_t i = 0; i < node; ++i) {
        from += axis.weights[i];
    }
    return from + share * axis.weights[node];
}

void addDraws(FitResult& result, const DensityGrid& grid, const Masses& masses, const PreparedLevels& levels, const FitOptions& options, int draws) {
    core::Random random = core::Random::stream(options.seed, "posterior draws");
    const bool equal = freeParameters(options).equal;
    const double step = masses.total / draws;
    double next = step * random.uniform(), sum = 0.0;
    result.draws.reserve(static_cast<std::size_t>(draws));
    for (std::size_t cell = 0; cell < masses.cell.size(); ++cell) {
        sum += masses.cell[cell];
        for (; next < sum && std::ssize(result.draws) < draws; next += step) {
            std::array<double, Axes::count> at{};
            for (std::size_t a = 0; a < Axes::count; ++a) {
                at[a] = within(grid.axes().axis[a], grid.nodeOf(cell, a), random.uniform());
            }
            result.draws.push_back({levels.centre + levels.range * at[Axes::threshold], levels.range * std::exp(at[Axes::logWidth]), at[Axes::lapse],
                                    equal ? at[Axes::lapse] : at[Axes::guess], at[Axes::eta]});
        }
    }
}

} // namespace

void addPosterior(FitResult& result, const DensityGrid& grid, const PreparedLevels& levels, const FitOptions& options) {
    const Masses masses = massesOf(grid);
    const auto moments = [&](std::size_t a) { return momentsOf(grid.axes().axis[a], masses.node[a], masses.total, a == Axes::logWidth); };
    const Moments threshold = moments(Axes::threshold), width = moments(Axes::logWidth), lapse = moments(Axes::lapse);
    const Moments guess = freeParameters(options).equal ? lapse : moments(Axes::guess), eta = moments(Axes::eta);
    result.mean = {levels.centre + levels.range * threshold.mean, levels.range * width.mean, lapse.mean, guess.mean, eta.mean};
    result.error = {levels.range * threshold.sd, levels.range * width.sd, lapse.sd, guess.sd, eta.sd};
    addIntervals(result, grid, masses, levels, options);
    constexpr int kBandDraws = 1000;
    const int draws = options.curvePoints > 1 ? std::max(options.draws, kBandDraws) : options.draws;
    if (draws > 0) {
        addDraws(result, grid, masses, levels, options, draws);
    }
}

} // namespace chiron::psychophysics
