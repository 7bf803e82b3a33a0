// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/normal_distribution.h"
#include "psychophysics/measures/dense_solve.h"
#include "psychophysics/measures/pairwise_ranking.h"
#include "psychophysics/measures/win_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace chiron::psychophysics {

namespace {

/// Returns all values from the free ones. The last object's value is not free, because it makes the mean 0.
std::vector<double> centredOf(const std::vector<double>& free, std::size_t objects) {
    std::vector<double> all(free.begin(), free.begin() + static_cast<std::ptrdiff_t>(objects) - 1);
    double sum = 0.0;
    for (const double value : all)
        sum += value;
    all.push_back(-sum);
    return all;
}

void takeWorths(WorthEstimate& result, const Maximum& best, std::size_t objects) {
    result.fitted = true;
    result.logWorth = centredOf(best.at, objects);
    result.logLikelihood = best.value;
    result.iterations = best.iterations;
    if (!best.found)
        result.warnings.emplace_back("not_converged: the steps did not settle; values may be off");
    if (best.covariance.empty())
        return;
    double all = 0.0;
    for (std::size_t i = 0; i + 1 < objects; ++i) {
        result.standardError[i] = std::sqrt(std::max(0.0, best.covariance[i][i]));
        for (std::size_t j = 0; j + 1 < objects; ++j)
            all += best.covariance[i][j];
    }
    result.standardError[objects - 1] = std::sqrt(std::max(0.0, all));
}

bool isUsablePair(const PairCount& pair, int objects) {
    const auto isCount = [](double n) { return n >= 0.0 && std::isfinite(n); };
    return pair.first >= 0 && pair.first < objects && pair.second >= 0 && pair.second < objects &&
           pair.first != pair.second && isCount(pair.wins) && isCount(pair.losses) && isCount(pair.ties);
}

double counted(double count, double probability) {
    return count > 0.0 ? count * std::log(std::max(1e-300, probability)) : 0.0;
}

double davidson(const std::vector<PairCount>& pairs, const std::vector<double>& logs, double tie) {
    double sum = 0.0;
    for (const PairCount& pair : pairs) {
        const double difference =
            logs[static_cast<std::size_t>(pair.first)] - logs[static_cast<std::size_t>(pair.second)];
        const double up = std::exp(0.5 * difference);
        const double all = up + 1.0 / up + std::exp(tie);
        sum += counted(pair.wins, up / all) + counted(pair.losses, 1.0 / up / all) +
               counted(pair.ties, std::exp(tie) / all);
    }
    return sum;
}

double raoKupper(const std::vector<PairCount>& pairs, const std::vector<double>& logs, double tie) {
    const double theta = 1.0 + std::exp(tie);
    double sum = 0.0;
    for (const PairCount& pair : pairs) {
        const double ratio = std::exp(logs[static_cast<std::size_t>(pair.first)] -
                                      logs[static_cast<std::size_t>(pair.second)]);
        const double win = ratio / (ratio + theta);
        const double loss = 1.0 / (1.0 + theta * ratio);
        sum += counted(pair.wins, win) + counted(pair.losses, loss) +
               counted(pair.ties, (theta * theta - 1.0) * win * loss);
    }
    return sum;
}

/// Returns the usable pairs; empty, with a warning, if they cannot be fitted.
std::vector<PairCount> preparePairs(TiedWorthEstimate& result, int objects,
                                    const std::vector<PairCount>& given) {
    std::vector<PairCount> pairs;
    std::copy_if(given.begin(), given.end(), std::back_inserter(pairs),
                 [&](const PairCount& p) { return isUsablePair(p, objects); });
    if (pairs.size() < given.size())
        result.warnings.push_back("left_out: " + std::to_string(given.size() - pairs.size()) +
                                  " pairs are not usable counts");
    if (objects < 2 || pairs.empty()) {
        result.warnings.emplace_back("no_data: there is nothing to estimate from");
        return {};
    }
    WinGraph graph(objects);
    double ties = 0.0;
    double decided = 0.0;
    for (const PairCount& pair : pairs) {
        ties += pair.ties;
        decided += pair.wins + pair.losses;
        if (pair.wins + pair.ties > 0.0)
            graph.add(pair.first, pair.second);
        if (pair.losses + pair.ties > 0.0)
            graph.add(pair.second, pair.first);
    }
    if (!(ties > 0.0) || !(decided > 0.0)) {
        result.warnings.emplace_back(ties > 0.0 ? "all_tied: every comparison was a tie"
                                                : "no_ties: nothing was tied; use the model without ties");
        return {};
    }
    if (!graph.isStronglyConnected()) {
        result.warnings.emplace_back(
            "not_connected: some objects never came before (or after) the others, so their worth has no "
            "limit; refused");
        return {};
    }
    return pairs;
}

/// Returns φ(z)/Φ(z), the slope of ln Φ.
double mills(double z) {
    constexpr double kFar = -30.0; // beyond it Φ loses all digits, and the series is exact to 1e-6
    if (z < kFar)
        return -z - 1.0 / z;
    return core::normalDensity(z) / core::normalCumulative(z);
}

/// Thurstone's case V for a table of wins: the log-likelihood with its first and second derivatives, over
/// scale values with mean 0.
class ProbitPairs {
public:
    ProbitPairs(std::size_t objects, const std::vector<Selection>& pairs)
        : m_wins(objects, std::vector<double>(objects, 0.0)) {
        for (const Selection& pair : pairs)
            m_wins[static_cast<std::size_t>(pair.winner)][static_cast<std::size_t>(pair.losers.front())] +=
                pair.count;
    }

