// SPDX-License-Identifier: GPL-3.0-or-later
// The window's interface to a run of comparisons. live_study_start.cpp has its start, live_study_state.cpp
// the processing of ticks.
#include "session/study/live_study.h"

#include "core/presentation_word.h"
#include "session/study/live_study_state.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

using core::CommandKind;
using core::TrialPhase;

LiveStudy::LiveStudy(std::unique_ptr<State> state) : m_state(std::move(state)) {}
LiveStudy::~LiveStudy() = default;

void LiveStudy::poll() {
    State& s = *m_state;
    if (s.done)
        return;
    s.training->beat();
    s.lookAtForce();
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
    if (!m_state->blind())
        out.estimates = m_state->progress.estimates();
    return out;
}

const psychophysics::StudyDesign& LiveStudy::design() const {
    return m_state->study.design;
}
const psychophysics::Condition& LiveStudy::condition() const {
    return *m_state->condition;
}
const catalogue::ExerciseLevel& LiveStudy::level() const {
    return m_state->level;
}
LiveTraining& LiveStudy::training() {
    return *m_state->training;
}

core::Result<void> LiveStudy::answer(int answer, std::optional<double> value) {
    State& s = *m_state;
    s.describe();
    if (!s.view.canAnswer)
        return core::fail(core::ErrorCode::wrongUse, "no answer is taken now");
    const psychophysics::Task task = s.condition->task;
    if (answer < 0 || answer >= psychophysics::answers(task) ||
        (task == psychophysics::Task::magnitude && (!value || !(*value > 0.0))))
        return core::fail(core::ErrorCode::badInput,
                          "an answer of the task is expected, and a number above 0 where one is said");
    s.notes.answerBegins(s.last.tick);
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
        return; // the device cannot render more
    s.adjusted = wanted;
    s.training->post(CommandKind::present, core::encode({wanted, s.shown.arrangement}));
}

void LiveStudy::beginAnswer() {
    m_state->describe();
    if (m_state->view.canAnswer)
        m_state->notes.answerBegins(m_state->last.tick);
}

void LiveStudy::takeBack() {
    State& s = *m_state;
    if (!s.pending)
        return;
    s.pending->answer = -1;
    s.pending->value.reset();
    s.pending->spoiled = "taken_back";
    s.storePending();
}

void LiveStudy::goOn() {
    m_state->enough = m_state->pending.has_value();
}

void LiveStudy::endTrying() {
    m_state->readySaid = true;
    m_state->waitsForReady = false;
    if (m_state->trying())
        m_state->tried_s = m_state->tryFor_s; // the objects are removed at the next poll
}

void LiveStudy::beginCounting() {
    m_state->waitsToCount = false;
}

void LiveStudy::setMasking(const std::string& what) {
    m_state->notes.hear(what);
}

void LiveStudy::spoil() {
    State& s = *m_state;
    if (!s.presented || s.last.phase != TrialPhase::running || s.posted)
        return;
    s.spoiled = "experimenter";
    s.posted = s.training->post(CommandKind::answer, simulation::kAnswerSpoiled);
}

void LiveStudy::pause() {
    m_state->wantPause(true);
}
void LiveStudy::resume() {
    m_state->wantPause(false);
}

void LiveStudy::stopForce() {
    m_state->control.stopForce();
    m_state->control.tell(*m_state->training);
}

void LiveStudy::rearm() {
    m_state->control.rearm();
    m_state->control.tell(*m_state->training);
}

void LiveStudy::breakTaken() {
    State& s = *m_state;
    if (s.progress.breakDue() && State::secondsSince(s.breakSince) >= s.study.design.trial.breakAtLeast_s)
        s.progress.breakTaken();
}

void LiveStudy::experimenterSays(bool goOn) {
    m_state->progress.experimenterSays(goOn);
    if (!goOn)
        stop(); // the run stays open and can be resumed later
}

void LiveStudy::stop() {
    State& s = *m_state;
    s.storePending();
    s.stopping = true;
    s.stopSince = State::Clock::now();
    s.control.letGo(); // otherwise the scene would not receive the answer
    s.control.tell(*s.training);
    if (s.presented && s.last.phase == TrialPhase::running && !s.posted) {
        s.spoiled = database::kInterrupted;
        s.posted = s.training->post(CommandKind::answer, simulation::kAnswerSpoiled);
    } else if (s.presented) {
        s.presented = false; // the trial did not begin: nothing of it is stored
        s.finish();
    }
}

bool LiveStudy::finished() const {
    return m_state->done;
}
const core::Result<LiveStudyResult>& LiveStudy::result() const {
    return m_state->result;
}

} // namespace chiron::session
