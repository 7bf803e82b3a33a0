// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/database.h"
#include "psychophysics/study/study_design.h"
#include "session/live_training.h"
#include "session/study/study_limits.h"
#include "session/study/study_progress.h"

#include <filesystem>
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
    std::filesystem::path ringFolder; ///< empty: the default
    std::optional<double> measuredDelay_s; ///< of the first device, where the station knows it; else statedDelay_s() counts
};

/// Where a sitting stands. The participant's screen shows this and nothing else of the run: no value, level or condition.
struct LiveStudyView {
    enum class State {
        starting,         ///< the session comes up
        coming,           ///< the next objects are on their way; lift the tool off
        arming,           ///< they lie there; force is being armed
        exploring,
        answering,        ///< the time to explore is over, the objects are gone
        feedback,         ///< `right` says it; for a moment
        breakDue,         ///< until breakTaken()
        needsExperimenter,///< one trial was spoiled too often; until experimenterSays()
        paused,
        finished,         ///< the run is done, or stopped; result() says how
    };
    State state = State::starting;
    psychophysics::Task task = psychophysics::Task::rank3;
    int places = 3;
    bool practice = false;
    int trial = 0;        ///< scored ones done
    int ofAtMost = 0;     ///< 0: not known
    int place = -1;       ///< touched now
    std::uint32_t touched = 0;  ///< in this trial, one bit a place
    bool canAnswer = false;     ///< an answer is taken now (every place touched, where that is asked)
    double timeLeft_s = 0.0;    ///< to explore; 0: no limit
    double breakLeft_s = 0.0;   ///< of the shortest break
    std::optional<bool> right;  ///< feedback only
    double adjusted = 0.0;      ///< adjustment: 0..1, where the level stands on its table
};

/// What the experimenter sees beside it.
struct LiveStudyNumbers {
    bool blind = false;      ///< the experimenter is
    std::string condition;   ///< id; the sealed code where the experimenter is blind
    std::string sealedCode;
    std::vector<psychophysics::ProcedureEstimate> estimates; ///< of each procedure; empty where the experimenter is blind
    int scored = 0;
    int spoiled = 0;
    int practice = 0;
    TrialFidelity lastFidelity; ///< without forces where the experimenter is blind to what they are
    std::string lastSpoiled; ///< empty: it counted
    int repeats = 0;         ///< how often the present trial was spoiled
    bool limited = false;    ///< differences were left out, because the device cannot render them
    int candidates = 0;      ///< that are left
    RenderingLimits limits;  ///< of the device that it is done with
};

/// How a sitting ended.
struct LiveStudyResult {
    database::StudyRunNumber run = 0;
    database::SessionId session = 0;
    bool completed = false; ///< else it goes on in another sitting
};

/// A run of a study in real time for a window: LiveTraining underneath, StudyProgress above it, each trial stored as soon as it is
/// answered, so that a stop or a kill loses at most the trial at hand. All of it on the GUI thread; call poll() each frame (it also beats).
/// Destroying it ends the sitting: the run stays open and is resumed at the trial by another sitting.
class LiveStudy {
public:
    /// Failure: notFound (study, participant, condition), notAllowed, wrongUse (not frozen, completed, withdrawn, no consent), badInput.
    static core::Result<std::unique_ptr<LiveStudy>> start(database::Database& database, const database::Actor& actor,
                                                          LiveStudyRequest request);
    LiveStudy(const LiveStudy&) = delete;
    LiveStudy& operator=(const LiveStudy&) = delete;
    ~LiveStudy();

    void poll();
    LiveStudyView view() const;
    LiveStudyNumbers numbers() const;
    const psychophysics::StudyDesign& design() const;
    const psychophysics::Condition& condition() const;
    const catalogue::ExerciseLevel& level() const; ///< for SceneSetup: what the window draws
    LiveTraining& training(); ///< display(), samples(), pointer() of the running session

    /// The participant's answer (psychophysics::answers(task)), or a number said (magnitude), or "set" (adjustment). Failure:
    /// wrongUse while none is taken (canAnswer), badInput.
    core::Result<void> answer(int answer, std::optional<double> value = std::nullopt);
    void adjust(int steps);        ///< adjustment: so many candidates up (down)
    void spoil();                  ///< the experimenter's: this trial does not count and comes again
    void pause();                  ///< wished at once, also before the loop ticks; nothing is presented until resume()
    void resume();
    void breakTaken();             ///< once its shortest time is over
    void experimenterSays(bool goOn);
    void stop();                   ///< ends the sitting; the run is resumed later

    bool finished() const;
    const core::Result<LiveStudyResult>& result() const; ///< once finished(); else wrongUse

private:
    struct State;
    explicit LiveStudy(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace chiron::session
