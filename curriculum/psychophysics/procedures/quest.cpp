// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/quest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

std::string digits(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

core::Result<void> checkQuest(const QuestSpec& spec) {
    const auto bad = [](const char* what) { return fail(ErrorCode::badInput, what); };
    if (!std::isfinite(spec.priorMean))
        return bad("prior_mean: expected a finite number");
    if (!(spec.priorSd > 0.0) || !std::isfinite(spec.priorSd))
        return bad("prior_sd: expected a positive number");
    if (!(spec.slope > 0.0) || !std::isfinite(spec.slope))
        return bad("slope: expected a positive number");
    if (!(spec.guess >= 0.0 && spec.guess < 1.0))
        return bad("guess: expected a share from 0 to below 1");
    if (!(spec.lapse >= 0.0 && spec.lapse < 1.0))
        return bad("lapse: expected a share from 0 to below 1");
    const double upper = 1.0 - spec.lapse * (1.0 - spec.guess);
    const double nearest = 1e-9 * (upper - spec.guess); // equal to an asymptote, except for rounding
    if (!(spec.target > spec.guess + nearest && spec.target < upper - nearest))
        return fail(ErrorCode::badInput, "target: expected a proportion above guess, " + digits(spec.guess) +
                                             ", and below 1 - lapse (1 - guess), " + digits(upper));
    if (!(spec.grain > 0.0) || !(spec.range > 0.0) || !(spec.range / spec.grain <= 1e6) ||
        !(spec.range / spec.grain >= 2.0))
        return bad("grain, range: expected positive numbers, range 2 to 1e6 times the grain");
    if (spec.method != "quantile" && spec.method != "mean" && spec.method != "mode")
        return bad("method: expected quantile, mean or mode");
    if (spec.minimum && spec.maximum && *spec.minimum > *spec.maximum)
        return bad("minimum: expected at most the maximum");
    if (spec.stop.trials <= 0 && !(spec.stop.sd > 0.0))
        return bad("stop: expected trials or sd");
    return {};
}

} // namespace

double questEpsilon(double target, double slope, double guess, double lapse) noexcept {
    const double rest = 1.0 - (target - lapse * guess) / (1.0 - lapse); // (1-γ) exp(-10^(βε))
    return std::log10(-std::log(rest / (1.0 - guess))) / slope;
}

double optimalQuantileOrder(double low, double high) noexcept {
    constexpr double kTiny = 1e-14; // keeps logarithms finite
    const double e = high * std::log(high + kTiny) - low * std::log(low + kTiny) +
                     (1.0 - high + kTiny) * std::log(1.0 - high + kTiny) -
                     (1.0 - low + kTiny) * std::log(1.0 - low + kTiny);
    return (1.0 / (1.0 + std::exp(e / (low - high))) - low) / (high - low);
}

core::Result<std::unique_ptr<Procedure>> Quest::make(const QuestSpec& spec) {
    CHIRON_TRY(checkQuest(spec));
    return std::make_unique<Quest>(spec);
}

Quest::Quest(QuestSpec spec) : m_spec(std::move(spec)) {
    m_half = std::ceil(m_spec.range / m_spec.grain / 2.0);
    m_right.resize(static_cast<std::size_t>(4.0 * m_half) + 1);
    m_wrong.resize(m_right.size());
    tabulate(0.0);
    tabulate(offset());
    m_order = optimalQuantileOrder(m_right.front(), m_right.back());
    restart();
}

/// Tabulates both outcomes independently. Computing one as 1 minus the other would lose tiny values, which
/// carry the information far from the threshold.
void Quest::tabulate(double epsilon) {
    const double range = (1.0 - m_spec.lapse) * (1.0 - m_spec.guess); // between the asymptotes
    for (std::size_t i = 0; i < m_right.size(); ++i) {
        const double hazard =
            std::pow(10.0, m_spec.slope * ((static_cast<double>(i) - 2.0 * m_half) * m_spec.grain + epsilon));
        m_right[i] = m_spec.guess - range * std::expm1(-hazard);
        m_wrong[i] = m_spec.lapse * (1.0 - m_spec.guess) + range * std::exp(-hazard);
    }
}

