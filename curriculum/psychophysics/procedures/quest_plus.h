// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/outcome_tables.h"
#include "psychophysics/procedures/trial_log.h"

#include <functional>
#include <string>

namespace chiron::psychophysics {

/// The parts that all runs of one QUEST+ specification share. Made once and never changed.
struct QuestPlusModel {
    std::string id; ///< kind and version
    std::vector<Stimulus> stimuli;
    PosteriorGrid prior;
    std::shared_ptr<const OutcomeTables> tables;
    /// Returns the tables of a stimulus that is not on the grid (presented differently from what was asked
    /// for). Empty: only stimuli of the grid can be recorded.
    std::function<core::Result<std::shared_ptr<const OutcomeTables>>(const Stimulus&)> tablesAt;
    StopRule stop;
    int repeatLimit = 0;
    std::vector<std::vector<int>> alike; ///< with a limit of repeats: for every stimulus, the rows that
                                         ///< contain it
    double catchShare = 0.0;
    int easiest = -1; ///< candidate of the catch trials
};

/// Errors: badInput naming the key and what was expected.
core::Result<std::shared_ptr<const QuestPlusModel>> questPlusModel(const QuestPlusSpec& spec);

/// Limits the consecutive repeats of a stimulus, whichever of its rows is chosen. If a stimulus stands in
/// several rows, the id is version 2: version 1 counted rows.
void limitRepeats(QuestPlusModel& model, int limit);

/// QUEST+ (Watson 2017): presents the stimulus with the least expected entropy, using OutcomeTables; the
/// estimates are posterior means with intervals.
class QuestPlus final : public LoggedProcedure {
public:
    QuestPlus(std::shared_ptr<const QuestPlusModel> model, std::uint64_t seed);

    std::string_view id() const noexcept override { return m_model->id; }
    int outcomes() const noexcept override { return m_model->tables->outcomes(); }
    Choice next() const override;
    bool done() const noexcept override;
    ProcedureEstimate estimate() const override;

    const PosteriorGrid& posterior() const noexcept { return m_posterior; }
    /// Returns the expected entropy after the next trial, nats.
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
    int m_lastCandidate = -1; ///< with a limit of repeats: the first of the rows with the same stimulus
    int m_sameInARow = 0;
    double m_sd = 0.0;                      ///< of the first parameter, if the run can stop by it
    mutable std::optional<Choice> m_choice; ///< cached until the next outcome
};

/// Returns a factory of runs that share one model. `purpose` names the stream of their random numbers.
/// Errors: that of the model.
core::Result<ProcedureFactory>
factoryOfModel(const core::Result<std::shared_ptr<const QuestPlusModel>>& model, const std::string& purpose);

} // namespace chiron::psychophysics
