// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/quest_plus.h"

#include "core/random.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

QuestPlus::QuestPlus(std::shared_ptr<const QuestPlusModel> model, std::uint64_t seed)
    : m_model(std::move(model)), m_seed(seed), m_posterior(m_model->prior) {
    restart();
}

void QuestPlus::restart() {
    m_posterior.restart();
    m_taken = m_sameInARow = 0;
    m_lastCandidate = -1;
    m_sd = m_model->stop.sd > 0.0 ? m_posterior.sd(0) : 0.0;
    m_choice.reset();
}

Choice QuestPlus::next() const {
    if (!m_choice)
        m_choice = choose();
    return *m_choice;
}

/// Returns the rows of the stimulus that has reached its limit of repeats; none if there is no other
/// stimulus.
Rows QuestPlus::leftOut() const {
    if (m_model->repeatLimit <= 0 || m_sameInARow < m_model->repeatLimit)
        return {};
    const std::vector<int>& rows = m_model->alike[static_cast<std::size_t>(m_lastCandidate)];
    return rows.size() < m_model->stimuli.size() ? Rows(rows) : Rows();
}

Choice QuestPlus::choose() const {
    const BestStimulus best = m_model->tables->best(m_posterior, leftOut());
    Choice choice;
    choice.candidate = best.index;
    choice.entropyMargin = best.margin;
    // The draw depends only on the trial's number, so that taking back or resuming changes nothing.
    if (m_model->catchShare > 0.0 &&
        core::Random::stream(m_seed, "quest_plus.catch." + std::to_string(m_taken)).uniform() <
            m_model->catchShare) {
        choice.candidate = m_model->easiest;
        choice.entropyMargin = std::numeric_limits<double>::quiet_NaN();
    }
    choice.stimulus = m_model->stimuli[static_cast<std::size_t>(choice.candidate)];
    return choice;
}

double QuestPlus::expectedEntropy() const {
    return m_posterior.entropy() + m_model->tables->best(m_posterior, {}).gain;
}

bool QuestPlus::done() const noexcept {
    return stopped(m_model->stop, trials(), 0, m_sd);
}

/// Returns the grid's row of a stimulus; -1 if there is none.
int QuestPlus::candidateOf(const Stimulus& presented) const {
    const auto same = [&presented](const Stimulus& s) {
        for (std::size_t i = 0; i < s.size(); ++i)
            if (std::abs(s[i] - presented[i]) > 1e-12 * std::max(std::abs(s[i]), 1e-12))
                return false;
        return true;
    };
    if (m_choice && same(m_choice->stimulus))
        return m_choice->candidate;
    const auto end = m_model->stimuli.end();
    const auto found = std::find_if(m_model->stimuli.begin(), end, same);
    if (found == end)
        return -1;
    // The stimulus stands in several rows: it was the chosen row, also when trials are replayed.
    if (std::find_if(found + 1, end, same) != end) {
        const Choice chosen = choose();
        if (same(chosen.stimulus))
            return chosen.candidate;
    }
    return static_cast<int>(found - m_model->stimuli.begin());
}

/// Returns the grid's row nearest to a stimulus, with each dimension scaled by its range; the first of
/// equally near ones.
int QuestPlus::nearestTo(const Stimulus& presented) const {
    const std::vector<Stimulus>& grid = m_model->stimuli;
    std::vector<double> range(presented.size());
    for (std::size_t i = 0; i < range.size(); ++i) {
        const auto [low, high] = std::minmax_element(
            grid.begin(), grid.end(), [i](const Stimulus& a, const Stimulus& b) { return a[i] < b[i]; });
        range[i] = (*high)[i] > (*low)[i] ? (*high)[i] - (*low)[i] : 1.0;
    }
    const auto distance = [&](const Stimulus& s) {
        double sum = 0.0;
        for (std::size_t i = 0; i < s.size(); ++i)
            sum += (s[i] - presented[i]) / range[i] * ((s[i] - presented[i]) / range[i]);
        return sum;
    };
    return static_cast<int>(
        std::min_element(grid.begin(), grid.end(),
                         [&](const Stimulus& a, const Stimulus& b) { return distance(a) < distance(b); }) -
        grid.begin());
}

core::Result<std::vector<double>> QuestPlus::likelihoodOf(const RecordedTrial& trial, int candidate) const {
    std::vector<double> likelihood;
    if (candidate >= 0) {
        m_model->tables->likelihood(static_cast<std::size_t>(candidate), trial.outcome, likelihood);
        return likelihood;
    }
    if (!m_model->tablesAt)
        return fail(ErrorCode::badInput, "stimulus that is not on the grid: expected one of stimuli");
    auto tables = m_model->tablesAt(trial.presented);
    CHIRON_TRY(tables);
    (*tables)->likelihood(0, trial.outcome, likelihood);
    return likelihood;
}

core::Result<void> QuestPlus::take(const RecordedTrial& trial) {
    const int candidate = candidateOf(trial.presented);
    const auto likelihood = likelihoodOf(trial, candidate);
    CHIRON_TRY(likelihood);
    if (!m_posterior.update(*likelihood))
        return fail(
            ErrorCode::badInput,
            "outcome " + std::to_string(trial.outcome) +
                ": impossible at this stimulus for all parameters of the grid: expected a grid with a "
                "lapse rate above 0, or another outcome");
    // A rounded stimulus counts as the row that it represents.
    int row = candidate >= 0 ? candidate : nearestTo(trial.presented);
    if (m_model->repeatLimit > 0)
        row = m_model->alike[static_cast<std::size_t>(row)].front();
    m_sameInARow = row == m_lastCandidate ? m_sameInARow + 1 : 1;
    m_lastCandidate = row;
    ++m_taken;
    if (m_model->stop.sd > 0.0)
        m_sd = m_posterior.sd(0);
    m_choice.reset();
    return {};
}

ProcedureEstimate QuestPlus::estimate() const {
    ProcedureEstimate estimate;
    estimate.known = trials() > 0;
    estimate.method = "posterior mean";
    for (std::size_t k = 0; k < m_posterior.parameters(); ++k)
        estimate.parameters.push_back(m_posterior.estimate(k));
    constexpr std::size_t kThresholdAndSlope = 2; // lapse and guess rates naturally lie at an end
    if (estimate.known)
        warnOfGridEdges(estimate, kThresholdAndSlope);
    return estimate;
}

core::Result<ProcedureFactory>
factoryOfModel(const core::Result<std::shared_ptr<const QuestPlusModel>>& model, const std::string& purpose) {
    CHIRON_TRY(model);
    return [shared = *model, purpose](std::uint64_t seed) {
        return std::make_unique<QuestPlus>(shared, core::Random::mix(seed, purpose));
    };
}

} // namespace chiron::psychophysics
