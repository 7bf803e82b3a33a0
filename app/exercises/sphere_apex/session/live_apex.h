// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/live_sitting.h"

namespace chiron::session {

struct ConductedSitting;

/// The study of the apex, in the scene of the exercise "sphere_apex": a hidden sphere a trial, at another place each time, one mark each.
/// Sessions as the command line's: as many trials as are left, and a further session for those that were spoiled. The exercise goes from
/// trial to trial by itself; a break, the experimenter's word or feedback hold it between two. A trial at hand when the sitting is stopped
/// is stored as spoiled and comes again elsewhere.
class LiveApex final : public LiveSitting {
public:
    /// Of a condition that looks for an apex. Failure: as LiveSitting::start.
    static SittingResult<std::unique_ptr<LiveApex>> start(database::Database& database, const database::Actor& actor,
                                                   const ConductedSitting& sitting, LiveStudyRequest request);
    ~LiveApex() override;

    void poll() override;
    LiveStudyView view() const override;
    LiveStudyNumbers numbers() const override;
    const psychophysics::StudyDesign& design() const override;
    const psychophysics::Condition& condition() const override;
    const catalogue::ExerciseLevel& level() const override;
    LiveTraining& training() override;
    int sessions() const override;

    /// Answer 0: "here it is", a mark where the tool is. A device's own button marks as well.
    core::Result<void> answer(int answer, std::optional<double> value = std::nullopt) override;
    /// The trial at hand does not count: it ends with the mark, as only the participant or the clock ends one here.
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
