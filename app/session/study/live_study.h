// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/live_sitting.h"

namespace chiron::session {

struct ConductedSitting;

/// A run of comparisons in one session of "comparison". Combines a LiveTraining with a StudyProgress.
class LiveStudy final : public LiveSitting {
public:
    /// Begins or resumes the run.
    /// Errors: those of LiveSitting::start.
    static SittingResult<std::unique_ptr<LiveStudy>>
    start(database::Database& database, const database::Actor& actor, LiveStudyRequest request);
    static SittingResult<std::unique_ptr<LiveStudy>> start(database::Database& database,
                                                           const database::Actor& actor,
                                                           const ConductedSitting& sitting,
                                                           LiveStudyRequest request);
    ~LiveStudy() override;

    void poll() override;
    LiveStudyView view() const override;
    LiveStudyNumbers numbers() const override;
    const psychophysics::StudyDesign& design() const override;
    const psychophysics::Condition& condition() const override;
    const catalogue::ExerciseLevel& level() const override;
    LiveTraining& training() override;
    int sessions() const override { return 1; }

    core::Result<void> answer(int answer, std::optional<double> value = std::nullopt) override;
    void adjust(int steps) override;
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
    explicit LiveStudy(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace chiron::session