    double value(const std::vector<double>& free) const {
        const std::vector<double> scale = centredOf(free, m_wins.size());
        double sum = 0.0;
        forEach([&](std::size_t i, std::size_t j) {
            sum += counted(m_wins[i][j], core::normalCumulative(scale[i] - scale[j]));
        });
        return sum;
    }
    /// Computes the gradient over the free values, and the negative Hessian.
    void derivatives(const std::vector<double>& free, std::vector<double>& gradient,
                     Matrix& information) const {
        const std::vector<double> scale = centredOf(free, m_wins.size());
        const std::size_t n = m_wins.size();
        std::vector<double> g(n, 0.0);
        Matrix h(n, std::vector<double>(n, 0.0));
        forEach([&](std::size_t i, std::size_t j) {
            const double z = scale[i] - scale[j];
            const double slope = mills(z);
            const double bend = m_wins[i][j] * slope * (z + slope);
            g[i] += m_wins[i][j] * slope;
            g[j] -= m_wins[i][j] * slope;
            h[i][i] += bend;
            h[j][j] += bend;
            h[i][j] -= bend;
            h[j][i] -= bend;
        });
        const std::size_t last = n - 1; // x_last = −Σ of the others
        gradient.assign(last, 0.0);
        information.assign(last, std::vector<double>(last, 0.0));
        for (std::size_t i = 0; i < last; ++i) {
            gradient[i] = g[i] - g[last];
            for (std::size_t j = 0; j < last; ++j)
                information[i][j] = h[i][j] - h[i][last] - h[last][j] + h[last][last];
        }
    }

private:
    template <typename Action> void forEach(Action&& action) const {
        for (std::size_t i = 0; i < m_wins.size(); ++i)
            for (std::size_t j = 0; j < m_wins.size(); ++j)
                if (m_wins[i][j] > 0.0)
                    action(i, j);
    }
    Matrix m_wins; ///< [winner][loser]
};

/// Returns the covariance times the gradient.
std::vector<double> newtonStep(const Matrix& covariance, const std::vector<double>& gradient) {
    std::vector<double> step(gradient.size(), 0.0);
    for (std::size_t i = 0; i < step.size(); ++i)
        for (std::size_t j = 0; j < step.size(); ++j)
            step[i] += covariance[i][j] * gradient[j];
    return step;
}

/// Climbs by Newton's method. ln Φ is concave, so there is a single maximum, and halving each step that does
/// not rise reaches it.
Maximum climb(const ProbitPairs& pairs, std::vector<double> start) {
    constexpr int kMostSteps = 100;
    constexpr double kSettled = 1e-12;
    Maximum best;
    best.at = std::move(start);
    best.value = pairs.value(best.at);
    std::vector<double> gradient;
    Matrix information;
    for (; best.iterations < kMostSteps && !best.found; ++best.iterations) {
        pairs.derivatives(best.at, gradient, information);
        best.covariance = inverseOf(information);
        if (best.covariance.empty())
            return best;
        const std::vector<double> step = newtonStep(best.covariance, gradient);
        double longest = 0.0;
        for (const double each : step)
            longest = std::max(longest, std::abs(each));
        best.found = longest < kSettled;
        for (double share = std::min(1.0, 2.0 / std::max(longest, 1e-300)); !best.found; share *= 0.5) {
            std::vector<double> at = best.at;
            for (std::size_t i = 0; i < at.size(); ++i)
                at[i] += share * step[i];
            const double value = pairs.value(at);
            best.found = share * longest < kSettled;
            if (value < best.value - 1e-13 * std::abs(best.value))
                continue;
            best.at = std::move(at);
            best.value = value;
            break;
        }
    }
    pairs.derivatives(best.at, gradient, information);
    best.covariance = inverseOf(information);
    return best;
}

} // namespace

