// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "psychophysics/procedures/procedure.h"
#include "psychophysics/study/study_design.h"
#include "session/study/trial_fidelity.h"

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace chiron::session {

/// The next presentation.
struct StudyPresentation {
    int candidate = 0;
    int arrangement = 0;
    double difference = 0.0;    ///< D
    std::vector<double> values; ///< at each place, SI
    int procedure = 0;
    double entropyMargin = 0.0;
    bool practice = false;
    int trial = 0;    ///< scored trials before it in this run
    int ordinal = 0;  ///< all presentations before it
    int ofAtMost = 0; ///< 0: not known
    int repeat = 0;   ///< number of times it was already spoiled
};

/// The participant's answer to a presentation.
struct StudyAnswer {
    int answer = -1;
    std::optional<double> value;
    double exploration_s = 0.0;
    double answer_s = 0.0;
    database::SessionId session = 0;
    std::uint64_t firstTick = 0, lastTick = 0;
    TrialFidelity fidelity;
    /// External reason why it does not count (experimenter, time, stopped); empty: the fidelity decides.
    std::string spoiled;
};

struct ReplayedChoices;

/// One run of one condition as a sequence of presentations and answers: procedures, interleaving,
/// arrangements (balanced, seeded), practice, spoiled trials, breaks, stop rules. It uses values only: no
/// database, no rendering. Deterministic; resume() continues a run from its stored trials and takes over the
/// logged choices.
/// Thread: any one.
class StudyProgress {
public:
    /// Begins a run. `limit`: only candidates |D| up to it are presented, because the device renders no
    /// larger ones (study_limits.h).
    /// Errors: badInput (a procedure that cannot be made).
    static core::Result<StudyProgress> begin(const psychophysics::StudyDesign& design,
                                             const std::string& condition, std::uint64_t seed,
                                             double limit = kNoLimit);
    static core::Result<StudyProgress> resume(const psychophysics::StudyDesign& design,
                                              const std::string& condition, std::uint64_t seed,
                                              const std::vector<database::StudyTrial>& trials,
                                              double limit = kNoLimit);
    static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
    StudyProgress(StudyProgress&&) noexcept;
    StudyProgress& operator=(StudyProgress&&) noexcept;
    ~StudyProgress();

    bool done() const;
    bool practising() const; ///< the next presentation, if there is one, is practice
    bool breakDue() const;   ///< until breakTaken()
    void breakTaken();
    StudyPresentation next() const;
    /// The candidate nearest to D among those that the device renders: the position to which a dial can be
    /// turned.
    int presentable(double difference) const;
    /// Accepts the answer and returns the row to store.
    /// Errors: badInput.
    core::Result<database::StudyTrial> record(const StudyAnswer& answer);
    /// The current estimate of each procedure, for the experimenter.
    std::vector<psychophysics::ProcedureEstimate> estimates() const;
    std::vector<const psychophysics::Procedure*> procedures() const;
    bool needsExperimenter() const; ///< one trial was spoiled repeatsAtMost times
    void experimenterSays(bool goOn);
    bool gaveUp() const; ///< the experimenter declined: the run is done, but not completed
    int scored() const;
    int spoiledTrials() const; ///< repeated ones (database::isRepeated)
    /// Number of presentations left if none is spoiled, practice included; 0: not known.
    int toCome() const;
    /// The procedures as stored with a run: "rank3_quest_plus@1", separated by commas if there are several;
    /// with a limit, ",limit@0.301" follows.
    std::string procedureIds() const;
    static double limitOf(const std::string& procedureIds); ///< kNoLimit if there is none

private:
    friend core::Result<ReplayedChoices> rerunChoices(const psychophysics::StudyDesign& design,
                                                      const database::StudyRun& run,
                                                      const std::vector<database::StudyTrial>& trials);
    struct State;
    explicit StudyProgress(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

/// The result of re-running the log of a run (psychophysics.md §6).
struct ReplayedChoices {
    int trials = 0;
    int same = 0;
    int ties = 0;               ///< different with a margin below 1e-9
    int firstDifference = -1;   ///< ordinal; -1: none
    bool sameProcedures = true; ///< the versions are the stored ones

    /// Every choice of the log is made again, by the procedures that made it.
    bool identical() const noexcept { return sameProcedures && same + ties == trials; }
};
core::Result<ReplayedChoices> rerunChoices(const psychophysics::StudyDesign& design,
                                           const database::StudyRun& run,
                                           const std::vector<database::StudyTrial>& trials);

} // namespace chiron::session
