// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {
namespace {

constexpr GridSize kCoarse{{8, 3}, {6, 3}, {2, 3}, {1, 3}};
constexpr double kNegligible = 1e-5; ///< share of a part's mass that may lie beyond each end of an axis

struct Range {
    double low, high;
};

/// Returns the bounds along η. At η = 1/√n the answers of n trials scatter √2 times as much as by chance;
/// from there each bound doubles, by at most 0.2.
std::vector<Range> etaBands(const PosteriorModel& model) {
    if (!model.overdispersion) {
        return {{0.0, 0.0}};
    }
    double squares = 0.0;
    for (const double of : model.levels.of) {
        squares += of * of;
    }
    std::vector<Range> bands;
    double low = 0.0;
    for (double end = std::sqrt(model.levels.total / squares); end < 0.8 * kMostEta;
         end += std::min(end, 0.2)) {
        bands.push_back({low, end});
        low = end;
    }
    bands.push_back({low, kMostEta});
    return bands;
}

/// Returns the bands along ln width, because the thresholds spread with the width.
std::vector<Range> widthBands(const FitPriors& priors) {
    constexpr double kLongest = 4.2, kMost = 4.0;
    const double low = std::log(priors.lowestWidth()), length = std::log(priors.largestWidth()) - low;
    const double count = std::clamp(std::ceil(length / kLongest), 1.0, kMost);
    std::vector<Range> bands;
    for (double band = 0.0; band < count; band += 1.0) {
        bands.push_back({low + length * band / count, low + length * (band + 1.0) / count});
    }
    return bands;
}

/// Returns the range from the interval before the first one with relevant mass to the one after the last. The
/// range is extended if mass is cut off at an end.
Range matteringRange(const QuadratureAxis& axis, const std::vector<double>& mass, double total,
                     const Range& limits) {
    const std::vector<double> edges = axis.edges();
    std::size_t first = 0, last = mass.size() - 1;
    for (double below = mass[first]; first < last && below < kNegligible * total; below += mass[first]) {
        ++first;
    }
    for (double above = mass[last]; last > first && above < kNegligible * total; above += mass[last]) {
        --last;
    }
    constexpr double kCut = 0.002, kFurther = 0.5; // relative to a node's own share
    const double length = axis.high() - axis.low();
    const bool cutBelow = mass.front() > kCut * total, cutAbove = mass.back() > kCut * total;
    const double low = first > 0  ? edges[first - 1]
                       : cutBelow ? edges.front() - kFurther * length
                                  : edges.front();
    const double high = last + 1 < mass.size() ? edges[last + 2]
                        : cutAbove             ? edges.back() + kFurther * length
                                               : edges.back();
    return {std::max(low, limits.low), std::min(high, limits.high)};
}

/// Returns the breaks for panels over a range, according to the masses of the axis' nodes.
std::vector<double> breaksWithin(const QuadratureAxis& axis, const std::vector<double>& mass,
                                 const Range& range, std::size_t panels) {
    const std::vector<double> edges = axis.edges();
    std::vector<double> kept{range.low}, held;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        const double from = std::max(edges[i], range.low), to = std::min(edges[i + 1], range.high);
        if (to > from) {
            if (from > kept.back()) {
                held.push_back(0.0); // range that was not covered
                kept.push_back(from);
            }
            held.push_back(mass[i] * (to - from) / (edges[i + 1] - edges[i]));
            kept.push_back(to);
        }
    }
    if (kept.back() < range.high) {
        held.push_back(0.0);
        kept.push_back(range.high);
    }
    return equalShares(kept, held, panels);
}

/// The location of one part of the posterior.
struct Part {
    PosteriorAxes axes; ///< axes of the coarse grid
    std::array<std::vector<double>, PosteriorAxes::count> mass;
    double logMass = 0.0;
};

PosteriorAxes finerAxes(const Part& part, const GridSize& fine) {
    PosteriorAxes axes = part.axes;
    for (std::size_t a = 0; a < PosteriorAxes::count; ++a) {
        const QuadratureAxis& axis = part.axes.axis[a];
        if (!axis.fixed()) {
            axes.axis[a] = panelAxis(
                breaksWithin(axis, part.mass[a], {axis.low(), axis.high()}, fine[a].panels), fine[a].nodes);
        }
    }
    return axes;
}

class PartSearch {
public:
    PartSearch(const PosteriorModel& model, const Range& logWidths, std::size_t panels)
        : m_model(model), m_whole(wholeSpace(model, kCoarse)) {
        m_whole.axis[PosteriorAxes::logWidth] =
            panelAxis(equalShares({logWidths.low, logWidths.high}, {0.0}, panels), kCoarse.width.nodes);
        m_axes = m_whole;
    }