/// Returns ε as in the common implementations: by linear interpolation between grid points (of equal
/// neighbours only the last is used). If the grid does not reach it, the closed form is used.
double Quest::offset() const {
    const double exact = questEpsilon(m_spec.target, m_spec.slope, m_spec.guess, m_spec.lapse);
    std::size_t before = m_right.size();
    for (std::size_t i = 0; i + 1 < m_right.size(); ++i) {
        if (m_right[i] == m_right[i + 1])
            continue;
        if (m_right[i] > m_spec.target) {
            if (before == m_right.size())
                return exact;
            const double share = (m_spec.target - m_right[before]) / (m_right[i] - m_right[before]);
            const double from = static_cast<double>(before) - 2.0 * m_half;
            return m_spec.grain * (from + share * static_cast<double>(i - before));
        }
        before = i;
    }
    return exact;
}

void Quest::restart() {
    m_pdf.resize(static_cast<std::size_t>(2.0 * m_half) + 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < m_pdf.size(); ++i)
        sum += m_pdf[i] = std::exp(-0.5 * std::pow(x(i) / m_spec.priorSd, 2));
    for (double& p : m_pdf)
        p /= sum;
}

Choice Quest::next() const {
    double level = m_spec.priorMean;
    if (trials() > 0)
        level = m_spec.method == "mean" ? mean() : m_spec.method == "mode" ? mode() : quantile(m_order);
    if (m_spec.maximum)
        level = std::min(level, *m_spec.maximum);
    if (m_spec.minimum)
        level = std::max(level, *m_spec.minimum);
    Choice choice;
    choice.stimulus = {level};
    return choice;
}

core::Result<void> Quest::take(const RecordedTrial& trial) {
    // A stimulus beyond the grid counts as lying at its end.
    const double offset =
        std::clamp(std::nearbyint((trial.presented[0] - m_spec.priorMean) / m_spec.grain), -m_half, m_half);
    std::vector<double> pdf = m_pdf;
    double sum = 0.0;
    for (std::size_t i = 0; i < pdf.size(); ++i) {
        const auto at = static_cast<std::size_t>(offset + 3.0 * m_half - static_cast<double>(i));
        sum += pdf[i] *= trial.outcome == 1 ? m_right[at] : m_wrong[at];
    }
    if (!(sum > 0.0))
        return fail(ErrorCode::badInput,
                    "outcome " + std::to_string(trial.outcome) +
                        ": impossible at this stimulus for every threshold: expected a lapse above 0");
    for (double& p : pdf)
        p /= sum;
    m_pdf = std::move(pdf);
    return {};
}

double Quest::mean() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < m_pdf.size(); ++i)
        sum += m_pdf[i] * x(i);
    return m_spec.priorMean + sum;
}

double Quest::mode() const {
    return m_spec.priorMean +
           x(static_cast<std::size_t>(std::max_element(m_pdf.begin(), m_pdf.end()) - m_pdf.begin()));
}

double Quest::sd() const {
    const double centre = mean() - m_spec.priorMean;
    double sum = 0.0;
    for (std::size_t i = 0; i < m_pdf.size(); ++i)
        sum += m_pdf[i] * (x(i) - centre) * (x(i) - centre);
    return std::sqrt(sum);
}

double Quest::quantile(double order) const {
    // Interpolates linearly between the points at which the distribution rises, including the very last one.
    // Points at which it does not rise have no probability.
    const double wanted = order * std::accumulate(m_pdf.begin(), m_pdf.end(), 0.0);
    double lastP = 0.0;
    double lastX = 0.0;
    for (std::size_t i = 0; i < m_pdf.size(); ++i) {
        const double p = lastP + m_pdf[i];
        if (p == lastP)
            continue;
        if (p >= wanted)
            return m_spec.priorMean +
                   (lastP > 0.0 ? lastX + (x(i) - lastX) * (wanted - lastP) / (p - lastP) : x(i));
        lastP = p;
        lastX = x(i);
    }
    return m_spec.priorMean + lastX;
}

