// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/posterior_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

constexpr double kNegligible = 1e-17; ///< for a block, in full sums
/// For all omitted blocks together, in the selection of what to sum in full.
constexpr double kRoughlyNegligible = 1e-7;
constexpr std::size_t kMostCells = 4'000'000;

core::Result<void> checkGrid(const ParameterGrid& grid) {
    const auto bad = [&grid](const char* what) {
        return fail(ErrorCode::badInput, "parameters: " + grid.name + ": " + what);
    };
    if (grid.values.empty())
        return bad("expected at least one value");
    if (!std::all_of(grid.values.begin(), grid.values.end(), [](double v) { return std::isfinite(v); }))
        return bad("expected finite values");
    if (grid.prior.empty())
        return {};
    if (grid.prior.size() != grid.values.size())
        return bad("prior: expected as many numbers as values");
    double sum = 0.0;
    for (const double p : grid.prior) {
        if (!std::isfinite(p) || p < 0.0)
            return bad("prior: expected finite numbers of at least 0");
        sum += p;
    }
    if (!(sum > 0.0) || !std::isfinite(sum))
        return bad("prior: expected a positive number somewhere");
    return {};
}

using Bars = std::vector<std::pair<double, double>>; ///< value and its probability, ordered by value

/// Returns the quantile for a cumulative share, with each value's probability spread evenly between the
/// midpoints to its neighbours.
double barQuantile(const Bars& bars, double share) {
    double below = 0.0;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const auto [value, p] = bars[i];
        if (below + p >= share && p > 0.0) {
            const double low = i == 0 ? value : 0.5 * (bars[i - 1].first + value);
            const double high = i + 1 == bars.size() ? value : 0.5 * (value + bars[i + 1].first);
            return low + (high - low) * std::clamp((share - below) / p, 0.0, 1.0);
        }
        below += p;
    }
    return bars.back().first;
}

} // namespace

core::Result<PosteriorGrid> PosteriorGrid::make(const std::vector<ParameterGrid>& parameters) {
    if (parameters.empty())
        return fail(ErrorCode::badInput, "parameters: expected at least one");
    PosteriorGrid grid;
    grid.m_parameters = parameters;
    for (const ParameterGrid& parameter : parameters) {
        CHIRON_TRY(checkGrid(parameter));
        if (parameter.values.size() > kMostCells / grid.m_cells)
            return fail(ErrorCode::badInput,
                        "parameters: more than " + std::to_string(kMostCells) + " cells: expected fewer");
        grid.m_cells *= parameter.values.size();
    }
    grid.m_strides.resize(parameters.size());
    std::size_t stride = 1;
    for (const bool nuisance : {true, false}) {
        for (std::size_t k = parameters.size(); k-- > 0;)
            if (parameters[k].nuisance == nuisance) {
                grid.m_strides[k] = stride;
                stride *= parameters[k].values.size();
            }
        if (nuisance)
            grid.m_nuisanceCells = stride;
    }
    if (!std::any_of(parameters.begin(), parameters.end(),
                     [](const ParameterGrid& p) { return !p.nuisance; }))
        return fail(ErrorCode::badInput, "parameters: expected at least one that is no nuisance");
    grid.m_prior.assign(padded(grid.m_cells), 0.0);
    for (std::size_t cell = 0; cell < grid.m_cells; ++cell) {
        double p = 1.0;
        for (std::size_t k = 0; k < parameters.size(); ++k)
            if (!parameters[k].prior.empty())
                p *= parameters[k].prior[grid.indexOf(k, cell)];
        grid.m_prior[cell] = p;
    }
    const double sum = blockedSum(grid.m_prior.data(), grid.m_prior.size());
    if (!(sum > 0.0) || !std::isfinite(sum))
        return fail(ErrorCode::badInput,
                    "parameters: priors whose product is out of range: expected scales near 1");
    for (double& p : grid.m_prior)
        p /= sum;
    grid.restart();
    return grid;
}

bool PosteriorGrid::hasNuisance() const noexcept {
    return std::any_of(m_parameters.begin(), m_parameters.end(),
                       [](const ParameterGrid& p) { return p.nuisance; });
}

void PosteriorGrid::restart() {
    m_probability = m_prior;
    findActive();
}

bool PosteriorGrid::update(const std::vector<double>& likelihood) {
    const double sum = blockedDot(m_probability.data(), likelihood.data(), m_probability.size());
    if (!(sum > 0.0))
        return false;
    const double scale = 1.0 / sum;
    for (std::size_t i = 0; i < m_probability.size(); ++i) {
        const double p = m_probability[i] * likelihood[i] * scale;
        // Smaller (denormal) numbers are slow and irrelevant.
        m_probability[i] = p < std::numeric_limits<double>::min() ? 0.0 : p;
    }
    findActive();
    return true;
}

void PosteriorGrid::findActive() {
    m_active.clear();
    m_roughlyActive.clear();
    m_roughlyLeftOut = 0.0;
    const double small =
        kRoughlyNegligible * static_cast<double>(kBlock) / static_cast<double>(m_probability.size());
    for (std::size_t first = 0; first < m_probability.size(); first += kBlock) {
        const double sum = blockedSum(&m_probability[first], kBlock);
        const auto block = static_cast<std::uint32_t>(first / kBlock);
        if (sum > kNegligible)
            m_active.push_back(block);
        if (sum > small)
            m_roughlyActive.push_back(block);
        else
            m_roughlyLeftOut += sum;
    }
}

std::vector<double> PosteriorGrid::marginal(std::size_t k) const {
    const std::size_t stride = m_strides[k];
    const std::size_t count = m_parameters[k].values.size();
    std::vector<double> sums(count, 0.0);
    for (std::size_t first = 0; first < m_cells; first += stride)
        for (std::size_t i = first; i < first + stride; ++i)
            sums[first / stride % count] += m_probability[i];
    return sums;
}

double PosteriorGrid::sd(std::size_t k) const {
    return estimate(k).sd;
}

NamedEstimate PosteriorGrid::estimate(std::size_t k) const {
    const std::vector<double> p = marginal(k);
    const std::vector<double>& values = m_parameters[k].values;
    double mean = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i)
        mean += p[i] * values[i];
    double variance = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i)
        variance += p[i] * (values[i] - mean) * (values[i] - mean);
    Bars bars;
    for (std::size_t i = 0; i < p.size(); ++i)
        bars.emplace_back(values[i], p[i]);
    std::sort(bars.begin(), bars.end());
    const double least =
        kAtGridEdge * std::max_element(bars.begin(), bars.end(), [](const auto& a, const auto& b) {
                          return a.second < b.second;
                      })->second;
    const bool wide = bars.size() > 2;
    return {m_parameters[k].name,
            mean,
            std::sqrt(variance),
            barQuantile(bars, 0.025),
            barQuantile(bars, 0.975),
            value(k, mode()),
            wide && bars.front().second >= least,
            wide && bars.back().second >= least};
}

double PosteriorGrid::entropy() const {
    double sum = 0.0;
    for (std::size_t first = 0; first < m_cells; first += m_nuisanceCells) {
        double p = 0.0;
        for (std::size_t i = first; i < first + m_nuisanceCells; ++i)
            p += m_probability[i];
        sum += p > 0.0 ? p * std::log(p) : 0.0;
    }
    return -sum;
}

std::size_t PosteriorGrid::mode() const {
    return static_cast<std::size_t>(
        std::max_element(m_probability.begin(),
                         m_probability.begin() + static_cast<std::ptrdiff_t>(m_cells)) -
        m_probability.begin());
}

} // namespace chiron::psychophysics