TiedWorthEstimate fitTiedPairs(TieModel model, int objects, const std::vector<PairCount>& given) {
    TiedWorthEstimate result;
    const std::size_t n = objects > 0 ? static_cast<std::size_t>(objects) : 0;
    result.logWorth.assign(n, std::numeric_limits<double>::quiet_NaN());
    result.standardError = result.logWorth;
    const std::vector<PairCount> pairs = preparePairs(result, objects, given);
    if (pairs.empty())
        return result;
    const auto likelihood = [&](const std::vector<double>& at) {
        const std::vector<double> logs = centredOf(at, n);
        return model == TieModel::davidson ? davidson(pairs, logs, at.back())
                                           : raoKupper(pairs, logs, at.back());
    };
    const Maximum best = maximise(likelihood, std::vector<double>(n, 0.0));
    takeWorths(result, best, n);
    result.tie = model == TieModel::davidson ? std::exp(best.at.back()) : 1.0 + std::exp(best.at.back());
    if (!best.covariance.empty())
        result.tieStandardError = std::sqrt(std::max(0.0, best.covariance.back().back()));
    return result;
}

WorthEstimate fitThurstonePairs(int objects, const std::vector<Selection>& given) {
    // The usability rules for the data are those of Bradley–Terry, whose worths are also a good start.
    std::vector<Selection> pairs;
    std::copy_if(given.begin(), given.end(), std::back_inserter(pairs),
                 [](const Selection& pair) { return pair.losers.size() == 1; });
    WorthEstimate result = fitPlackettLuce(objects, pairs);
    if (pairs.size() < given.size())
        result.warnings.emplace_back("left_out: choices among more than two are not pairs");
    if (!result.fitted)
        return result;
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                               [&](const Selection& p) {
                                   const int other = p.losers.front();
                                   return p.winner < 0 || p.winner >= objects || other < 0 ||
                                          other >= objects || p.winner == other || !(p.count > 0.0) ||
                                          !std::isfinite(p.count);
                               }),
                pairs.end());
    const auto n = static_cast<std::size_t>(objects);
    std::vector<double> start(result.logWorth.begin(), result.logWorth.end() - 1);
    for (double& value : start)
        value /= 1.7; // converts the logistic to the normal scale
    const Maximum best = climb(ProbitPairs(n, pairs), start);
    takeWorths(result, best, n);
    return result;
}

WorthEstimate fitThurstoneOrders(int objects, const std::vector<std::vector<int>>& bestFirst) {
    // Judges produce few distinct pairs, so counting them saves time.
    std::map<std::pair<int, int>, double> wins;
    for (const std::vector<int>& order : bestFirst)
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t j = i + 1; j < order.size(); ++j)
                wins[{order[i], order[j]}] += 1.0;
    std::vector<Selection> pairs;
    for (const auto& [pair, count] : wins)
        pairs.push_back({pair.first, {pair.second}, count});
    WorthEstimate result = fitThurstonePairs(objects, pairs);
    std::fill(result.standardError.begin(), result.standardError.end(),
              std::numeric_limits<double>::quiet_NaN());
    return result;
}

} // namespace chiron::psychophysics
