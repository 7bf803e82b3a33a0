// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/database.h"
#include "psychophysics/study/apex_study.h"
#include "psychophysics/study/study_design.h"
#include "session/live_training.h"
#include "session/study/study_limits.h"
#include "session/study/study_progress.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// A request to begin or resume one participant's run of one condition in a window.
struct LiveStudyRequest {
    database::StudyNumber study = 0;
    std::string participantCode;
    /// Id, or sealed code while blinded; empty: the next condition in the participant's order that is not
    /// completed.
    std::string condition;
    Station station;
    /// Provides the same device again if a run takes several sessions (MarkSessions); empty: only one
    /// session, and the run stays open.
    std::function<core::Result<Station>()> nextStation;
    std::filesystem::path ringFolder; ///< empty: the default
    /// Delay of the first device, if the station knows it; otherwise statedDelay_s() applies.
    std::optional<double> measuredDelay_s;
    /// Duration of the free minute before the first trial of a run, in which the participant tries the
    /// controls on objects that are nearly alike. It is recorded but belongs to no trial. A resumed run has
    /// none. 0: none.
    double freeMinute_s = 0.0;
    /// If true, the run waits for beginCounting() between practice and the first trial that counts; otherwise
    /// the trials follow at once.
    bool waitsAfterPractice = false;
    std::string language; ///< language of the participant; stored with each trial
};

/// The state of a run. The participant's screen shows nothing else of the run: no value, level or condition.
struct LiveStudyView {
    enum class State {
        starting,  ///< the session is starting
        trying,    ///< the free minute, until endTrying() or its end
        tried,     ///< the free minute is over; the trials begin with endTrying()
        practised, ///< practice is over; the trials that count begin with beginCounting()
        coming,    ///< the next objects are being placed; the tool must be lifted off
        arming,    ///< the objects are in place; force is being armed
        exploring,
        answering,         ///< the time to explore is over, the objects are gone
        feedback,          ///< `right` holds the result; for a moment, in practice until goOn() or takeBack()
        breakDue,          ///< until breakTaken()
        needsExperimenter, ///< one trial was spoiled too often; until experimenterSays()
        paused,
        stopped,  ///< force was stopped, by a person or by the supervisor; until rearm()
        finished, ///< the run is done or stopped; see result()
    };
    /// Where an object is on its way from the table and back (Attribute::mass): the steps follow each other,
    /// and after the last one the tool lets go of it. They follow from the hand's motion alone, and tell
    /// nothing of how heavy the object is.
    enum class Lift {
        none,   ///< the tool holds no object
        held,   ///< it stands on the table, and was not lifted enough to be put down
        raised, ///< in the air
        stands, ///< it stands on the table again, and is still held
        pressed ///< pressed onto the table: the tool lets go as soon as it is raised
    };
    /// Why an object did not count as touched when the time to explore was over.
    enum class Missed {
        none,     ///< not known, or every object counted
        never,    ///< the tool never met one of the objects
        tooLight, ///< it met every object; one of them with less than probe_N, or without lifting it
        held      ///< it still held an object that counted, so that it could not reach the others
    };
    State state = State::starting;
    Lift lift = Lift::none;
    double lift_m = 0.0; ///< of the held object above the table; negative: pressed onto it
    psychophysics::Task task = psychophysics::Task::rank3;
    int places = 3;
    bool practice = false;     ///< the present trial, or between two trials the next one, does not count
    bool firstPart = true;     ///< the participant has completed no other condition of the study
    int partsToCome = 0;       ///< conditions of the study that they have not completed, besides this one
    int trial = 0;             ///< scored trials done
    int ofAtMost = 0;          ///< 0: not known
    int place = -1;            ///< place in contact now
    int letGo = -1;            ///< place that was in contact last in this trial, if none is now; -1: none
    std::uint32_t touched = 0; ///< in this trial, one bit per place
    std::uint32_t grazed = 0;  ///< places that were in contact in this trial, however lightly, one bit per
                               ///< place
    /// A place counts as touched once its object has responded with at least this force; 0: at any contact.
    double probe_N = 0.0;
    /// The hand uses nearly the largest force that a trial may have, or did so in this trial: from then on
    /// until the trial ends, so that it tells nothing about the object that is touched now
    /// (FidelityMeter::cameNearForceLimit). In the free minute only while it does.
    bool nearForceLimit = false;
    /// The reason why the previous trial ended without an answer ("untouched", "time", "experimenter"), in
    /// practice as well; empty: it had one.
    std::string unanswered;
    Missed missed = Missed::none; ///< what was wrong with an "untouched" one
    /// The reason why the previous trial, which was no practice trial, did not count; shown during the next
    /// one. It reveals nothing about the correctness of an answer.
    std::string repeated;
    /// The reason in the hand's motion why the previous trial did not count: "peak_force" or "speed"; else
    /// empty.
    std::string hand;
    bool mayTakeBack = false; ///< an answer in practice can be taken back; nothing goes on by itself
    int practiceAnswer = -1;  ///< the answer that can be taken back; -1: none, or a mark
    std::optional<double> practiceValue; ///< the stated number that can be taken back (magnitude)
    double tryLeft_s = 0.0;              ///< remaining time of the free minute
    bool canAnswer = false;    ///< an answer is accepted now (every place was touched, if that is required)
    double timeLeft_s = 0.0;   ///< remaining time to explore; 0: no limit
    double breakLeft_s = 0.0;  ///< remaining time of the shortest break
    std::optional<bool> right; ///< only during feedback
    std::optional<double> beside_m; ///< feedback on a mark: its distance from the true place
    double adjusted = 0.0;          ///< adjustment: 0..1, position of the level in its table
};

