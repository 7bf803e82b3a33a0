// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/session/apex_tap.h"
#include "app/exercises/sphere_apex/session/apex_watch.h"
#include "app/exercises/sphere_apex/session/live_apex.h"
#include "database/repositories/study_blinding.h"
#include "session/study/begun_run.h"
#include "session/study/sitting_control.h"
#include "session/study/sitting_notes.h"

#include <chrono>

namespace chiron::session {

/// The state of a run of the apex study between two polls by the window.
/// Thread: GUI.
struct LiveApex::State {
    using Clock = std::chrono::steady_clock;

    State(database::Database& data, database::Actor who, const ConductedSitting& sitting, BegunRun begun,
          std::string language)
        : database(data), actor(std::move(who)), study(sitting.study), run(begun.number), runSeed(begun.seed),
          sealedCode(sitting.run.sealedCode), progress(std::move(begun.progress)), trials(sitting.run.trials),
          notes(std::move(language)) {}

    database::Database& database;
    database::Actor actor;
    OpenedStudy study;
    database::StudyRunNumber run = 0;
    std::uint64_t runSeed = 0;
    std::string sealedCode;
    database::Blinding blinding;
    StudyProgress progress;
    std::vector<database::StudyTrial> trials; ///< all trials of the run, as stored
    SittingNotes notes;
    const psychophysics::Condition* condition = nullptr;
    std::function<core::Result<Station>()> nextStation;
    std::filesystem::path ringFolder;

    catalogue::ExerciseLevel level;
    std::optional<ApexWatch> watch;
    std::unique_ptr<ApexTap> tap;
    std::unique_ptr<LiveTraining> training; ///< declared after the tap because it uses it
    std::unique_ptr<ApexTap> tapBefore;
    std::unique_ptr<LiveTraining> before; ///< the previous session, kept until the window no
                                          ///< longer uses its pointer
    int sessions = 0;
    std::size_t presented = 0; ///< in the current session

    SittingControl control;
    LiveStudyView view;
    LiveStudyNumbers numbers;
    FidelitySample last;
    bool lost = false; ///< ticks of the current trial were lost
    bool stopping = false, ending = false, waits = false, done = false;
    std::string spoiled;
    std::optional<StudyAnswer> pending; ///< duration of the free minute, if the current session is the one;
                                        ///< 0: it is not
    bool enough = false;
    double tryFor_s = 0.0; ///< duration of the free practice minute, if the current session is one
    double tried_s = 0.0;
    bool tries = false;                                    ///< in this session, the free minute is running
    bool readySaid = false, waitsForReady = false;         ///< at the end of the free minute
    bool waitsAfterPractice = false, waitsToCount = false; ///< between practice and the trials that count
    Clock::time_point feedbackSince, breakSince;
    core::Result<LiveStudyResult> result =
        core::fail(core::ErrorCode::wrongUse, "the sitting has not ended yet");

    static double secondsSince(Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    }

    core::Result<void> beginSession(Station station);
    void drain();
    void take(const ApexTick& tick);
    void record(StudyAnswer answer);
    void store(const StudyAnswer& answer);
    void storePending();
    bool feedbackOver() const;
    double triedSoFar_s() const;
    double tryLeft_s() const; ///< 0 once the free minute is over, also while its session is ending
    void note(const TrialFidelity& fidelity);
    void summarise();
    void goOn();
    void endSession();
    void sessionEnded();
    void goOnWithNext();
    /// `byItself`: nobody stopped the run, and another session would end in the same way.
    void conclude(bool byItself = false);
    void fail(const core::Error& error);
    bool heldBetween() const;
    void describe();
    LiveStudyView::State where() const;
    /// Creates the state of a run that has begun.
    static SittingResult<std::unique_ptr<State>> conducted(database::Database& database,
                                                           const database::Actor& actor,
                                                           const ConductedSitting& sitting,
                                                           LiveStudyRequest request);
    /// True if forces and felt values would reveal the condition to a blind experimenter.
    bool forcesTell() const { return blinding.on && !blinding.oneStimulus; }
};

} // namespace chiron::session
