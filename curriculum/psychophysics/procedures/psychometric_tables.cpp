// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/outcome_tables.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

double xLogX(double x) noexcept {
    return x > 0.0 ? x * std::log(x) : 0.0;
}

/// A function's parameters in a grid's cells: ψ(x, cell) = base[cell] + scale[cell] F(x, shape[cell]).
struct Cells {
    std::vector<double> base, scale;
    std::vector<std::uint32_t> shape;
    std::vector<std::vector<double>> shapes; ///< each combination of the parameters of F, once
};

Cells cellsOf(const PsychometricFunction& function, const PosteriorGrid& grid) {
    Cells cells;
    std::size_t shapes = 1;
    for (std::size_t k = 0; k < function.shape.size(); ++k)
        shapes *= grid.parameter(k).values.size();
    cells.shapes.assign(shapes, std::vector<double>(function.shape.size()));
    cells.base.assign(padded(grid.cells()), 0.0);
    cells.scale.assign(padded(grid.cells()), 0.0);
    cells.shape.assign(padded(grid.cells()), 0);
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
        std::size_t shape = 0;
        for (std::size_t k = 0; k < function.shape.size(); ++k)
            shape = shape * grid.parameter(k).values.size() + grid.indexOf(k, cell);
        for (std::size_t k = 0; k < function.shape.size(); ++k)
            cells.shapes[shape][k] = grid.value(k, cell);
        std::vector<double> asymptotes;
        for (std::size_t k = function.shape.size(); k < grid.parameters(); ++k)
            asymptotes.push_back(grid.value(k, cell));
        cells.base[cell] = function.base(asymptotes.data());
        cells.scale[cell] = function.scale(asymptotes.data());
        cells.shape[cell] = static_cast<std::uint32_t>(shape);
    }
    return cells;
}

/// Tables that store F once per shape and not once per cell: with P = Σ base p + Σ_shape F Σ scale p, only M
/// has stimuli × cells entries. M is stored as the sum of two floats. The high halves alone bound every gain
/// and so show which stimuli can be among the best two; only those are summed in full.
class PsychometricTables final : public OutcomeTables {
public:
    PsychometricTables(const PsychometricFunction& function, const std::vector<Stimulus>& stimuli,
                       const PosteriorGrid& grid)
        : m_cells(cellsOf(function, grid)), m_stimuli(stimuli.size()), m_row(m_cells.base.size()),
          m_shapes(padded(m_cells.shapes.size())), m_inner(grid.cells() / m_cells.shapes.size()),
          m_f(m_stimuli * m_shapes, 0.0), m_roughF(m_stimuli * m_shapes, 0.0F),
          m_high(m_stimuli * m_row, 0.0F), m_low(m_stimuli * m_row, 0.0F) {
        for (std::size_t x = 0; x < m_stimuli; ++x) {
            double* f = &m_f[x * m_shapes];
            for (std::size_t s = 0; s < m_cells.shapes.size(); ++s)
                f[s] = function.f(stimuli[x].data(), m_cells.shapes[s].data());
            std::transform(f, f + m_shapes, &m_roughF[x * m_shapes],
                           [](double value) { return static_cast<float>(value); });
            for (std::size_t c = 0; c < grid.cells(); ++c) {
                const double p = probability(x, c);
                const double m = xLogX(p) + xLogX(1.0 - p);
                m_high[x * m_row + c] = static_cast<float>(m);
                m_low[x * m_row + c] = static_cast<float>(m - static_cast<double>(m_high[x * m_row + c]));
            }
        }
    }

    bool finite() const {
        return std::all_of(m_f.begin(), m_f.end(), [](double f) { return f >= 0.0 && f <= 1.0; });
    }

    int outcomes() const noexcept override { return 2; }
    std::size_t stimuli() const noexcept override { return m_stimuli; }

    std::vector<double> gains(const PosteriorGrid& posterior) const override {
        if (posterior.hasNuisance())
            return marginalGains(posterior);
        const Shapes shapes = shapesOf(posterior);
        std::vector<double> gains(m_stimuli);
        for (std::size_t x = 0; x < m_stimuli; ++x)
            gains[x] = gain(posterior, shapes, x);
        return gains;
    }

    BestStimulus best(const PosteriorGrid& posterior, const Rows& excluded) const override {
        if (posterior.hasNuisance())
            return bestOf(marginalGains(posterior), excluded);
        const Shapes shapes = shapesOf(posterior);
        std::vector<Bounds> bounds = roughGains(posterior, shapes);
        for (const int row : excluded)
            bounds[static_cast<std::size_t>(row)] = {kNone, kNone};
        double least = kNone;
        double second = kNone; // second smallest of the upper bounds: two stimuli are at least this good
        for (const Bounds& bound : bounds) {
            second = std::min(second, std::max(bound.high, least));
            least = std::min(least, bound.high);
        }
        std::vector<double> gains(m_stimuli, kNone);
        for (std::size_t x = 0; x < m_stimuli; ++x)
            if (bounds[x].low <= second + kEntropyTie)
                gains[x] = gain(posterior, shapes, x);
        return bestOf(std::move(gains), excluded);
    }

    void likelihood(std::size_t stimulus, int outcome, std::vector<double>& to) const override {
        to.resize(m_row);
        const double* f = &m_f[stimulus * m_shapes];
        for (std::size_t c = 0; c < m_row; ++c) {
            const double p = std::min(m_cells.base[c] + m_cells.scale[c] * f[m_cells.shape[c]], 1.0);
            to[c] = outcome == 1 ? p : 1.0 - p;
        }
    }

private:
    static constexpr double kNone = std::numeric_limits<double>::infinity();

