// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_summary.h"

#include "core/random.h"
#include "psychophysics/fits/fit.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace chiron::psychophysics {
namespace {

using Axes = PosteriorAxes;

/// The posterior's parts, with their masses in one common unit.
struct Parts {
    const std::vector<DensityGrid>& grids;
    std::vector<Masses> masses;
    double total = 0.0;
};

Parts partsOf(const std::vector<DensityGrid>& grids) {
    double highest = grids.front().highest();
    for (const DensityGrid& grid : grids) {
        highest = std::max(highest, grid.highest());
    }
    Parts parts{grids, {}};
    for (const DensityGrid& grid : grids) {
        parts.masses.push_back(massesOf(grid, highest));
        parts.total += parts.masses.back().total;
    }
    return parts;
}

struct Moments {
    double mean, sd;
};

/// Returns the moments of the width itself or, with asOnAxis, of its logarithm as on the axis.
Moments momentsOf(const Parts& parts, std::size_t a, bool asOnAxis = false) {
    const auto sum = [&](auto&& value) {
        double whole = 0.0;
        for (std::size_t p = 0; p < parts.grids.size(); ++p) {
            const QuadratureAxis& axis = parts.grids[p].axes().axis[a];
            for (std::size_t i = 0; i < axis.size(); ++i) {
                whole += parts.masses[p].node[a][i] / parts.total *
                         value(a == Axes::logWidth && !asOnAxis ? std::exp(axis.nodes[i]) : axis.nodes[i]);
            }
        }
        return whole;
    };
    const double mean = sum([](double x) { return x; });
    return {mean, std::sqrt(sum([&](double x) { return (x - mean) * (x - mean); }))};
}

FitInterval percentiles(const Parts& parts, std::size_t a, double confidence) {
    if (parts.grids.front().axes().axis[a].fixed()) {
        const double value = parts.grids.front().axes().axis[a].low();
        return {value, value};
    }
    std::vector<Marginal> marginals;
    for (std::size_t p = 0; p < parts.grids.size(); ++p) {
        marginals.emplace_back(parts.grids[p].axes().axis[a], parts.masses[p].node[a]);
    }
    const double tail = 0.5 * (1.0 - confidence);
    return {quantile(marginals, tail), quantile(marginals, 1.0 - tail)};
}

/// Returns the extent along each axis of the joint region of highest density, from its outermost nodes as in
/// psignifit.
std::array<FitInterval, Axes::count> projections(const Parts& parts, double confidence) {
    struct Cell {
        double log;
        std::size_t part, cell;
    };
    std::vector<Cell> order;
    for (std::size_t p = 0; p < parts.grids.size(); ++p) {
        for (std::size_t cell = 0; cell < parts.masses[p].cell.size(); ++cell) {
            order.push_back({parts.grids[p].logs()[cell], p, cell});
        }
    }
    std::sort(order.begin(), order.end(), [](const Cell& a, const Cell& b) {
        return std::tuple(-a.log, a.part, a.cell) < std::tuple(-b.log, b.part, b.cell);
    });
    std::array<FitInterval, Axes::count> extent;
    double sum = 0.0;
    for (const Cell& one : order) {
        const DensityGrid& grid = parts.grids[one.part];
        for (std::size_t a = 0; a < Axes::count; ++a) {
            const double at = grid.axes().axis[a].nodes[grid.nodeOf(one.cell, a)];
            extent[a].low = std::isnan(extent[a].low) ? at : std::min(extent[a].low, at);
            extent[a].high = std::isnan(extent[a].high) ? at : std::max(extent[a].high, at);
        }
        sum += parts.masses[one.part].cell[one.cell];
        if (sum >= confidence * parts.total) {
            break;
        }
    }
    return extent;
}

void setIntervals(FitResult& result, const Parts& parts, const PreparedLevels& levels,
                  const FitOptions& options) {
    std::array<FitInterval, Axes::count> interval;
    if (options.credible == CredibleMethod::projection) {
        interval = projections(parts, options.confidence);
    } else {
        for (std::size_t a = 0; a < Axes::count; ++a) {
            interval[a] = percentiles(parts, a, options.confidence);
        }
    }
    const auto given = [&](double unit) {
        return fromScale(levels.centre + levels.range * unit, result.scale);
    };
    result.ci.threshold = {given(interval[Axes::threshold].low), given(interval[Axes::threshold].high)};
    result.ci.width = {levels.range * std::exp(interval[Axes::logWidth].low),
                       levels.range * std::exp(interval[Axes::logWidth].high)};
    result.ci.lapse = interval[Axes::lapse];
    result.ci.guess = freeParameters(options).equal ? interval[Axes::lapse] : interval[Axes::guess];
    result.ci.eta = interval[Axes::eta];
}

void addDraws(FitResult& result, const Parts& parts, const PreparedLevels& levels, const FitOptions& options,
              int draws) {
    core::Random random = core::Random::stream(options.seed, "posterior draws");
    const bool equal = freeParameters(options).equal;
    const double step = parts.total / draws;
    double next = step * random.uniform(), sum = 0.0;
    result.draws.reserve(static_cast<std::size_t>(draws));
    for (std::size_t p = 0; p < parts.grids.size(); ++p) {
        const DensityGrid& grid = parts.grids[p];
        std::array<std::vector<double>, Axes::count> edges;
        for (std::size_t a = 0; a < Axes::count; ++a) {
            edges[a] = grid.axes().axis[a].fixed() ? std::vector<double>(2, grid.axes().axis[a].low())
                                                   : grid.axes().axis[a].edges();
        }
        for (std::size_t cell = 0; cell < parts.masses[p].cell.size(); ++cell) {
            sum += parts.masses[p].cell[cell];
            for (; next < sum && std::ssize(result.draws) < draws; next += step) {
                std::array<double, Axes::count> at{}; // uniform inside the intervals that the nodes represent
                for (std::size_t a = 0; a < Axes::count; ++a) {
                    const std::size_t node = grid.nodeOf(cell, a);
                    at[a] = edges[a][node] + random.uniform() * (edges[a][node + 1] - edges[a][node]);
                }
                result.draws.push_back({levels.centre + levels.range * at[Axes::threshold],
                                        levels.range * std::exp(at[Axes::logWidth]), at[Axes::lapse],
                                        equal ? at[Axes::lapse] : at[Axes::guess], at[Axes::eta]});
            }
        }
    }
}

/// Sets the influence of the prior: the spread of the posterior relative to that of its prior.
void setInfluence(FitResult& result, const Parts& parts, const FitPriors& priors, const FitOptions& options) {
    const FreeParameters free = freeParameters(options);
    const double largestEta = kMostEta;
    CurveParameters& influence = result.priorInfluence;
    influence.threshold = momentsOf(parts, Axes::threshold).sd / priorThresholdSd(priors);
    influence.width = momentsOf(parts, Axes::logWidth, true).sd / priorLogWidthSd(priors);
    influence.lapse =
        free.lapse ? momentsOf(parts, Axes::lapse).sd / priorShareSd(priors, free.largestLapse) : kNotKnown;
    influence.guess = free.equal ? influence.lapse
                      : free.guess
                          ? momentsOf(parts, Axes::guess).sd / priorShareSd(priors, free.largestGuess)
                          : kNotKnown;
    influence.eta = options.overdispersion ? momentsOf(parts, Axes::eta).sd / priorShareSd(priors, largestEta)
                                           : kNotKnown;
}

double shareBelow(const std::vector<DensityGrid>& grids, std::size_t a, double place) {
    const Parts parts = partsOf(grids);
    double below = 0.0, total = 0.0;
    for (std::size_t p = 0; p < grids.size(); ++p) {
        const Marginal marginal(grids[p].axes().axis[a], parts.masses[p].node[a]);
        below += marginal.below(place);
        total += marginal.total();
    }
    return below / total;
}

} // namespace

