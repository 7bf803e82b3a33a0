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

/// One sitting of one participant at one condition, in a window.
struct LiveStudyRequest {
    database::StudyNumber study = 0;
    std::string participantCode;
    std::string condition; ///< id, or sealed code while blinded; empty: the participant's next one in the order that is not completed
    Station station;
    /// The same device again, where a sitting takes several sessions (a study of the apex); empty: one session, and the run stays open.
    std::function<core::Result<Station>()> nextStation;
    std::filesystem::path ringFolder; ///< empty: the default
    std::optional<double> measuredDelay_s; ///< of the first device, where the station knows it; else statedDelay_s() counts
    /// A free minute before the first trial of a run, to try the controls on objects that are nearly alike: recorded, of no trial. Not in a
    /// run that is gone on with. 0: none.
    double freeMinute_s = 0.0;
    /// Between practice and the first trial that counts it waits for beginCounting(); else the trials follow at once.
    bool waitsAfterPractice = false;
    std::string language; ///< that the participant reads; kept with each trial
};

/// Where a sitting stands. The participant's screen shows this and nothing else of the run: no value, level or condition.
struct LiveStudyView {
    enum class State {
        starting,         ///< the session comes up
        trying,           ///< the free minute; until endTrying() or its end
        tried,            ///< it is over; the trials begin with endTrying()
        practised,        ///< practice is over; the trials that count begin with beginCounting()
        coming,           ///< the next objects are on their way; lift the tool off
        arming,           ///< they lie there; force is being armed
        exploring,
        answering,        ///< the time to explore is over, the objects are gone
        feedback,         ///< `right` says it; for a moment
        breakDue,         ///< until breakTaken()
        needsExperimenter,///< one trial was spoiled too often; until experimenterSays()
        paused,
        stopped,          ///< force was stopped, or taken away: until rearm()
        finished,         ///< the run is done, or stopped; result() says how
    };
    State state = State::starting;
    psychophysics::Task task = psychophysics::Task::rank3;
    int places = 3;
    bool practice = false;
    bool firstPart = true; ///< the participant has completed no other condition of the study
    int trial = 0;        ///< scored ones done
    int ofAtMost = 0;     ///< 0: not known
    int place = -1;       ///< touched now
    std::uint32_t touched = 0;  ///< in this trial, one bit a place
    std::uint32_t grazed = 0;   ///< places that were in contact in this trial, however lightly, one bit each
    double probe_N = 0.0;       ///< a place counts as touched once its object answered with so much; 0: at any touch
    bool again = false;         ///< the trial before did not count, as its objects were gone before all were touched: it comes again
    /// Why the trial before, which was no practice, did not count; told while the next one runs. Of any answer, right or wrong, it says nothing.
    std::string repeated;
    std::string hand; ///< what the hand did in the trial before, for which it does not count: "peak_force" or "speed"; else empty
    bool mayTakeBack = false;   ///< an answer of practice, while its feedback is shown
    double tryLeft_s = 0.0;     ///< of the free minute
    bool canAnswer = false;     ///< an answer is taken now (every place touched, where that is asked)
    double timeLeft_s = 0.0;    ///< to explore; 0: no limit
    double breakLeft_s = 0.0;   ///< of the shortest break
    std::optional<bool> right;  ///< feedback only
    std::optional<double> beside_m; ///< feedback of a study of the apex: how far from it the mark lies
    double adjusted = 0.0;      ///< adjustment: 0..1, where the level stands on its table
};

/// Feedback in practice: long enough to see that one was mistaken, and to take the answer back.
inline constexpr double kPracticeFeedback_s = 4.0;

/// What the experimenter sees beside it.
struct LiveStudyNumbers {
    std::string condition;   ///< id; the sealed code where the experimenter is blind
    std::string sealedCode;
    std::vector<psychophysics::ProcedureEstimate> estimates; ///< of each procedure; empty where the experimenter is blind
    int scored = 0;
    int spoiled = 0;
    int practice = 0;
    bool blind = false;      ///< the experimenter is
    TrialFidelity lastFidelity; ///< without forces where the experimenter is blind to what they are
    std::string lastSpoiled; ///< empty: it counted
    int repeats = 0;         ///< how often the present trial was spoiled
    bool limited = false;    ///< differences were left out, because the device cannot render them
    int candidates = 0;      ///< that are left
    RenderingLimits limits;  ///< of the device that it is done with
    std::optional<psychophysics::ApexSummary> apex; ///< of a study of the apex: this run's marks so far; nothing where the experimenter is blind
    bool spoiling = false;   ///< the trial at hand will not count, whatever comes
};