    struct Bounds {
        double low, high;
    };

    /// The posterior summed by shape: P_1(x) = base + Σ_shape weight F(x, shape).
    struct Shapes {
        double base = 0.0;
        std::vector<double> weight;
        ActiveBlocks active;
    };

    double probability(std::size_t x, std::size_t c) const {
        return std::min(m_cells.base[c] + m_cells.scale[c] * m_f[x * m_shapes + m_cells.shape[c]], 1.0);
    }

    /// Without nuisance parameters the asymptotes are innermost, so that the cells of a shape are neighbours.
    Shapes shapesOf(const PosteriorGrid& posterior) const {
        const double* p = posterior.probability().data();
        Shapes shapes;
        shapes.weight.assign(m_shapes, 0.0);
        for (std::size_t s = 0, c = 0; s < m_cells.shapes.size(); ++s)
            for (const std::size_t end = c + m_inner; c < end; ++c)
                shapes.weight[s] += p[c] * m_cells.scale[c];
        shapes.base = blockedDot(p, m_cells.base.data(), posterior.active());
        for (std::size_t first = 0; first < m_shapes; first += kBlock)
            if (blockedSum(&shapes.weight[first], kBlock) > 1e-17)
                shapes.active.push_back(static_cast<std::uint32_t>(first / kBlock));
        return shapes;
    }

    double gain(const PosteriorGrid& posterior, const Shapes& shapes, std::size_t x) const {
        const double one =
            std::min(shapes.base + blockedDot(shapes.weight.data(), &m_f[x * m_shapes], shapes.active), 1.0);
        return xLogX(one) + xLogX(1.0 - one) -
               blockedDot(posterior.probability().data(), &m_high[x * m_row], &m_low[x * m_row],
                          posterior.active());
    }

    /// Bounds every gain, in single precision and without the nearly impossible cells. M lies in -ln 2..0. P
    /// ln P + (1-P) ln (1-P) changes with the logit of P; P is kept at least the error away from 0 and 1, and
    /// the bound is doubled to cover the curvature.
    std::vector<Bounds> roughGains(const PosteriorGrid& posterior, const Shapes& shapes) const {
        const std::vector<float> p(posterior.probability().begin(), posterior.probability().end());
        const std::vector<float> weight(shapes.weight.begin(), shapes.weight.end());
        const double error = kRoughError + posterior.roughlyLeftOut();
        std::vector<Bounds> bounds(m_stimuli);
        for (std::size_t x = 0; x < m_stimuli; ++x) {
            const double one =
                std::clamp(shapes.base + roughDot(weight.data(), &m_roughF[x * m_shapes], shapes.active),
                           error, 1.0 - error);
            const double gain = xLogX(one) + xLogX(1.0 - one) -
                                roughDot(p.data(), &m_high[x * m_row], posterior.roughlyActive());
            const double off = 2.0 * error * (std::abs(std::log(one / (1.0 - one))) + 2.0);
            bounds[x] = {gain - off, gain + off};
        }
        return bounds;
    }

    Cells m_cells;
    std::size_t m_stimuli;
    std::size_t m_row;       ///< cells, padded
    std::size_t m_shapes;    ///< padded
    std::size_t m_inner;     ///< cells per shape
    std::vector<double> m_f; ///< F: [stimulus][shape]
    std::vector<float> m_roughF;
    std::vector<float> m_high, m_low; ///< M, [stimulus][cell], is their sum
};

/// Checks that the grid lies where F is defined, for functions that are not defined everywhere.
core::Result<void> checkShape(const PsychometricFunction& function, const PosteriorGrid& grid) {
    for (std::size_t k = 0; k < function.shape.size(); ++k)
        for (const double value : grid.parameter(k).values)
            if (!(value > 0.0) && (function.shape[k] == "sd" ||
                                   (function.positiveStimulus && function.shape[k] == "threshold")))
                return fail(ErrorCode::badInput, "parameters: " + grid.parameter(k).name +
                                                     ": expected values above 0 with the function " +
                                                     std::string(function.name));
    return {};
}

core::Result<void> checkAsymptotes(const PsychometricFunction& function, const PosteriorGrid& grid) {
    std::vector<double> highest;
    for (std::size_t k = function.shape.size(); k < grid.parameters(); ++k) {
        const std::vector<double>& values = grid.parameter(k).values;
        if (std::any_of(values.begin(), values.end(), [](double a) { return a < 0.0 || a > 1.0; }))
            return fail(ErrorCode::badInput,
                        "parameters: " + grid.parameter(k).name + ": expected values in 0..1");
        highest.push_back(*std::max_element(values.begin(), values.end()));
    }
    if (function.scale(highest.data()) >= 0.0)
        return {};
    return fail(
        ErrorCode::badInput,
        highest.size() > 1
            ? "parameters: lapse_rate: expected values that come to at most 1 with those of lower_asymptote"
            : "parameters: lapse_rate: expected values of at most 0.5");
}

} // namespace

core::Result<std::shared_ptr<const OutcomeTables>> psychometricTables(const PsychometricFunction& function,
                                                                      const std::vector<Stimulus>& stimuli,
                                                                      const PosteriorGrid& grid) {
    CHIRON_TRY(checkShape(function, grid));
    CHIRON_TRY(checkAsymptotes(function, grid));
    auto tables = std::make_shared<PsychometricTables>(function, stimuli, grid);
    if (!tables->finite())
        return fail(ErrorCode::badInput,
                    "function: " + std::string(function.name) +
                        ": expected one that is a probability for all parameters and stimuli");
    return tables;
}

} // namespace chiron::psychophysics
