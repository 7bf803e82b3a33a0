// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/live_study.h"

#include "core/presentation_word.h"
#include "core/random.h"
#include "core/units.h"
#include "database/repositories/study_reader.h"
#include "session/study/fidelity_meter.h"
#include "session/study/study_limits.h"
#include "session/study/study_setup.h"
#include "session/study/study_store.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace chiron::session {

namespace {

using Clock = std::chrono::steady_clock;
using core::CommandKind;
using core::TrialPhase;
using View = LiveStudyView;

constexpr double kFeedback_s = 1.2;
constexpr double kStopPatience_s = 2.0;

/// Hands what a trial's fidelity needs from the haptic thread to the window's. Eight seconds fit.
class SampleTap final : public core::IFrameSink {
public:
    bool tryPush(const core::HapticFrame& frame) noexcept override { return m_ring.tryPush(fidelitySampleOf(frame)); }
    realtime::SpscRing<FidelitySample, 8192>& ring() noexcept { return m_ring; }

private:
    realtime::SpscRing<FidelitySample, 8192> m_ring;
};

double secondsSince(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

} // namespace

struct LiveStudy::State {
    State(database::Database& data, database::Actor who, OpenedStudy opened, StudyProgress begun, catalogue::ExerciseLevel made)
        : database(data), actor(std::move(who)), study(std::move(opened)), progress(std::move(begun)), level(std::move(made)),
          meter(std::get<simulation::ComparisonParameters>(level.parameters), study.design.fidelity, study.design.trial.mustTouchAll) {}

    database::Database& database;
    database::Actor actor;
    OpenedStudy study;
    StudyProgress progress;
    catalogue::ExerciseLevel level;
    FidelityMeter meter;
    const psychophysics::Condition* condition = nullptr;
    LimitedTable table;
    database::StudyRunNumber run = 0;
    std::string sealedCode;
    SampleTap tap;
    std::unique_ptr<LiveTraining> training; ///< after the tap: it uses it

    View view;
    LiveStudyNumbers numbers;
    StudyPresentation shown;
    int adjusted = 0; ///< candidate that is set now
    bool presented = false, posted = false, stopping = false, finishing = false, done = false;
    int answered = -1;
    std::optional<double> value;
    std::string spoiled;
    FidelitySample last;
    std::uint64_t first = 0, lastContact = 0;
    Clock::time_point feedbackSince, breakSince, stopSince;
    core::Result<LiveStudyResult> result = core::fail(core::ErrorCode::wrongUse, "the sitting has not ended yet");

