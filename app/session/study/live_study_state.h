// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_blinding.h"
#include "session/study/begun_run.h"
#include "session/study/fidelity_meter.h"
#include "session/study/live_study.h"
#include "session/study/sample_tap.h"
#include "session/study/sitting_control.h"
#include "session/study/sitting_notes.h"
#include "session/study/study_limits.h"
#include "session/study/study_store.h"
#include "session/study/trial_clock.h"

#include <chrono>

namespace chiron::session {

/// The state of a run between two polls by the window.
/// Thread: GUI.
struct LiveStudy::State {
    using Clock = std::chrono::steady_clock;

    State(database::Database& data, database::Actor who, OpenedStudy opened, StudyProgress begun,
          catalogue::ExerciseLevel made, bool rendersNone, std::string language)
        : database(data), actor(std::move(who)), study(std::move(opened)), progress(std::move(begun)),
          level(std::move(made)), notes(std::move(language)),
          meter(level.parameters.as<simulation::ComparisonParameters>(), study.design.fidelity,
                study.design.trial.mustTouchAll, rendersNone) {}

    database::Database& database;
    database::Actor actor;
    OpenedStudy study;
    StudyProgress progress;
    catalogue::ExerciseLevel level;
    SittingNotes notes;
    FidelityMeter meter;
    const psychophysics::Condition* condition = nullptr;
    LimitedTable table;
    database::StudyRunNumber run = 0;
    std::string sealedCode;
    database::Blinding blinding;
    SampleTap tap;
    std::unique_ptr<LiveTraining> training; ///< declared after the tap because it uses it

    LiveStudyView view;
    LiveStudyNumbers numbers;
    StudyPresentation shown;
    int adjusted = 0; ///< candidate that is currently set
    bool presented = false, posted = false, stopping = false, finishing = false, done = false;
    bool cut = false; ///< the session was cancelled because it did not end on request
    SittingControl control;
    /// A practice answer; stored only after its feedback, because it can be taken back until then.
    std::optional<StudyAnswer> pending;
    bool enough = false;   ///< the participant goes on after it
    double tryFor_s = 0.0; ///< duration of the free minute still to be given; 0: none
    double tried_s = 0.0;  ///< elapsed part of it, in presentations that have ended
    bool tryPresented = false;
    bool readySaid = false, waitsForReady = false;         ///< at the end of the free minute
    bool waitsAfterPractice = false, waitsToCount = false; ///< between practice and the trials that count
    LiveStudyView::Missed missed =
        LiveStudyView::Missed::none; ///< of the trial that was spoiled as untouched
    int answered = -1;
    std::optional<double> value;
    std::string spoiled;
    FidelitySample last;
    std::uint32_t grazed = 0; ///< places in contact in this trial, one bit per place
    int letGo = -1;           ///< the place whose contact ended last in this trial; -1: none
    TrialClock clock;
    Clock::time_point feedbackSince, breakSince, stopSince;
    core::Result<LiveStudyResult> result =
        core::fail(core::ErrorCode::wrongUse, "the sitting has not ended yet");

    static double secondsSince(Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    }

    /// Creates the state of a run that has begun.
    static SittingResult<std::unique_ptr<State>> conducted(database::Database& database,
                                                           const database::Actor& actor,
                                                           const ConductedSitting& sitting,
                                                           LiveStudyRequest request);
    void describeRun(const database::ConductedRun& conducted, const LimitedTable& limited,
                     const RenderingLimits& limits);
    void wantPause(bool wanted);
    void lookAtForce();
    void drain();
    void take(const FidelitySample& sample);
    void noticeLift(const FidelitySample& sample);
    void endTrial(const FidelitySample& sample);
    void store(const StudyAnswer& answer);
    void storePending();
    bool showsFeedback() const;
    bool trying() const { return tryFor_s > 0.0; }
    double triedSoFar_s() const;
    double tryLeft_s() const; ///< 0 once the free minute is over, also while its objects are being removed
    void goOnTrying();
    int mostAlike() const;
    StudyAnswer answerOf(const FidelitySample& sample);
    void note(const database::StudyTrial& trial, const TrialFidelity& fidelity);
    void fail(const core::Error& error);
    void goOn();
    void present();
    void spoilUntouched();
    bool timeIsUp() const;
    LiveStudyView::Missed whatIsMissed() const;
    void finish();
    void conclude();
    void describe();
    LiveStudyView::State where(bool running) const;
    bool allTouched() const;
    bool blind() const { return study.blind(); }
    /// True if forces and felt values would reveal the condition to a blind experimenter.
    bool forcesTell() const { return blinding.on && !blinding.oneStimulus; }
};

} // namespace chiron::session
