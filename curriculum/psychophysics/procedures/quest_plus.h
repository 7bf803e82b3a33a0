// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/outcome_tables.h"
#include "psychophysics/procedures/trial_log.h"

#include <functional>
#include <string>

namespace chiron::psychophysics {

/// What any number of runs of one QUEST+ share: made once, never changed.
struct QuestPlusModel {
    std::string id;                         ///< kind and version
    std::vector<Stimulus> stimuli;
    PosteriorGrid prior;
    std::shared_ptr<const OutcomeTables> tables;
    /// Tables of one stimulus that is not on the grid (presented otherwise than asked); empty: only stimuli of the grid can be recorded.
    std::function<core::Result<std::shared_ptr<const OutcomeTables>>(const Stimulus&)> tablesAt;
    StopRule stop;
    int repeatLimit = 0;
    std::vector<std::vector<int>> alike; ///< with a limit of repeats: for every stimulus the rows that are the same
    double catchShare = 0.0;
    int easiest = -1; ///< candidate of the catch trials
};

/// Failure: badInput naming the key and what was expected.
core::Result<std::shared_ptr<const QuestPlusModel>> questPlusModel(const QuestPlusSpec& spec);

/// Limits repeats of a stimulus, in whatever rows it stands. Where one stands in several the id is version 2: version 1 counted rows.
void limitRepeats(QuestPlusModel& model, int limit);

/// QUEST+ (Watson 2017): the stimulus that leaves the least expected entropy, by OutcomeTables; posterior means with intervals.
class QuestPlus final : public LoggedProcedure {
public:
    QuestPlus(std::shared_ptr<const QuestPlusModel> model, std::uint64_t seed);

    std::string_view id() const noexcept override { return m_model->id; }
    int outcomes() const noexcept override { return m_model->tables->outcomes(); }
    Choice next() const override;
    bool done() const noexcept override;
    ProcedureEstimate estimate() const override;

    const PosteriorGrid& posterior() const noexcept { return m_posterior; }
    /// Expected entropy after the next trial, nats.
    double expectedEntropy() const;

protected:
    std::size_t dimensions() const noexcept override { return m_model->stimuli.front().size(); }
    void restart() override;
    core::Result<void> take(const RecordedTrial& trial) override;

private:
    int candidateOf(const Stimulus& presented) const;
    int nearestTo(const Stimulus& presented) const;
    Rows leftOut() const;
    core::Result<std::vector<double>> likelihoodOf(const RecordedTrial& trial, int candidate) const;
    Choice choose() const;

    std::shared_ptr<const QuestPlusModel> m_model;
    std::uint64_t m_seed;
    PosteriorGrid m_posterior;
    int m_taken = 0;
    int m_lastCandidate = -1; ///< with a limit of repeats: the first of the rows that are alike
    int m_sameInARow = 0;
    double m_sd = 0.0; ///< of the first parameter, where the run stops by it
    mutable std::optional<Choice> m_choice; ///< kept until the next outcome
};

/// Runs that share one model. `purpose`: what their random numbers are drawn for. Failure: that of the model.
core::Result<ProcedureFactory> factoryOfModel(const core::Result<std::shared_ptr<const QuestPlusModel>>& model, const std::string& purpose);

} // namespace chiron::psychophysics
