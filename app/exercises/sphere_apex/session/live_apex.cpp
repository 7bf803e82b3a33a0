// SPDX-License-Identifier: GPL-3.0-or-later
// The start of a run of the apex study, and the interface for the window. live_apex_state.cpp has the
// processing of ticks.
#include "app/exercises/sphere_apex/session/live_apex_state.h"

#include "app/exercises/sphere_apex/session/apex_sessions.h"
#include "session/study/study_setup.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

/// The stiffest sphere of a condition. If the experimenter is blind, the stiffest of all conditions, because
/// a refusal would otherwise reveal the condition.
core::Result<double> stiffest(const OpenedStudy& study, const psychophysics::Condition& condition) {
    double stiffness = 0.0;
    for (const psychophysics::Condition& each : study.design.conditions) {
        if (each.id != condition.id && !(study.blind() && looksForApex(each)))
            continue;
        const auto level = ApexSessions().level(study.design, each, 1, {});
        CHIRON_TRY(level);
        stiffness = std::max(stiffness,
                             level->parameters.as<simulation::SphereApexParameters>().stiffnessHigh_N_per_m);
    }
    return stiffness;
}

SittingResult<void> renderable(const OpenedStudy& study, const psychophysics::Condition& condition,
                               const RenderingLimits& limits) {
    const auto stiffness = stiffest(study, condition);
    CHIRON_TRY(stiffness);
    if (*stiffness <= limits.largestStiffness_N_per_m)
        return {};
    SittingError error({core::ErrorCode::badInput,
                        "a sphere of " + std::to_string(std::lround(*stiffness)) +
                            " N/m, and the device renders " +
                            std::to_string(std::lround(limits.largestStiffness_N_per_m)) + " N/m at most"});
    error.tooStiff = {*stiffness, limits.largestStiffness_N_per_m};
    return tl::unexpected(std::move(error));
}

} // namespace

LiveApex::LiveApex(std::unique_ptr<State> state) : m_state(std::move(state)) {}
LiveApex::~LiveApex() = default;

SittingResult<std::unique_ptr<LiveApex>> LiveApex::start(database::Database& database,
                                                         const database::Actor& actor,
                                                         const ConductedSitting& sitting,
                                                         LiveStudyRequest request) {
    auto state = State::conducted(database, actor, sitting, std::move(request));
    if (!state)
        return tl::unexpected(sealed(sitting, state.error()));
    return std::unique_ptr<LiveApex>(new LiveApex(std::move(*state)));
}

SittingResult<std::unique_ptr<LiveApex::State>> LiveApex::State::conducted(database::Database& database,
                                                                           const database::Actor& actor,
                                                                           const ConductedSitting& sitting,
                                                                           LiveStudyRequest request) {
    const OpenedStudy& study = sitting.study;
    const psychophysics::Condition& condition = *sitting.condition();
    const RenderingLimits limits =
        limitsAt(request.station.tools.front().device->descriptor(), request.measuredDelay_s);
    CHIRON_TRY(renderable(study, condition, limits)); // before a run begins
    const LimitedTable table =
        study.blind() ? blindTable(study.design, condition, limits) : limitedTable(condition, limits);
    auto begun = beginOrGoOn(database, actor, sitting, table.limit);
    CHIRON_TRY(begun);
    auto state = std::make_unique<State>(database, actor, sitting, std::move(*begun), request.language);
    state->waitsAfterPractice = request.waitsAfterPractice;
    state->view.firstPart = study.firstPart(sitting.label);
    state->view.partsToCome = study.partsBeside(sitting.label);
    state->blinding = study.record.blinding;
    state->condition = conditionOf(state->study.design, sitting.run.condition);
    state->nextStation = std::move(request.nextStation);
    state->ringFolder = std::move(request.ringFolder);
    state->numbers.limits = limits;
    state->numbers.candidates = table.candidates;
    state->view.task = state->condition->task;
    state->view.places = 1;
    state->summarise();
    if (sitting.run.trials.empty() && state->nextStation) // the free minute takes a session of its own
        state->tryFor_s = request.freeMinute_s;
    CHIRON_TRY(state->beginSession(std::move(request.station)));
    return state;
}

