// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "operators/comparison/participant_mind.h"
#include "psychophysics/observers/simulated_observer.h"
#include "session/study/fidelity_meter.h"
#include "session/study/study_progress.h"
#include "session/study/trial_clock.h"
#include "session/tick_director.h"

#include <functional>
#include <optional>

namespace chiron::session {

/// Runs one condition with a simulated participant, faster than real time. It presents what StudyProgress
/// requests, waits until the participant's decision model has explored every place, lets the observer answer
/// from the model's own estimates, measures the trial's fidelity from its frames, records it, and ends the
/// session when the run is done. All of this happens at ticks that the run itself determines, so the same
/// seeds give the same session. A trial that takes longer than kPatience_s, or whose places could not be
/// estimated, is spoiled. Adjustment: the participant explores, the dial is turned by the felt difference
/// (minus the difference that the observer perceives as none), and this repeats until the dial would not
/// move; the stored value is that of the candidate reached.
class StudyDirector final : public ITickDirector {
public:
    static constexpr double kPatience_s = 20.0; ///< for one exploration of all places
    static constexpr int kSteps = 5;            ///< largest number of steps of the dial in one trial

    struct Parts {
        StudyProgress& progress;
        const psychophysics::Condition& condition;
        operators::IParticipantMind& mind;
        psychophysics::SimulatedObserver& observer;
        FidelityMeter& meter;
        /// Stores the row of a trial; returning false ends the session at once (a failure to store).
        std::function<bool(database::StudyTrial)> store;
        /// Called after each trial; returning true ends the session there, as an interruption would (tests,
        /// stop).
        std::function<bool()> interrupted;
        double exploreLimit_s = 0.0; ///< time after which the objects are gone; 0: none
    };
    explicit StudyDirector(Parts parts) : m_parts(std::move(parts)) {}

    void connect(haptics::LiveInputs& inputs) noexcept override { m_inputs = &inputs; }
    bool tryPush(const core::HapticFrame& frame) noexcept override;

    void setSession(database::SessionId session) { m_session = session; }
    std::uint64_t ticks() const noexcept { return m_ticks; }
    bool over() const noexcept { return m_over; } ///< the end was requested
    /// The reason why the run's progress no longer accepted a trial.
    const core::Result<void>& recorded() const noexcept { return m_recorded; }

private:
    void direct(const FidelitySample& sample);
    void present();
    void endTrial(const FidelitySample& sample);
    void finish();
    std::optional<std::vector<double>> feel() const;
    std::optional<int> think(const std::vector<double>& felt);
    bool turned(const std::vector<double>& felt, const FidelitySample& sample);

    Parts m_parts;
    haptics::LiveInputs* m_inputs = nullptr;
    database::SessionId m_session = 0;
    std::uint64_t m_ticks = 0;
    TrialClock m_clock;
    StudyPresentation m_shown;
    bool m_presented = false;
    bool m_answered = false;
    bool m_over = false;
    int m_answer = -1;
    std::optional<double> m_value;
    std::string m_spoiled;
    std::uint64_t m_looked = 0; ///< tick at which the current exploration began
    int m_dial = 0;             ///< candidate that is set (adjustment)
    int m_steps = 0;
    std::optional<double> m_equal; ///< felt difference that this trial's observer perceives as none
    core::Result<void> m_recorded;
};

} // namespace chiron::session
