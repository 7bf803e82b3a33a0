// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/thurstone_posterior.h"

#include "core/normal_distribution.h"
#include "psychophysics/measures/discrimination.h"
#include "psychophysics/observers/tied_orders.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace chiron::psychophysics {

namespace {

using core::normalCumulative;

constexpr double kLargestLapse = 0.3;
constexpr int kMostPasses = 8;
constexpr double kLapsePriorPower = 29.0; // Beta(1, 30): (1 − λ)^29

/// Equal cells from low to high; at(i) is the middle of a cell.
struct Axis {
    double low = 0.0;
    double high = 0.0;
    std::size_t cells = 1;

    double width() const { return (high - low) / static_cast<double>(cells); }
    double at(std::size_t i) const { return low + (static_cast<double>(i) + 0.5) * width(); }
};

/// Weights over (σ, criterion, lapse), with the last index fastest; the largest weight is 1. The lapse axis
/// holds √λ, so that cells are fine near 0.
struct Grid {
    Axis sigma, criterion, lapse;
    std::vector<double> weight;

    std::size_t cell(std::size_t s, std::size_t c) const { return (s * criterion.cells + c) * lapse.cells; }
    double lapseAt(std::size_t l) const { return lapse.at(l) * lapse.at(l); }
    ThurstonePoint point(std::size_t i) const {
        return {sigma.at(i / (criterion.cells * lapse.cells)), lapseAt(i % lapse.cells),
                criterion.at(i / lapse.cells % criterion.cells)};
    }
};

/// Proportion correct from a table, for speed: cubic interpolation over d = 0..16 in steps of 1/40.
class CorrectTable {
public:
    explicit CorrectTable(DiscriminationTask task) {
        for (int i = -1; i <= kEnd * kPerUnit + 2; ++i)
            m_value.push_back(proportionCorrect(task, static_cast<double>(i) / kPerUnit));
    }
    double at(double d) const {
        if (!(d < kEnd))
            return 1.0;
        const double place = d * kPerUnit;
        const auto i = static_cast<std::size_t>(place);
        const double u = place - static_cast<double>(i);
        const double value = -u * (u - 1.0) * (u - 2.0) / 6.0 * m_value[i] +
                             (u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0 * m_value[i + 1] -
                             (u + 1.0) * u * (u - 2.0) / 2.0 * m_value[i + 2] +
                             (u + 1.0) * u * (u - 1.0) / 6.0 * m_value[i + 3];
        return std::min(1.0, value);
    }

private:
    static constexpr int kEnd = 16;
    static constexpr int kPerUnit = 40;
    std::vector<double> m_value;
};

double threeAfcCorrect(double d) {
    static const CorrectTable table{{Discrimination::mAfc, 3}};
    return d >= 0.0 ? table.at(d) : proportionCorrect({Discrimination::mAfc, 3}, d);
}

double oddityCorrect(double d) {
    static const CorrectTable table{{Discrimination::oddityDifferencing, 3}};
    return table.at(std::abs(d));
}

/// Returns the probability of an answer kind without lapses.
double attentive(Task task, double difference, int kind, double sigma, double criterion) noexcept {
    const double d = difference / sigma;
    double yes = 0.5; // probability of the kinds that end in 1
    switch (task) {
    case Task::rank3Ties:
        return kind == 0 ? rightOrderProbability(d, criterion)
                         : tiedRankProbabilities(
                               d, criterion)[static_cast<std::size_t>(std::clamp(kind, 0, kRankings - 1))];
    case Task::rank3:
        return tabulatedOrderProbabilities(d)[static_cast<std::size_t>(std::clamp(kind, 0, 5))];
    case Task::twoAfc:
        yes = normalCumulative(d / std::numbers::sqrt2);
        break;
    case Task::threeAfc:
        yes = threeAfcCorrect(d);
        break;
    case Task::oddity:
        yes = oddityCorrect(d);
        break;
    case Task::sameDifferent: {
        const double shown = kind >= 2 ? d : 0.0;
        yes = normalCumulative((shown - criterion) / std::numbers::sqrt2) +
              normalCumulative((-shown - criterion) / std::numbers::sqrt2);
        break;
    }
    case Task::yesNo:
        yes = normalCumulative(((kind >= 2 ? difference : 0.0) - criterion) / (std::numbers::sqrt2 * sigma));
        break;
    case Task::adjustment:
    case Task::magnitude:
        break;
    }
    return kind % 2 == 1 ? yes : 1.0 - yes;
}

/// Returns the probability of this answer kind by guessing.
double guessed(Task task, int kind) noexcept {
    const double share = 1.0 / answers(task);
    const bool rightOrWrong = task == Task::threeAfc || task == Task::oddity;
    return rightOrWrong && kind == 0 ? 1.0 - share : share;
}

/// Computes attentive() for many answers that share a criterion. Rankings with ties come from a table,
/// because each is an integral.
class Attentive {
public:
    Attentive(Task task, double criterion) : m_task(task), m_criterion(criterion) {
        if (task == Task::rank3Ties)
            m_ties.emplace(criterion);
    }
    double at(const AnswerCount& group, double sigma) const {
        if (m_ties)
            return m_ties->at(group.difference /
                              sigma)[static_cast<std::size_t>(std::clamp(group.kind, 0, kRankings - 1))];
        return attentive(m_task, group.difference, group.kind, sigma, m_criterion);
    }

private:
    Task m_task;
    double m_criterion;
    std::optional<TiedOrderTable> m_ties;
};

/// Returns ln of the prior's density of log10 σ, relative to its uniform part.
double logPrior(Task task, const ThurstonePrior& prior, double log10Sigma) noexcept {
    const double power = task == Task::oddity || task == Task::sameDifferent ? 2.0 : 1.0;
    return log10Sigma > prior.evenUpTo ? -power * std::numbers::ln10 * (log10Sigma - prior.evenUpTo) : 0.0;
}

void fill(Grid& grid, Task task, const std::vector<AnswerCount>& counts, const ThurstonePrior& prior) {
    std::vector<double> logWeight(grid.sigma.cells * grid.criterion.cells * grid.lapse.cells, 0.0);
    for (std::size_t c = 0; c < grid.criterion.cells; ++c) {
        const Attentive observer(task, grid.criterion.at(c));
        for (std::size_t s = 0; s < grid.sigma.cells; ++s) {
            const double sigma = std::pow(10.0, grid.sigma.at(s));
            for (const AnswerCount& group : counts) {
                const double p = observer.at(group, sigma);
                const double guess = guessed(task, group.kind);
                for (std::size_t l = 0; l < grid.lapse.cells; ++l)
                    logWeight[grid.cell(s, c) + l] +=
                        group.count * std::log(std::max(1e-300, p + grid.lapseAt(l) * (guess - p)));
            }
        }
    }
    for (std::size_t i = 0; i < logWeight.size(); ++i) {
        const std::size_t l = i % grid.lapse.cells;
        logWeight[i] +=
            kLapsePriorPower * std::log1p(-grid.lapseAt(l)) + std::log(grid.lapse.at(l)); // dλ = 2√λ d√λ
        logWeight[i] += logPrior(task, prior, grid.sigma.at(i / (grid.criterion.cells * grid.lapse.cells)));
    }
    const double largest = *std::max_element(logWeight.begin(), logWeight.end());
    grid.weight.resize(logWeight.size());
    std::transform(logWeight.begin(), logWeight.end(), grid.weight.begin(),
                   [&](double w) { return std::exp(w - largest); });
}

/// Sums over all coordinates but one.
struct Marginals {
    std::vector<double> sigma, criterion, lapse;
    double total = 0.0;
};

Marginals marginalsOf(const Grid& grid) {
    Marginals m{std::vector<double>(grid.sigma.cells), std::vector<double>(grid.criterion.cells),
                std::vector<double>(grid.lapse.cells)};
    for (std::size_t s = 0; s < grid.sigma.cells; ++s)
        for (std::size_t c = 0; c < grid.criterion.cells; ++c)
            for (std::size_t l = 0; l < grid.lapse.cells; ++l) {
                const double w = grid.weight[grid.cell(s, c) + l];
                m.sigma[s] += w;
                m.criterion[c] += w;
                m.lapse[l] += w;
                m.total += w;
            }
    return m;
}

/// Returns the part of an axis that holds all but a negligible weight, plus one cell at each end.
Axis narrowed(const Axis& axis, const std::vector<double>& marginal, std::size_t cells) {
    const double least = 1e-7 * *std::max_element(marginal.begin(), marginal.end());
    std::size_t first = 0;
    std::size_t last = axis.cells - 1;
    while (first < last && marginal[first] < least)
        ++first;
    while (last > first && marginal[last] < least)
        --last;
    first -= first > 0 ? 1 : 0;
    last += last + 1 < axis.cells ? 1 : 0;
    return {axis.low + static_cast<double>(first) * axis.width(),
            axis.low + static_cast<double>(last + 1) * axis.width(), cells};
}

double quantile(const Axis& axis, const std::vector<double>& marginal, double total, double share) {
    double below = 0.0;
    for (std::size_t i = 0; i < marginal.size(); ++i) {
        const double target = share * total - below;
        if (target <= marginal[i] && marginal[i] > 0.0)
            return axis.low + (static_cast<double>(i) + target / marginal[i]) * axis.width();
        below += marginal[i];
    }
    return axis.high;
}

/// Computes successive grids, each where the previous one had weight, until the posterior fills enough of
/// each axis.
struct Refined {
    Grid grid;
    Marginals marginals;
};

Refined refined(Refined now, Task task, const std::vector<AnswerCount>& counts, const ThurstonePrior& prior,
                const Grid& cells) {
    const auto shrinks = [](const Axis& next, const Axis& last, double share) {
        return next.high - next.low < share * (last.high - last.low);
    };
    for (int pass = 0; pass < kMostPasses; ++pass) {
        Grid next{narrowed(now.grid.sigma, now.marginals.sigma, cells.sigma.cells),
                  narrowed(now.grid.criterion, now.marginals.criterion, cells.criterion.cells),
                  narrowed(now.grid.lapse, now.marginals.lapse, cells.lapse.cells),
                  {}};
        if (pass > 0 && !shrinks(next.sigma, now.grid.sigma, 0.3) &&
            !shrinks(next.criterion, now.grid.criterion, 0.3) && !shrinks(next.lapse, now.grid.lapse, 0.4))
            break;
        fill(next, task, counts, prior);
        now.marginals = marginalsOf(next);
        now.grid = std::move(next);
    }
    return now;
}

void summarise(ThurstonePosterior& result, const Grid& grid, const Marginals& m) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t s = 0; s < m.sigma.size(); ++s) {
        sum += m.sigma[s] * grid.sigma.at(s);
        squares += m.sigma[s] * grid.sigma.at(s) * grid.sigma.at(s);
    }
    result.known = true;
    result.meanLog10Sigma = sum / m.total;
    result.sdLog10Sigma =
        std::sqrt(std::max(0.0, squares / m.total - result.meanLog10Sigma * result.meanLog10Sigma));
    result.medianLog10Sigma = quantile(grid.sigma, m.sigma, m.total, 0.5);
    result.lowLog10Sigma = quantile(grid.sigma, m.sigma, m.total, 0.025);
    result.highLog10Sigma = quantile(grid.sigma, m.sigma, m.total, 0.975);
    result.criterion = quantile(grid.criterion, m.criterion, m.total, 0.5);
    result.lowCriterion = quantile(grid.criterion, m.criterion, m.total, 0.025);
    result.highCriterion = quantile(grid.criterion, m.criterion, m.total, 0.975);
    result.meanLapse = 0.0;
    for (std::size_t l = 0; l < m.lapse.size(); ++l)
        result.meanLapse += m.lapse[l] / m.total * grid.lapseAt(l);
}