void addMeans(FitResult& result, const std::vector<DensityGrid>& grids, const PreparedLevels& levels,
              const FitOptions& options) {
    const Parts parts = partsOf(grids);
    const Moments threshold = momentsOf(parts, Axes::threshold), width = momentsOf(parts, Axes::logWidth),
                  lapse = momentsOf(parts, Axes::lapse);
    const Moments guess = freeParameters(options).equal ? lapse : momentsOf(parts, Axes::guess),
                  eta = momentsOf(parts, Axes::eta);
    result.mean = {levels.centre + levels.range * threshold.mean, levels.range * width.mean, lapse.mean,
                   guess.mean, eta.mean};
    result.error = {levels.range * threshold.sd, levels.range * width.sd, lapse.sd, guess.sd, eta.sd};
}

void addIntervals(FitResult& result, const std::vector<DensityGrid>& grids, const FitPriors& priors,
                  const PreparedLevels& levels, const FitOptions& options) {
    const Parts parts = partsOf(grids);
    setIntervals(result, parts, levels, options);
    setInfluence(result, parts, priors, options);
    constexpr int kBandDraws = 1000;
    const int draws = options.curvePoints > 1 ? std::max(options.draws, kBandDraws) : options.draws;
    if (draws > 0) {
        addDraws(result, parts, levels, options, draws);
    }
}

double widthBelow(const std::vector<DensityGrid>& grids, double width) {
    return shareBelow(grids, Axes::logWidth, std::log(width));
}

double widthQuantile(const std::vector<DensityGrid>& grids, double share) {
    return std::exp(percentiles(partsOf(grids), Axes::logWidth, 1.0 - 2.0 * share).low);
}

double thresholdBelow(const std::vector<DensityGrid>& grids, double threshold) {
    return shareBelow(grids, Axes::threshold, threshold);
}

} // namespace chiron::psychophysics
