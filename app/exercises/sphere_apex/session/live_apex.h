// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/live_sitting.h"

namespace chiron::session {

struct ConductedSitting;

/// The study of the apex in the scene of the exercise "sphere_apex": in each trial a hidden sphere at another
/// position, and one mark. As on the command line, a session has as many trials as are left, and a further
/// session repeats those that were spoiled. The exercise proceeds from trial to trial by itself; a break, the
/// experimenter or feedback can hold it between two. If the run is stopped during a trial, this trial is
/// stored as spoiled and repeated at another position.
class LiveApex final : public LiveSitting {
public:
    /// For a condition in which participants look for an apex.
    /// Errors: those of LiveSitting::start.
    static SittingResult<std::unique_ptr<LiveApex>> start(database::Database& database,
                                                          const database::Actor& actor,
                                                          const ConductedSitting& sitting,
                                                          LiveStudyRequest request);
    ~LiveApex() override;

    void poll() override;
    LiveStudyView view() const override;
    LiveStudyNumbers numbers() const override;
    const psychophysics::StudyDesign& design() const override;
    const psychophysics::Condition& condition() const override;
    const catalogue::ExerciseLevel& level() const override;
    LiveTraining& training() override;
    int sessions() const override;

    /// Answer 0 means "here it is": a mark at the tool's position. The device's own button marks as well.
    core::Result<void> answer(int answer, std::optional<double> value = std::nullopt) override;
    /// The trial then does not count: it ends with the mark, because here only the participant or the clock
    /// can end a trial.
    void beginAnswer() override;
    void takeBack() override;
    void goOn() override;
    void endTrying() override;
    void beginCounting() override;
    void setMasking(const std::string& what) override;
    void spoil() override;
    void pause() override;
    void resume() override;
    void stopForce() override;
    void rearm() override;
    void breakTaken() override;
    void experimenterSays(bool goOn) override;
    void stop() override;

    bool finished() const override;
    const core::Result<LiveStudyResult>& result() const override;

private:
    struct State;
    explicit LiveApex(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace chiron::session