void draw(ThurstonePosterior& result, const Grid& grid, double total, int draws) {
    double below = 0.0;
    int next = 0;
    for (std::size_t i = 0; i < grid.weight.size() && next < draws; ++i) {
        below += grid.weight[i];
        for (; next < draws && (next + 0.5) / draws * total <= below; ++next)
            result.draws.push_back(grid.point(i));
    }
}

} // namespace

double priorLog10SigmaSd(Task task, const ThurstonePrior& prior) noexcept {
    const Axis axis{prior.lowLog10Sigma, prior.highLog10Sigma, 2000};
    double total = 0.0, sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < axis.cells; ++i) {
        const double weight = std::exp(logPrior(task, prior, axis.at(i)));
        total += weight;
        sum += weight * axis.at(i);
        squares += weight * axis.at(i) * axis.at(i);
    }
    return std::sqrt(std::max(0.0, squares / total - sum * sum / (total * total)));
}

double answerProbability(Task task, double difference, int kind, const ThurstonePoint& at) noexcept {
    const double p = attentive(task, difference, kind, std::pow(10.0, at.log10Sigma), at.criterion);
    return p + at.lapse * (guessed(task, kind) - p);
}

ThurstonePosterior thurstonePosterior(Task task, const std::vector<AnswerCount>& counts,
                                      const ThurstonePrior& prior, int draws) {
    ThurstonePosterior result;
    const bool answered =
        std::any_of(counts.begin(), counts.end(), [](const AnswerCount& group) { return group.count > 0.0; });
    if (!answered || task == Task::adjustment || task == Task::magnitude ||
        !(prior.highLog10Sigma > prior.lowLog10Sigma))
        return result;
    const bool hasCriterion = task == Task::yesNo || task == Task::sameDifferent || task == Task::rank3Ties;
    const std::size_t criteria = task == Task::rank3Ties ? 16 : hasCriterion ? 30 : 1;
    const double mostRootLapse = std::sqrt(kLargestLapse);
    Grid coarse{{prior.lowLog10Sigma, prior.highLog10Sigma, hasCriterion ? 40U : 60U},
                {prior.lowCriterion, prior.highCriterion, criteria},
                {0.0, mostRootLapse, 5},
                {}};
    ThurstonePrior even = prior;
    even.evenUpTo = std::numeric_limits<double>::infinity();
    fill(coarse, task, counts, even); // densities at the ends, determined by the answers alone
    Marginals rough = marginalsOf(coarse);
    const double peak = *std::max_element(rough.sigma.begin(), rough.sigma.end());
    result.densityAtLowSigma = rough.sigma.front() / peak;
    result.densityAtHighSigma = rough.sigma.back() / peak;
    Grid cells;
    cells.sigma.cells = hasCriterion ? 50 : 100;
    cells.criterion.cells = criteria;
    cells.lapse.cells = hasCriterion ? 10 : 15;
    const auto [fine, exact] = refined({std::move(coarse), std::move(rough)}, task, counts, prior, cells);
    summarise(result, fine, exact);
    draw(result, fine, exact.total, draws);
    return result;
}

} // namespace chiron::psychophysics
