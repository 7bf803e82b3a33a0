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

/// What is to be presented next.
struct StudyPresentation {
    int candidate = 0;
    int arrangement = 0;
    double difference = 0.0;         ///< D
    std::vector<double> values;      ///< at each place, SI
    int procedure = 0;
    double entropyMargin = 0.0;
    bool practice = false;
    int trial = 0;                   ///< scored ones before it in this run
    int ordinal = 0;                 ///< all presentations before it
    int ofAtMost = 0;                ///< 0: not known
    int repeat = 0;                  ///< how often this one was spoiled already
};

/// What came of it.
struct StudyAnswer {
    int answer = -1;
    std::optional<double> value;
    double exploration_s = 0.0;
    double answer_s = 0.0;
    database::SessionId session = 0;
    std::uint64_t firstTick = 0, lastTick = 0;
    TrialFidelity fidelity;
    std::string spoiled; ///< why it does not count, from outside (experimenter, time, stopped); empty: fidelity decides
};

struct ReplayedChoices;

/// One run of one condition as a sequence of presentations and answers: procedures, interleaving, arrangements (balanced, seeded),
/// practice, spoiled trials, breaks, stop rules. Values alone: no database, no rendering. Deterministic; a run is resumed by handing its
/// stored trials to resume(), which takes the logged choices and goes on. Any one thread.
class StudyProgress {
public:
    /// Failure: badInput (a procedure that cannot be made).
    /// `limit`: only candidates |D| up to it are presented, because the device renders no larger ones (study_limits.h).
    static core::Result<StudyProgress> begin(const psychophysics::StudyDesign& design, const std::string& condition, std::uint64_t seed,
                                             double limit = kNoLimit);
    static core::Result<StudyProgress> resume(const psychophysics::StudyDesign& design, const std::string& condition, std::uint64_t seed,
                                              const std::vector<database::StudyTrial>& trials, double limit = kNoLimit);
    static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
    StudyProgress(StudyProgress&&) noexcept;
    StudyProgress& operator=(StudyProgress&&) noexcept;
    ~StudyProgress();

    bool done() const;
    bool breakDue() const;        ///< until breakTaken()
    void breakTaken();
    StudyPresentation next() const;
    int presentable(double difference) const; ///< the candidate nearest to D of those that the device renders: where a dial can be turned to
    /// Takes the answer and gives the row to store. Failure: badInput.
    core::Result<database::StudyTrial> record(const StudyAnswer& answer);
    /// Live, for the experimenter: each procedure's own estimate.
    std::vector<psychophysics::ProcedureEstimate> estimates() const;
    std::vector<const psychophysics::Procedure*> procedures() const;
    bool needsExperimenter() const; ///< one trial was spoiled repeatsAtMost times
    void experimenterSays(bool goOn);
    bool gaveUp() const; ///< the experimenter said no: done, and not completed
    int scored() const;
    int spoiledTrials() const;
    int toCome() const; ///< presentations that are left where none is spoiled, practice included; 0: not known
    /// What a run's row stores of it: "rank3_quest_plus@1", of several separated by commas; with a limit ",limit@0.301" after them.
    std::string procedureIds() const;
    static double limitOf(const std::string& procedureIds); ///< kNoLimit where it names none

private:
    friend core::Result<ReplayedChoices> rerunChoices(const psychophysics::StudyDesign& design, const database::StudyRun& run,
                                                      const std::vector<database::StudyTrial>& trials);
    struct State;
    explicit StudyProgress(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

/// How re-running a run's log compares (psychophysics.md §6).
struct ReplayedChoices {
    int trials = 0;
    int same = 0;
    int ties = 0;               ///< different with a margin below 1e-9
    int firstDifference = -1;   ///< ordinal; -1: none
    bool sameProcedures = true; ///< versions as stored
};
core::Result<ReplayedChoices> rerunChoices(const psychophysics::StudyDesign& design, const database::StudyRun& run,
                                           const std::vector<database::StudyTrial>& trials);

} // namespace chiron::session
