// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/dense_solve.h"
#include "psychophysics/measures/pairwise_ranking.h"
#include "psychophysics/measures/win_graph.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

namespace {

std::size_t indexOf(int object) {
    return static_cast<std::size_t>(object);
}

bool isUsable(const Selection& selection, int objects) {
    std::vector<int> set = selection.losers;
    set.push_back(selection.winner);
    std::sort(set.begin(), set.end());
    return !selection.losers.empty() && set.front() >= 0 && set.back() < objects &&
           std::adjacent_find(set.begin(), set.end()) == set.end() && selection.count > 0.0 &&
           std::isfinite(selection.count);
}

/// Returns one over the sum of the worths in a selection.
double shareOf(const Selection& selection, const std::vector<double>& worth) {
    double sum = worth[indexOf(selection.winner)];
    for (const int loser : selection.losers)
        sum += worth[indexOf(loser)];
    return 1.0 / sum;
}

template <class Function> void forEachOf(const Selection& selection, Function&& f) {
    f(indexOf(selection.winner));
    for (const int loser : selection.losers)
        f(indexOf(loser));
}

void centre(std::vector<double>& logs) {
    double sum = 0.0;
    for (const double value : logs)
        sum += value;
    for (double& value : logs)
        value -= sum / static_cast<double>(logs.size());
}

std::vector<double> worthsOf(const std::vector<double>& logs) {
    std::vector<double> worth(logs.size());
    std::transform(logs.begin(), logs.end(), worth.begin(), [](double value) { return std::exp(value); });
    return worth;
}

/// Takes one step of Hunter (2004), eq. 31: γ_i = wins_i / Σ over selections with i of 1/Σγ. Returns the
/// largest change of ln γ.
double improve(std::vector<double>& logs, const std::vector<Selection>& selections) {
    const std::vector<double> worth = worthsOf(logs);
    std::vector<double> wins(logs.size(), 0.0);
    std::vector<double> below(logs.size(), 0.0);
    for (const Selection& selection : selections) {
        const double share = selection.count * shareOf(selection, worth);
        wins[indexOf(selection.winner)] += selection.count;
        forEachOf(selection, [&](std::size_t i) { below[i] += share; });
    }
    std::vector<double> next(logs.size());
    for (std::size_t i = 0; i < logs.size(); ++i)
        next[i] = std::log(wins[i] / below[i]);
    centre(next);
    double change = 0.0;
    for (std::size_t i = 0; i < logs.size(); ++i)
        change = std::max(change, std::abs(next[i] - logs[i]));
    logs = std::move(next);
    return change;
}

struct Curvature {
    std::vector<double> gradient;
    Matrix information; ///< negative Hessian of the log-likelihood in ln γ; the vector of ones is its null
                        ///< vector
};

Curvature curvatureAt(const std::vector<double>& logs, const std::vector<Selection>& selections) {
    const std::vector<double> worth = worthsOf(logs);
    Curvature c{std::vector<double>(logs.size(), 0.0),
                Matrix(logs.size(), std::vector<double>(logs.size(), 0.0))};
    for (const Selection& selection : selections) {
        const double share = shareOf(selection, worth);
        c.gradient[indexOf(selection.winner)] += selection.count;
        forEachOf(selection, [&](std::size_t i) {
            const double p = worth[i] * share;
            c.gradient[i] -= selection.count * p;
            c.information[i][i] += selection.count * p;
            forEachOf(selection,
                      [&](std::size_t j) { c.information[i][j] -= selection.count * p * worth[j] * share; });
        });
    }
    return c;
}

/// Returns the covariance of the centred ln γ: the pseudo-inverse, computed by adding a multiple of the null
/// vector's projector.
Matrix covarianceOf(Matrix information) {
    const double each = 1.0 / static_cast<double>(information.size());
    for (auto& row : information)
        for (double& value : row)
            value += each;
    Matrix covariance = inverseOf(std::move(information));
    for (auto& row : covariance)
        for (double& value : row)
            value -= each;
    return covariance;
}

/// Takes Newton steps close to the maximum as long as they shrink the gradient.
void polish(std::vector<double>& logs, const std::vector<Selection>& selections) {
    const auto size = [](const std::vector<double>& v) {
        double largest = 0.0;
        for (const double value : v)
            largest = std::max(largest, std::abs(value));
        return largest;
    };
    Curvature here = curvatureAt(logs, selections);
    for (int step = 0; step < 20; ++step) {
        const Matrix covariance = covarianceOf(here.information);
        if (covariance.empty())
            return;
        std::vector<double> next = logs;
        for (std::size_t i = 0; i < next.size(); ++i)
            for (std::size_t j = 0; j < next.size(); ++j)
                next[i] += covariance[i][j] * here.gradient[j];
        centre(next);
        Curvature there = curvatureAt(next, selections);
        if (!(size(there.gradient) < size(here.gradient)))
            return;
        logs = std::move(next);
        here = std::move(there);
    }
}

void finish(WorthEstimate& result, const std::vector<Selection>& fittedTo,
            const std::vector<Selection>& data) {
    const Matrix covariance = covarianceOf(curvatureAt(result.logWorth, fittedTo).information);
    for (std::size_t i = 0; i < covariance.size(); ++i)
        result.standardError[i] = std::sqrt(std::max(0.0, covariance[i][i]));
    const std::vector<double> worth = worthsOf(result.logWorth);
    result.logLikelihood = 0.0;
    for (const Selection& selection : data)
        result.logLikelihood += selection.count * (result.logWorth[indexOf(selection.winner)] +
                                                   std::log(shareOf(selection, worth)));
    result.fitted = true;
}

/// Selects the usable data, and adds the wins of the regularisation to `all`. Returns false, with a warning,
/// if they cannot be fitted.
bool prepare(WorthEstimate& result, int objects, const std::vector<Selection>& given, double regularisation,
             std::vector<Selection>& data, std::vector<Selection>& all) {
    std::copy_if(given.begin(), given.end(), std::back_inserter(data),
                 [&](const Selection& s) { return isUsable(s, objects); });
    if (data.size() < given.size())
        result.warnings.push_back(
            "left_out: " + std::to_string(given.size() - data.size()) +
            " choices name unknown or repeated objects, or are counted by no number above zero");
    if (objects < 2 || (data.empty() && !(regularisation > 0.0))) {
        result.warnings.emplace_back("no_data: there is nothing to estimate from");
        return false;
    }
    WinGraph graph(objects);
    for (const Selection& selection : data)
        for (const int loser : selection.losers)
            graph.add(selection.winner, loser);
    const bool connected = graph.isStronglyConnected();
    all = data;
    if (regularisation > 0.0) {
        for (int winner = 0; winner < objects; ++winner)
            for (int loser = 0; loser < objects; ++loser)
                if (winner != loser)
                    all.push_back({winner, {loser}, regularisation});
        result.warnings.emplace_back(
            "regularised: wins of every object over every other were added; worths are pulled together");
    }
    if (!connected && !(regularisation > 0.0))
        result.warnings.emplace_back("not_connected: some objects never came before (or after) the others, "
                                     "so their worth has no limit; "
                                     "refused: ask for regularisation or more comparisons");
    return connected || regularisation > 0.0;
}

} // namespace