    /// Begins with the region of the previous part, or with the whole space if that contains a higher
    /// density.
    Part find(const Range& etas, bool single) {
        constexpr std::size_t kEtas = 3;
        const QuadratureAxis eta = m_model.overdispersion
                                       ? panelAxis({etas.low, etas.high}, (single ? 2 : 1) * kEtas)
                                       : fixedAxis(0.0);
        m_axes.axis[PosteriorAxes::eta] = m_whole.axis[PosteriorAxes::eta] = eta;
        DensityGrid grid(m_model, m_axes);
        if (m_found) {
            if (DensityGrid whole(m_model, m_whole); whole.highest() > grid.highest()) {
                m_axes = m_whole;
                grid = std::move(whole);
            }
        }
        m_found = true;
        constexpr int kMostPasses = 16;
        for (int pass = 1;; ++pass) {
            Masses masses = massesOf(grid, grid.highest());
            if (pass == kMostPasses || !follow(masses, etas)) {
                return {m_axes, std::move(masses.node), grid.highest() + std::log(masses.total)};
            }
            grid = DensityGrid(m_model, m_axes);
        }
    }

private:
    /// Adapts the axes to the mass; returns whether this changed them substantially.
    bool follow(const Masses& masses, const Range& etas) {
        bool changed = false;
        PosteriorAxes next = m_axes;
        for (std::size_t a = 0; a < PosteriorAxes::count; ++a) {
            const QuadratureAxis& axis = m_axes.axis[a];
            if (axis.fixed()) {
                continue;
            }
            const Range limits =
                a == PosteriorAxes::eta ? etas : Range{m_whole.axis[a].low(), m_whole.axis[a].high()};
            const Range range = matteringRange(axis, masses.node[a], masses.total, limits);
            const double before = axis.high() - axis.low(), after = range.high - range.low;
            changed = changed || after < 0.75 * before || range.low < axis.low() || range.high > axis.high();
            next.axis[a] = panelAxis(breaksWithin(axis, masses.node[a], range, axis.breaks.size() - 1),
                                     axis.size() / (axis.breaks.size() - 1));
        }
        if (changed) {
            m_axes = std::move(next);
        }
        return changed;
    }

    const PosteriorModel& m_model;
    PosteriorAxes m_whole, m_axes;
    bool m_found = false;
};

/// Returns how many of the bands along η are relevant, judged by a coarse grid over the whole space. The grid
/// may miss mass where there is little overdispersion, but then it drops no relevant band.
std::size_t mattering(const PosteriorModel& model, const std::vector<Range>& etas) {
    if (etas.size() == 1) {
        return 1;
    }
    std::vector<double> breaks{0.0};
    for (const Range& band : etas) {
        breaks.push_back(band.high);
    }
    PosteriorAxes axes = wholeSpace(model, kCoarse);
    axes.axis[PosteriorAxes::eta] = panelAxis(std::move(breaks), 2);
    const DensityGrid grid(model, std::move(axes));
    const std::vector<double> mass = massesOf(grid, grid.highest()).node[PosteriorAxes::eta];
    const double most = *std::max_element(mass.begin(), mass.end());
    constexpr double kHopeless = 1e-6;
    std::size_t count = etas.size();
    while (count > 1 && std::max(mass[2 * count - 2], mass[2 * count - 1]) < kHopeless * most) {
        --count;
    }
    return count;
}

/// Returns fewer nodes for parts that hold little mass.
GridSize sizeFor(double share, GridSize size) noexcept {
    constexpr double kLittle = 0.01;
    if (share < kLittle) {
        size.threshold.panels = std::max<std::size_t>(2, 2 * size.threshold.panels / 3);
        size.width.panels = std::max<std::size_t>(2, 2 * size.width.panels / 3);
    }
    return size;
}

} // namespace

std::vector<DensityGrid> posteriorParts(const PosteriorModel& model, const GridSize& fine) {
    const std::vector<Range> etas = etaBands(model), widths = widthBands(model.priors);
    GridSize size = fine;
    size.eta.nodes *= etas.size() == 1 ? 2 : 1;
    size.width.panels =
        widths.size() == 1 ? size.width.panels : std::max<std::size_t>(2, 2 * size.width.panels / 3);
    std::vector<Part> parts;
    double most = -std::numeric_limits<double>::infinity(), total = 0.0;
    const std::size_t bands = mattering(model, etas);
    for (const Range& width : widths) {
        PartSearch search(model, width,
                          widths.size() == 1 ? kCoarse.width.panels : (kCoarse.width.panels + 1) / 2);
        for (std::size_t band = bands; band-- > 0;) {
            parts.push_back(search.find(etas[band], etas.size() == 1));
            most = std::max(most, parts.back().logMass);
        }
    }
    for (const Part& part : parts) {
        total += std::exp(part.logMass - most);
    }
    std::vector<DensityGrid> grids;
    constexpr double kLeast = 1e-4;
    for (const Part& part : parts) {
        if (const double share = std::exp(part.logMass - most) / total; share > kLeast) {
            grids.emplace_back(model, finerAxes(part, sizeFor(share, size)));
        }
    }
    if (grids.empty()) { // no density anywhere: use the whole space of the priors
        grids.emplace_back(model, wholeSpace(model, fine));
    }
    return grids;
}

} // namespace chiron::psychophysics