/// The additional data that the experimenter sees.
struct LiveStudyNumbers {
    std::string condition; ///< id; the sealed code if the experimenter is blind
    std::string sealedCode;
    /// One per procedure; empty if the experimenter is blind.
    std::vector<psychophysics::ProcedureEstimate> estimates;
    int scored = 0;
    int spoiled = 0; ///< repeated trials (database::isRepeated)
    int practice = 0;
    bool blind = false;         ///< the experimenter is blind
    TrialFidelity lastFidelity; ///< without forces, if they must not be revealed to the experimenter
    std::string lastSpoiled;    ///< empty: the trial counted
    int repeats = 0;            ///< number of times that the current trial was spoiled
    bool limited = false;       ///< differences were left out because the device cannot render them
    int candidates = 0;         ///< number of candidates left
    RenderingLimits limits;     ///< of the current device
    /// Study of the apex: summary of this run's marks so far; empty if the experimenter is blind.
    std::optional<psychophysics::ApexSummary> apex;
    bool spoiling = false; ///< the current trial will not count, whatever happens
};

/// The result of a run in a window.
struct LiveStudyResult {
    database::StudyRunNumber run = 0;
    database::SessionId session = 0;
    bool completed = false; ///< if false, the run can be resumed later
    /// Nobody stopped the run, and trials were left: a session ended by itself, and another one would end in
    /// the same way.
    bool endedByItself = false;
};

/// A sphere that the device cannot render stably. If experimenters are blind, it is the stiffest of all
/// conditions.
struct TooStiff {
    double sphere_N_per_m = 0.0;
    double device_N_per_m = 0.0;
};

/// Other reasons for refusing a device.
enum class DeviceRefusal {
    /// It renders no difference of the condition or, if experimenters are blind, none of another condition
    /// with the same table.
    rendersNone,
    rendersLess ///< it renders less than the device on which the run began, so the run cannot continue on it
};

/// The reason why a run does not begin. For some reasons it carries typed data, for which the window has its
/// own words.
struct SittingError : core::Error {
    // Not explicit, so that every core::Error converts to it.
    SittingError(core::Error error) : core::Error(std::move(error)) {}
    std::optional<TooStiff> tooStiff;
    std::optional<DeviceRefusal> device;
    bool otherVersion = false; ///< the run began with other versions of its procedures
};
template <class T> using SittingResult = tl::expected<T, SittingError>;

/// A run of a study in real time in a window, for any task. Each trial is stored as soon as it is answered,
/// so that a stop or a kill loses at most the current trial. Call poll() each frame; it also sends the
/// heartbeat. Destroying the object stops the run, which stays open and can be resumed at the same trial.
/// Thread: GUI.
class LiveSitting {
public:
    /// Begins or resumes a run: of comparisons (LiveStudy) or of marks (MarkSessions), depending on the
    /// condition.
    /// Errors: notFound (study, participant, condition); notAllowed; wrongUse (not frozen, completed,
    ///   withdrawn, no consent); badInput (cannot be made, or not be rendered by the device).
    static SittingResult<std::unique_ptr<LiveSitting>>
    start(database::Database& database, const database::Actor& actor, LiveStudyRequest request);
    LiveSitting(const LiveSitting&) = delete;
    LiveSitting& operator=(const LiveSitting&) = delete;
    virtual ~LiveSitting() = default;

    virtual void poll() = 0;
    virtual LiveStudyView view() const = 0;
    virtual LiveStudyNumbers numbers() const = 0;
    virtual const psychophysics::StudyDesign& design() const = 0;
    virtual const psychophysics::Condition& condition() const = 0;
    /// For SceneSetup: the level that the window draws.
    virtual const catalogue::ExerciseLevel& level() const = 0;
    /// display(), samples(), pointer() of the running session. It is another object (with another pointer)
    /// once sessions() has increased.
    virtual LiveTraining& training() = 0;
    virtual int sessions() const = 0; ///< sessions begun since start()

    /// Gives the participant's answer (psychophysics::answers(task)), or a stated number (magnitude), or
    /// "set" (adjustment).
    /// Errors: wrongUse while no answer is accepted (canAnswer); badInput.
    virtual core::Result<void> answer(int answer, std::optional<double> value = std::nullopt) = 0;
    virtual void adjust(int) {} ///< adjustment: moves this many candidates up (negative: down)
    /// The first key or click of an answer: its tick is stored; later calls in the same trial change nothing.
    virtual void beginAnswer() = 0;
    /// Practice: the last answer does not count, and its presentation is repeated (view().mayTakeBack).
    virtual void takeBack() = 0;
    virtual void goOn() = 0;          ///< practice: ends the feedback, which nothing else ends
    virtual void endTrying() = 0;     ///< ends the free minute
    virtual void beginCounting() = 0; ///< the participant has read that practice is over
    /// TrialCircumstances::kMasking...: the masking sound that is heard from now on.
    virtual void setMasking(const std::string& what) = 0;
    virtual void spoil() = 0; ///< by the experimenter: this trial does not count and is repeated
    /// Takes effect at once, also before the loop ticks; nothing is presented until resume().
    virtual void pause() = 0;
    virtual void resume() = 0;     ///< has no effect while force is stopped: that takes rearm()
    virtual void stopForce() = 0;  ///< at once; stops the trial's clock as well
    virtual void rearm() = 0;      ///< after a stop or a fault: force returns slowly, and the trial continues
    virtual void breakTaken() = 0; ///< only once the shortest break is over
    virtual void experimenterSays(bool goOn) = 0;
    virtual void stop() = 0; ///< stops the run, which can be resumed later

    virtual bool finished() const = 0;
    virtual const core::Result<LiveStudyResult>& result() const = 0; ///< valid once finished(); else wrongUse

protected:
    LiveSitting() = default;
};

} // namespace chiron::session