std::vector<Selection> selectionsOf(const std::vector<int>& bestFirst, double count) {
    std::vector<Selection> result;
    for (std::size_t i = 0; i + 1 < bestFirst.size(); ++i)
        result.push_back(
            {bestFirst[i], {bestFirst.begin() + static_cast<std::ptrdiff_t>(i) + 1, bestFirst.end()}, count});
    return result;
}

WorthEstimate fitPlackettLuce(int objects, const std::vector<Selection>& selections,
                              const WorthOptions& options) {
    WorthEstimate result;
    const std::size_t n = objects > 0 ? static_cast<std::size_t>(objects) : 0;
    result.logWorth.assign(n, std::numeric_limits<double>::quiet_NaN());
    result.standardError = result.logWorth;
    std::vector<Selection> data;
    std::vector<Selection> all;
    if (!prepare(result, objects, selections, options.regularisation, data, all))
        return result;
    std::vector<double> logs(n, 0.0);
    double change = 1.0;
    while (change > 1e-6 && result.iterations < options.mostIterations) {
        change = improve(logs, all);
        ++result.iterations;
    }
    if (!std::all_of(logs.begin(), logs.end(), [](double value) { return std::isfinite(value); })) {
        result.warnings.emplace_back("not_converged: the worths left the numbers a computer holds");
        return result;
    }
    if (change > 1e-6)
        result.warnings.emplace_back("not_converged: the steps did not settle; worths may be off");
    polish(logs, all);
    result.logWorth = std::move(logs);
    finish(result, all, data);
    return result;
}

} // namespace chiron::psychophysics