/// How a sitting ended.
struct LiveStudyResult {
    database::StudyRunNumber run = 0;
    database::SessionId session = 0;
    bool completed = false; ///< else it goes on in another sitting
};

/// A sphere that the device cannot render stably. Where experimenters are blind it is the stiffest of all conditions.
struct TooStiff {
    double sphere_N_per_m = 0.0;
    double device_N_per_m = 0.0;
};

/// What else a device is refused for.
enum class DeviceRefusal {
    rendersNone, ///< no difference of the condition, or where experimenters are blind none of those of another with the same table
    rendersLess  ///< than the device that the run was begun on, which it goes on with
};

/// Why a sitting does not begin: in a word that a window has words of its own for, where there is one.
struct SittingError : core::Error {
    SittingError(core::Error error) : core::Error(std::move(error)) {} // not explicit: whatever fails on the way is one
    std::optional<TooStiff> tooStiff;
    std::optional<DeviceRefusal> device;
    bool otherVersion = false; ///< the run was begun with other versions of its procedures
};
template <class T>
using SittingResult = tl::expected<T, SittingError>;

/// A run of a study in real time for a window, whatever is asked: each trial is stored as soon as it is answered, so that a stop or a kill
/// loses at most the trial at hand. All of it on the GUI thread; call poll() each frame (it also beats). Destroying it ends the sitting:
/// the run stays open and is resumed at the trial by another sitting.
class LiveSitting {
public:
    /// Begins one, or goes on with one: of comparisons (LiveStudy) or of marks (MarkSessions), as the condition has it. Failure: notFound
    /// (study, participant, condition), notAllowed, wrongUse (not frozen, completed, withdrawn, no consent), badInput (what cannot be
    /// made, or not be rendered by the device).
    static SittingResult<std::unique_ptr<LiveSitting>> start(database::Database& database, const database::Actor& actor,
                                                             LiveStudyRequest request);
    LiveSitting(const LiveSitting&) = delete;
    LiveSitting& operator=(const LiveSitting&) = delete;
    virtual ~LiveSitting() = default;

    virtual void poll() = 0;
    virtual LiveStudyView view() const = 0;
    virtual LiveStudyNumbers numbers() const = 0;
    virtual const psychophysics::StudyDesign& design() const = 0;
    virtual const psychophysics::Condition& condition() const = 0;
    virtual const catalogue::ExerciseLevel& level() const = 0; ///< for SceneSetup: what the window draws
    /// display(), samples(), pointer() of the running session; another one (and another pointer) once sessions() has grown.
    virtual LiveTraining& training() = 0;
    virtual int sessions() const { return 1; } ///< begun in this sitting

    /// The participant's answer (psychophysics::answers(task)), or a number said (magnitude), or "set" (adjustment). Failure:
    /// wrongUse while none is taken (canAnswer), badInput.
    virtual core::Result<void> answer(int answer, std::optional<double> value = std::nullopt) = 0;
    virtual void adjust(int) {}   ///< adjustment: so many candidates up (down)
    virtual void beginAnswer() = 0; ///< the first key or click of an answer: its moment is kept; later ones of the same trial change nothing
    virtual void takeBack() = 0;  ///< practice: the answer just given does not count, and its presentation comes again (view().mayTakeBack)
    virtual void goOn() = 0;      ///< practice: enough of the feedback
    virtual void endTrying() = 0; ///< the free minute is over
    virtual void beginCounting() = 0; ///< it was read that practice is over
    virtual void setMasking(const std::string& what) = 0; ///< TrialCircumstances::kMasking...: what is heard from now on
    virtual void spoil() = 0;     ///< the experimenter's: this trial does not count and comes again
    virtual void pause() = 0;     ///< wished at once, also before the loop ticks; nothing is presented until resume()
    virtual void resume() = 0;    ///< nothing while force is stopped: that takes rearm()
    virtual void stopForce() = 0; ///< at once; the clock stands still with it
    virtual void rearm() = 0;     ///< after a stop or a fault: force comes back slowly, and the trial goes on
    virtual void breakTaken() = 0; ///< once its shortest time is over
    virtual void experimenterSays(bool goOn) = 0;
    virtual void stop() = 0;      ///< ends the sitting; the run is resumed later

    virtual bool finished() const = 0;
    virtual const core::Result<LiveStudyResult>& result() const = 0; ///< once finished(); else wrongUse

protected:
    LiveSitting() = default;
};

} // namespace chiron::session