void LiveApex::poll() {
    State& s = *m_state;
    if (s.done)
        return;
    s.training->beat();
    if (!s.stopping)
        s.control.look(s.training->display().latest());
    s.drain();
    s.goOn();
    s.control.tell(*s.training);
    if (!s.waits && s.training->finished())
        s.sessionEnded();
    else if (s.waits)
        s.goOnWithNext();
}

LiveStudyView LiveApex::view() const {
    m_state->describe();
    return m_state->view;
}

LiveStudyNumbers LiveApex::numbers() const {
    m_state->describe();
    return m_state->numbers;
}

const psychophysics::StudyDesign& LiveApex::design() const {
    return m_state->study.design;
}
const psychophysics::Condition& LiveApex::condition() const {
    return *m_state->condition;
}
const catalogue::ExerciseLevel& LiveApex::level() const {
    return m_state->level;
}
LiveTraining& LiveApex::training() {
    return *m_state->training;
}
int LiveApex::sessions() const {
    return m_state->sessions;
}

core::Result<void> LiveApex::answer(int answer, std::optional<double>) {
    State& s = *m_state;
    s.describe();
    if (!s.view.canAnswer || answer != 0)
        return core::fail(core::ErrorCode::wrongUse, "no mark is taken now");
    s.notes.answerBegins(s.last.tick);
    s.training->post(core::CommandKind::mark);
    return {};
}

void LiveApex::beginAnswer() {} // a mark is a single press

void LiveApex::takeBack() {
    State& s = *m_state;
    if (!s.pending)
        return;
    s.pending->answer = -1;
    s.pending->value.reset();
    s.pending->fidelity.apex.reset();
    s.pending->spoiled = "taken_back";
    s.storePending();
}

void LiveApex::goOn() {
    m_state->enough = m_state->pending.has_value();
}

void LiveApex::endTrying() {
    m_state->readySaid = true;
    m_state->waitsForReady = false;
    if (m_state->tries)
        m_state->tried_s = m_state->tryFor_s;
}

void LiveApex::beginCounting() {
    m_state->waitsToCount = false;
}

void LiveApex::setMasking(const std::string& what) {
    m_state->notes.hear(what);
}

void LiveApex::spoil() {
    if (m_state->watch->inTrial())
        m_state->spoiled = "experimenter";
}

void LiveApex::pause() {
    m_state->control.wantPause(!m_state->stopping);
}
void LiveApex::resume() {
    m_state->control.wantPause(false);
}

void LiveApex::stopForce() {
    m_state->control.stopForce();
    m_state->control.tell(*m_state->training);
}

void LiveApex::rearm() {
    m_state->control.rearm();
}

void LiveApex::breakTaken() {
    State& s = *m_state;
    if (s.progress.breakDue() && State::secondsSince(s.breakSince) >= s.study.design.trial.breakAtLeast_s)
        s.progress.breakTaken();
}

void LiveApex::experimenterSays(bool goOn) {
    if (goOn)
        m_state->progress.experimenterSays(true);
    else
        stop(); // the run stays open and can be resumed later
}

void LiveApex::stop() {
    State& s = *m_state;
    if (s.done || s.stopping)
        return;
    s.drain(); // a mark already set counts
    s.storePending();
    s.stopping = true;
    // A sphere that was already explored is not presented again.
    if (!s.done && !s.tries && s.watch->inTrial()) {
        s.spoiled = database::kInterrupted;
        s.record(s.watch->soFar());
    }
}

bool LiveApex::finished() const {
    return m_state->done;
}
const core::Result<LiveStudyResult>& LiveApex::result() const {
    return m_state->result;
}

} // namespace chiron::session
