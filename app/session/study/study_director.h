// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/comparison/operators/participant_mind.h"
#include "psychophysics/observers/simulated_observer.h"
#include "session/study/fidelity_meter.h"
#include "session/study/study_progress.h"
#include "session/study/trial_clock.h"
#include "session/tick_director.h"

#include <functional>
#include <optional>

namespace chiron::session {

/// Runs one condition with a simulated participant, as fast as the machine can: presents what StudyProgress asks for, waits until the
/// mind has explored every place, lets the observer answer from the mind's own estimates, measures the trial's fidelity from its
/// frames, records it, and ends the sitting when the run is done. Everything at ticks that the run itself determines, so the same
/// seeds give the same session. A trial that takes longer than kPatience_s, or whose places could not be estimated, is spoiled.
/// Adjustment: the mind explores, the dial is stepped by the difference it felt (less what the observer takes for none), and so on
/// until the dial would stay; the value stored is that of the candidate reached.
class StudyDirector final : public ITickDirector {
public:
    static constexpr double kPatience_s = 20.0; ///< for one exploration of all places
    static constexpr int kSteps = 5;            ///< of the dial in one trial, at most

    struct Parts {
        StudyProgress& progress;
        const psychophysics::Condition& condition;
        operators::IParticipantMind& mind;
        psychophysics::SimulatedObserver& observer;
        FidelityMeter& meter;
        /// Takes the row of a trial; false ends the sitting at once (a failure to store).
        std::function<bool(database::StudyTrial)> store;
        /// Asked after each trial: true ends the sitting there, as an interruption would (tests, stop).
        std::function<bool()> interrupted;
        double exploreLimit_s = 0.0; ///< after which the objects are gone; 0: none
    };
    explicit StudyDirector(Parts parts) : m_parts(std::move(parts)) {}

    void connect(haptics::LiveInputs& inputs) noexcept override { m_inputs = &inputs; }
    bool tryPush(const core::HapticFrame& frame) noexcept override;

    void setSession(database::SessionId session) { m_session = session; }
    std::uint64_t ticks() const noexcept { return m_ticks; }
    bool over() const noexcept { return m_over; } ///< the end was asked for
    const core::Result<void>& recorded() const noexcept { return m_recorded; } ///< why the run's progress took a trial no more

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
    std::uint64_t m_looked = 0;     ///< tick at which the present exploration began
    int m_dial = 0;                 ///< candidate that is set (adjustment)
    int m_steps = 0;
    std::optional<double> m_equal;  ///< felt difference that this trial's observer takes for none
    core::Result<void> m_recorded;
};

} // namespace chiron::session