std::pair<double, double> Quest::intervalWithOpenSlope() const {
    constexpr int kSlopes = 13;
    constexpr double kReach = 4.0;
    constexpr double kMostWork = 1e8; // grids of a million points are meant for lookups, not for this
    if (static_cast<double>(m_pdf.size()) * kSlopes * std::max(1, trials()) > kMostWork)
        return {quantile(0.025), quantile(0.975)};
    const double range = (1.0 - m_spec.lapse) * (1.0 - m_spec.guess);
    std::vector<double> row(m_pdf.size()), right(m_right.size()), wrong(m_right.size());
    struct Own {
        double logEvidence, low, high;
    };
    std::vector<Own> slopes;
    for (int k = 0; k < kSlopes; ++k) {
        const double slope = m_spec.slope * std::pow(kReach, 2.0 * k / (kSlopes - 1) - 1.0);
        const double epsilon = questEpsilon(m_spec.target, slope, m_spec.guess, m_spec.lapse);
        for (std::size_t i = 0; i < right.size(); ++i) {
            const double hazard =
                std::pow(10.0, slope * ((static_cast<double>(i) - 2.0 * m_half) * m_spec.grain +
                                        (std::isfinite(epsilon) ? epsilon : 0.0)));
            right[i] = std::log(std::max(m_spec.guess - range * std::expm1(-hazard), 1e-300));
            wrong[i] =
                std::log(std::max(m_spec.lapse * (1.0 - m_spec.guess) + range * std::exp(-hazard), 1e-300));
        }
        for (std::size_t i = 0; i < m_pdf.size(); ++i)
            row[i] = -0.5 * std::pow(x(i) / m_spec.priorSd, 2);
        for (const RecordedTrial& trial : log()) {
            const double offset = std::clamp(
                std::nearbyint((trial.presented[0] - m_spec.priorMean) / m_spec.grain), -m_half, m_half);
            const std::vector<double>& table = trial.outcome == 1 ? right : wrong;
            for (std::size_t i = 0; i < m_pdf.size(); ++i)
                row[i] += table[static_cast<std::size_t>(offset + 3.0 * m_half - static_cast<double>(i))];
        }
        const double most = *std::max_element(row.begin(), row.end());
        double total = 0.0;
        for (double& p : row)
            total += p = std::exp(p - most);
        const auto below = [&](double share) { // each point represents the interval of one grain around it
            double sum = 0.0;
            for (std::size_t i = 0; i < row.size(); ++i) {
                if (sum + row[i] >= share * total)
                    return m_spec.priorMean + x(i) + m_spec.grain * ((share * total - sum) / row[i] - 0.5);
                sum += row[i];
            }
            return m_spec.priorMean + x(row.size() - 1);
        };
        slopes.push_back({std::log(total) + most, below(0.025), below(0.975)});
    }
    const double best = std::max_element(slopes.begin(), slopes.end(), [](const Own& a, const Own& b) {
                            return a.logEvidence < b.logEvidence;
                        })->logEvidence;
    std::pair<double, double> interval{std::numeric_limits<double>::infinity(),
                                       -std::numeric_limits<double>::infinity()};
    for (const Own& own : slopes)
        if (own.logEvidence >= best + std::log(kAtGridEdge)) {
            interval.first = std::min(interval.first, own.low);
            interval.second = std::max(interval.second, own.high);
        }
    return interval;
}

bool Quest::done() const noexcept {
    return stopped(m_spec.stop, trials(), 0,
                   m_spec.stop.sd > 0.0 ? std::optional<double>(sd()) : std::nullopt);
}

ProcedureEstimate Quest::estimate() const {
    ProcedureEstimate estimate;
    estimate.known = trials() > 0;
    estimate.method = "posterior mean (QUEST)";
    const auto [low, high] =
        estimate.known ? intervalWithOpenSlope() : std::pair(quantile(0.025), quantile(0.975));
    const double least = kAtGridEdge * *std::max_element(m_pdf.begin(), m_pdf.end());
    estimate.parameters = {
        {"threshold", mean(), sd(), low, high, mode(), m_pdf.front() >= least, m_pdf.back() >= least}};
    if (!estimate.known)
        return estimate;
    warnOfGridEdges(estimate, 1);
    if (high - low > 1.1 * (quantile(0.975) - quantile(0.025)))
        estimate.warnings.push_back(
            "slope_assumed: mean and sd take the slope for known; the interval leaves it open and is wider");
    return estimate;
}

} // namespace chiron::psychophysics
