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

class GeneralTables final : public OutcomeTables {
public:
    GeneralTables(const std::vector<std::vector<std::vector<double>>>& probabilities, std::size_t cells)
        : m_outcomes(probabilities.size()), m_stimuli(probabilities.front().size()), m_row(padded(cells)),
          m_likelihood(m_outcomes * m_stimuli * m_row, 0.0), m_entropy(m_stimuli * m_row, 0.0) {
        for (std::size_t r = 0; r < m_outcomes; ++r)
            for (std::size_t x = 0; x < m_stimuli; ++x)
                for (std::size_t c = 0; c < cells; ++c) {
                    const double p = probabilities[r][x][c];
                    m_likelihood[(r * m_stimuli + x) * m_row + c] = p;
                    m_entropy[x * m_row + c] += xLogX(p);
                }
    }

    int outcomes() const noexcept override { return static_cast<int>(m_outcomes); }
    std::size_t stimuli() const noexcept override { return m_stimuli; }

    std::vector<double> gains(const PosteriorGrid& posterior) const override {
        if (posterior.hasNuisance())
            return marginalGains(posterior);
        const double* p = posterior.probability().data();
        std::vector<double> gains(m_stimuli);
        for (std::size_t x = 0; x < m_stimuli; ++x) {
            double sum = -blockedDot(p, &m_entropy[x * m_row], posterior.active());
            for (std::size_t r = 0; r < m_outcomes; ++r)
                sum += xLogX(blockedDot(p, &m_likelihood[(r * m_stimuli + x) * m_row], posterior.active()));
            gains[x] = sum;
        }
        return gains;
    }

    void likelihood(std::size_t stimulus, int outcome, std::vector<double>& to) const override {
        const auto from =
            m_likelihood.begin() +
            static_cast<std::ptrdiff_t>((static_cast<std::size_t>(outcome) * m_stimuli + stimulus) * m_row);
        to.assign(from, from + static_cast<std::ptrdiff_t>(m_row));
    }

private:
    std::size_t m_outcomes;
    std::size_t m_stimuli;
    std::size_t m_row;
    std::vector<double> m_likelihood; ///< [outcome][stimulus][cell]
    std::vector<double> m_entropy;    ///< M: [stimulus][cell]
};

} // namespace

BestStimulus bestOf(std::vector<double> gains, const Rows& excluded) {
    const double none = std::numeric_limits<double>::infinity();
    for (const int row : excluded)
        gains[static_cast<std::size_t>(row)] = none;
    double least = none;
    double second = none;
    for (std::size_t x = 0; x < gains.size(); ++x) {
        second = std::min(second, std::max(gains[x], least));
        least = std::min(least, gains[x]);
    }
    BestStimulus best;
    for (std::size_t x = 0; x < gains.size() && best.index < 0; ++x)
        if (gains[x] <= least + kEntropyTie && gains[x] < none)
            best = {static_cast<int>(x), least, second < none ? second - least : best.margin};
    return best;
}

BestStimulus OutcomeTables::best(const PosteriorGrid& posterior, const Rows& excluded) const {
    return bestOf(gains(posterior), excluded);
}

std::vector<double> OutcomeTables::marginalGains(const PosteriorGrid& posterior) const {
    const std::vector<double>& p = posterior.probability();
    const std::size_t inner = posterior.nuisanceCells();
    std::vector<double> gains(stimuli(), 0.0);
    std::vector<double> likelihoods;
    for (std::size_t x = 0; x < gains.size(); ++x)
        for (int r = 0; r < outcomes(); ++r) {
            likelihood(x, r, likelihoods);
            double total = 0.0;
            for (std::size_t first = 0; first < posterior.cells(); first += inner) {
                double joint = 0.0;
                for (std::size_t i = first; i < first + inner; ++i)
                    joint += p[i] * likelihoods[i];
                total += joint;
                gains[x] -= xLogX(joint);
            }
            gains[x] += xLogX(total);
        }
    const double now = posterior.entropy();
    for (double& gain : gains)
        gain -= now;
    return gains;
}

core::Result<std::shared_ptr<const OutcomeTables>>
generalTables(const std::vector<std::vector<std::vector<double>>>& probabilities, const PosteriorGrid& grid) {
    const auto bad = [](const std::string& what) { return fail(ErrorCode::badInput, "table: " + what); };
    if (probabilities.size() < 2 || probabilities.front().empty())
        return bad("expected at least two outcomes and one stimulus");
    for (const auto& outcome : probabilities) {
        if (outcome.size() != probabilities.front().size())
            return bad("expected as many stimuli for every outcome");
        for (const auto& cells : outcome)
            if (cells.size() != grid.cells())
                return bad(std::to_string(cells.size()) + " cells: expected " + std::to_string(grid.cells()));
    }
    for (std::size_t x = 0; x < probabilities.front().size(); ++x)
        for (std::size_t c = 0; c < grid.cells(); ++c) {
            double sum = 0.0;
            for (const auto& outcome : probabilities) {
                if (!(outcome[x][c] >= 0.0))
                    return bad("a probability that is negative or not a number: expected shares from 0 to 1");
                sum += outcome[x][c];
            }
            if (std::abs(sum - 1.0) > 1e-9)
                return bad("stimulus " + std::to_string(x) + ", cell " + std::to_string(c) +
                           ": probabilities sum to " + std::to_string(sum) + ": expected 1");
        }
    return std::make_shared<GeneralTables>(probabilities, grid.cells());
}

} // namespace chiron::psychophysics