    void drain();
    void take(const FidelitySample& sample);
    void endTrial(const FidelitySample& sample);
    void goOn();
    void present();
    void finish();
    void conclude();
    void describe();
    bool allTouched() const;
};

void LiveStudy::State::drain() {
    FidelitySample sample;
    while (tap.ring().tryPop(sample))
        take(sample);
}

void LiveStudy::State::take(const FidelitySample& sample) {
    constexpr std::uint32_t kEnds = core::event_bits::kCompleted | core::event_bits::kTimedOut | core::event_bits::kFailed;
    last = sample;
    if (sample.events & core::event_bits::kTrialStarted)
        first = lastContact = sample.tick;
    meter.add(sample);
    if (sample.place != 0)
        lastContact = sample.tick;
    if (presented && (sample.events & kEnds))
        endTrial(sample);
}

void LiveStudy::State::endTrial(const FidelitySample& sample) {
    presented = false;
    StudyAnswer answer;
    const bool byButton = !posted && (sample.events & core::event_bits::kCompleted) != 0;
    answer.answer = byButton ? static_cast<int>(sample.answer) - 1 : answered;
    if ((sample.events & core::event_bits::kTimedOut) != 0)
        answer.answer = -1;
    answer.value = value;
    answer.session = training->sessionId();
    answer.firstTick = first;
    answer.lastTick = sample.tick;
    answer.exploration_s = static_cast<double>(sample.tick - first) * core::kTickSeconds;
    answer.answer_s = static_cast<double>(sample.tick - std::min(sample.tick, lastContact)) * core::kTickSeconds;
    answer.fidelity = meter.finish();
    answer.spoiled = spoiled;
    auto trial = progress.record(answer);
    if (!trial) {
        result = tl::unexpected(trial.error());
        finish();
        return;
    }
    trial->run = run;
    if (auto kept = storeTrial(database, actor, *trial); !kept) {
        result = tl::unexpected(kept.error());
        finish();
        return;
    }
    numbers.lastFidelity = answer.fidelity;
    numbers.lastSpoiled = trial->spoiled;
    numbers.practice += trial->practice ? 1 : 0;
    view.right.reset();
    const int correct = psychophysics::correctAnswer(condition->task, trial->arrangement);
    if ((study.design.trial.feedback || trial->practice) && correct >= 0 && trial->answer >= 0 && trial->spoiled.empty()) {
        view.right = trial->answer == correct;
        feedbackSince = Clock::now();
    }
    if (progress.breakDue())
        breakSince = Clock::now();
}

bool LiveStudy::State::allTouched() const {
    const auto every = (1u << static_cast<unsigned>(view.places)) - 1u;
    return !study.design.trial.mustTouchAll || (last.touched & every) == every;
}

/// Between two trials: what comes next.
void LiveStudy::State::goOn() {
    if (stopping && !finishing && secondsSince(stopSince) > kStopPatience_s)
        finishing = training->post(CommandKind::end); // still paused or arming: the session ends as it stands
    if (presented || finishing || last.paused != 0)
        return;
    if (view.right && secondsSince(feedbackSince) < kFeedback_s)
        return;
    view.right.reset();
    if (stopping || progress.done())
        finish();
    else if (!progress.needsExperimenter() && !progress.breakDue() && (last.phase == TrialPhase::idle || last.phase == TrialPhase::between))
        present();
}

void LiveStudy::State::present() {
    shown = progress.next();
    adjusted = shown.candidate;
    meter.begin(shown.values);
    posted = false;
    answered = -1;
    value.reset();
    spoiled.clear();
    presented = training->post(CommandKind::present, core::encode({shown.candidate, shown.arrangement}));
}

void LiveStudy::State::finish() {
    finishing = training->post(CommandKind::answer, simulation::kAnswerFinish);
}

/// The session is stored: the run is ended, or stays open for another sitting.
void LiveStudy::State::conclude() {
    done = true;
    if (!training->result()) {
        result = tl::unexpected(training->result().error());
        return;
    }
    if (!result && result.error().code != core::ErrorCode::wrongUse)
        return; // a trial could not be stored
    LiveStudyResult ended{run, training->result()->session, progress.done() && !stopping};
    if (ended.completed)
        if (auto closed = finishRun(database, actor, study, run); !closed) {
            result = tl::unexpected(closed.error());
            return;
        }
    result = ended;
}

void LiveStudy::State::describe() {
    view.practice = presented && shown.practice;
    view.trial = progress.scored();
    view.ofAtMost = presented ? shown.ofAtMost : view.ofAtMost;
    view.place = static_cast<int>(last.place) - 1;
    view.touched = last.touched;
    const double limit_s = study.design.trial.exploreLimit_s;
    const double spent_s = static_cast<double>(last.tick - std::min(last.tick, first)) * core::kTickSeconds;
    const bool running = presented && last.phase == TrialPhase::running;
    view.timeLeft_s = running && limit_s > 0.0 ? std::max(0.0, limit_s - spent_s) : 0.0;
    view.canAnswer = running && !posted && allTouched();
    view.breakLeft_s = progress.breakDue() ? std::max(0.0, study.design.trial.breakAtLeast_s - secondsSince(breakSince)) : 0.0;
    const auto last_candidate = static_cast<double>(condition->stimulus.differences.size() - 1);
    view.adjusted = last_candidate > 0.0 ? adjusted / last_candidate : 0.0;
    if (done)
        view.state = View::State::finished;
    else if (last.paused != 0)
        view.state = View::State::paused;
    else if (view.right)
        view.state = View::State::feedback;
    else if (!presented && progress.needsExperimenter())
        view.state = View::State::needsExperimenter;
    else if (!presented && progress.breakDue())
        view.state = View::State::breakDue;
    else if (running)
        view.state = limit_s > 0.0 && spent_s >= limit_s ? View::State::answering : View::State::exploring;
    else if (presented && last.phase == TrialPhase::ready)
        view.state = View::State::arming;
    else
        view.state = training->sessionId() == 0 ? View::State::starting : View::State::coming;
    const bool blind = study.design.blindExperimenter && !study.record.summary.unblinded;
    numbers.condition = blind ? sealedCode : condition->id;
    numbers.sealedCode = sealedCode;
    numbers.scored = progress.scored();
    numbers.spoiled = progress.spoiledTrials();
    numbers.repeats = presented ? shown.repeat : 0;
}

LiveStudy::LiveStudy(std::unique_ptr<State> state) : m_state(std::move(state)) {}
LiveStudy::~LiveStudy() = default;

core::Result<std::unique_ptr<LiveStudy>> LiveStudy::start(database::Database& database, const database::Actor& actor,
                                                          LiveStudyRequest request) {
    auto study = openStudy(database, actor, request.study, request.participantCode);
    if (!study)
        return tl::unexpected(study.error());
    const std::vector<std::string> open = openConditions(*study);
    const std::string id = !request.condition.empty() ? request.condition : open.empty() ? std::string() : open.front();
    const psychophysics::Condition* condition = conditionOf(study->design, id);
    if (!condition || std::find(open.begin(), open.end(), id) == open.end())
        return core::fail(condition || open.empty() ? core::ErrorCode::wrongUse : core::ErrorCode::notFound,
                          open.empty() ? "every condition is completed" : "condition \"" + id + "\" is completed, or not one of the study's");
    if (request.station.devices.empty())
        return core::fail(core::ErrorCode::wrongUse, "a sitting needs a device");
    if (auto possible = studyLevel(study->design, *condition); !possible)
        return tl::unexpected(possible.error()); // before a run is begun
    const LimitedTable table = limitedTable(*condition, renderingLimits(request.station.devices.front()->descriptor(), request.delay_s));
    const auto begun = openRun(*study, id);
    if (begun)
        if (auto same = sameTable(*begun, table.limit); !same)
            return tl::unexpected(same.error());
    const std::uint64_t seed = begun ? begun->seed : runSeed(*study, id);
    std::vector<database::StudyTrial> trials;
    if (begun) {
        auto stored = trialsOf(database, actor, begun->id);
        if (!stored)
            return tl::unexpected(stored.error());
        trials = std::move(*stored);
    }
    auto progress = begun ? StudyProgress::resume(study->design, id, seed, trials, StudyProgress::limitOf(begun->procedures))
                          : StudyProgress::begin(study->design, id, seed, table.limit);
    if (!progress)
        return tl::unexpected(progress.error());
    const auto run = begun ? core::Result<database::StudyRun>(*begun) : beginRun(database, actor, *study, id, seed, progress->procedureIds());
    if (!run)
        return tl::unexpected(run.error());
    auto level = studyLevel(study->design, *condition, simulation::ComparisonControl::none, sessionLabel(*study, run->sealedCode));
    if (!level)
        return tl::unexpected(level.error());
    auto state = std::make_unique<State>(database, actor, std::move(*study), std::move(*progress), std::move(*level));
    state->condition = conditionOf(state->study.design, id);
    state->run = run->id;
    state->sealedCode = run->sealedCode;
    state->table = table;
    state->numbers.limited = std::isfinite(table.limit);
    state->numbers.candidates = table.candidates;
    state->view.task = state->condition->task;
    state->view.places = psychophysics::placesOf(state->condition->task);
    TrainingRequest training;
    training.level = state->level;
    training.seed = core::Random::mix(seed, "sitting " + std::to_string(trials.size())) >> 1;
    training.station = std::move(request.station);
    training.ringFolder = request.ringFolder;
    training.witness = &state->tap;
    auto live = LiveTraining::start(database, actor, std::move(training));
    if (!live)
        return tl::unexpected(live.error());
    state->training = std::move(*live);
    state->training->post(CommandKind::start);
    return std::unique_ptr<LiveStudy>(new LiveStudy(std::move(state)));
}

void LiveStudy::poll() {
    State& s = *m_state;
    if (s.done)
        return;
    s.training->beat();
    s.drain();
    s.goOn();
    if (s.training->finished())
        s.conclude();
}

LiveStudyView LiveStudy::view() const {
    m_state->describe();
    return m_state->view;
}

LiveStudyNumbers LiveStudy::numbers() const {
    m_state->describe();
    LiveStudyNumbers out = m_state->numbers;
    if (!m_state->study.design.blindExperimenter || m_state->study.record.summary.unblinded)
        out.estimates = m_state->progress.estimates();
    return out;
}

const psychophysics::StudyDesign& LiveStudy::design() const { return m_state->study.design; }
const psychophysics::Condition& LiveStudy::condition() const { return *m_state->condition; }
const catalogue::ExerciseLevel& LiveStudy::level() const { return m_state->level; }
LiveTraining& LiveStudy::training() { return *m_state->training; }

core::Result<void> LiveStudy::answer(int answer, std::optional<double> value) {
    State& s = *m_state;
    s.describe();
    if (!s.view.canAnswer)
        return core::fail(core::ErrorCode::wrongUse, "no answer is taken now");
    const psychophysics::Task task = s.condition->task;
    if (answer < 0 || answer >= psychophysics::answers(task) || (task == psychophysics::Task::magnitude && (!value || !(*value > 0.0))))
        return core::fail(core::ErrorCode::badInput, "an answer of the task is expected, and a number above 0 where one is said");
    s.answered = answer;
    s.value = value;
    if (task == psychophysics::Task::adjustment)
        s.value = s.condition->stimulus.reference *
                  std::pow(10.0, s.condition->stimulus.differences[static_cast<std::size_t>(s.adjusted)]);
    s.posted = s.training->post(CommandKind::answer, static_cast<std::uint16_t>(answer));
    return {};
}

void LiveStudy::adjust(int steps) {
    State& s = *m_state;
    if (s.condition->task != psychophysics::Task::adjustment || !s.presented || s.posted)
        return;
    const int most = static_cast<int>(s.condition->stimulus.differences.size()) - 1;
    const int wanted = std::clamp(s.adjusted + steps, 0, most);
    if (std::abs(s.condition->stimulus.differences[static_cast<std::size_t>(wanted)]) > s.table.limit)
        return; // the device renders no more
    s.adjusted = wanted;
    s.training->post(CommandKind::present, core::encode({wanted, s.shown.arrangement}));
}

void LiveStudy::spoil() {
    State& s = *m_state;
    if (!s.presented || s.last.phase != TrialPhase::running || s.posted)
        return;
    s.spoiled = "experimenter";
    s.posted = s.training->post(CommandKind::answer, simulation::kAnswerSpoiled);
}

void LiveStudy::pause() { m_state->training->post(CommandKind::pause); }
void LiveStudy::resume() { m_state->training->post(CommandKind::resume); }

void LiveStudy::breakTaken() {
    State& s = *m_state;
    if (s.progress.breakDue() && secondsSince(s.breakSince) >= s.study.design.trial.breakAtLeast_s)
        s.progress.breakTaken();
}

void LiveStudy::experimenterSays(bool goOn) {
    m_state->progress.experimenterSays(goOn);
    m_state->stopping = m_state->stopping || !goOn; // the run stays open: another sitting may go on with it
}

void LiveStudy::stop() {
    State& s = *m_state;
    s.stopping = true;
    s.stopSince = Clock::now();
    if (s.last.paused != 0)
        s.training->post(CommandKind::resume); // else the scene hears no answer
    if (s.presented && s.last.phase == TrialPhase::running && !s.posted) {
        s.spoiled = "stopped";
        s.posted = s.training->post(CommandKind::answer, simulation::kAnswerSpoiled);
    } else if (s.presented) {
        s.presented = false; // never begun: nothing is stored of it
        s.finish();
    }
}

bool LiveStudy::finished() const { return m_state->done; }
const core::Result<LiveStudyResult>& LiveStudy::result() const { return m_state->result; }

} // namespace chiron::session
