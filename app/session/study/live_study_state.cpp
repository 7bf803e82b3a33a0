// SPDX-License-Identifier: GPL-3.0-or-later
// A run of comparisons from tick to tick: the state of the loop, the next presentation, and the view for the
// window.
#include "session/study/live_study_state.h"

#include "core/presentation_word.h"
#include "core/units.h"
#include "session/study/participant_view.h"
#include "simulation/comparison/compared_object.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::session {

using core::CommandKind;
using core::TrialPhase;

namespace {
constexpr double kFeedback_s = 1.2;
constexpr double kStopPatience_s = 2.0;
constexpr double kJustHeld_s =
    0.1; // before the time was up: an object that was let go then was held too long
constexpr double kStands_m = 0.0005; // an object that is lifted less looks as if it stood on the table

/// The reason why a trial does not count, if the participant can avoid it; the other reasons concern the
/// device or the experimenter.
std::string ofTheHand(const std::string& reason) {
    return reason == "peak_force" || reason == "speed" ? reason : std::string();
}
} // namespace

void LiveStudy::State::wantPause(bool wanted) {
    if (!stopping) // once the run is stopping, no pause may delay it
        control.wantPause(wanted);
    control.tell(*training);
}

void LiveStudy::State::lookAtForce() {
    if (!stopping)
        control.look(training->display().latest());
    control.tell(*training);
}

void LiveStudy::State::drain() {
    FidelitySample sample;
    while (tap.ring().tryPop(sample))
        take(sample);
}

void LiveStudy::State::take(const FidelitySample& sample) {
    constexpr std::uint32_t kEnds =
        core::event_bits::kCompleted | core::event_bits::kTimedOut | core::event_bits::kFailed;
    if (last.place != 0 && sample.place != last.place)
        letGo = static_cast<int>(last.place) - 1;
    last = sample;
    if (sample.events & core::event_bits::kTrialStarted) {
        clock.begin(sample.tick);
        grazed = 0;
        letGo = -1;
        view.lift = LiveStudyView::Lift::none;
        view.hand.clear();
    }
    noticeLift(sample);
    clock.take(sample, sample.place != 0);
    if (sample.place != 0 && sample.phase == TrialPhase::running)
        grazed |= 1u << (sample.place - 1u);
    meter.add(sample);
    if (presented && (sample.events & kEnds))
        endTrial(sample);
    if (tryPresented && (sample.events & kEnds)) {
        tried_s += clock.exploration_s();
        tryPresented = false;
    }
}

/// Follows simulation::ComparedObject, which lets go of an object that was lifted, then pressed onto its bed,
/// and is then raised.
void LiveStudy::State::noticeLift(const FidelitySample& sample) {
    using Lift = LiveStudyView::Lift;
    using simulation::ComparedObject;
    const auto& scene = level.parameters.as<simulation::ComparisonParameters>();
    if (scene.attribute != simulation::ComparedAttribute::mass || sample.place == 0) {
        view.lift = Lift::none;
        view.lift_m = 0.0;
        return;
    }
    const double lift_m = view.lift_m = sample.displacement_m;
    const bool wasLifted = view.lift != Lift::none && view.lift != Lift::held;
    if (lift_m > ComparedObject::kLifted_m)
        view.lift = Lift::raised;
    else if (!wasLifted)
        view.lift = Lift::held;
    else if (-lift_m * std::max(1.0, scene.object.stiffness_N_per_m) > ComparedObject::kPress_N)
        view.lift = Lift::pressed;
    else if (view.lift == Lift::raised && lift_m <= kStands_m)
        view.lift = Lift::stands;
}

StudyAnswer LiveStudy::State::answerOf(const FidelitySample& sample) {
    StudyAnswer answer;
    const bool byButton = !posted && (sample.events & core::event_bits::kCompleted) != 0;
    answer.answer = byButton ? static_cast<int>(sample.answer) - 1 : answered;
    if ((sample.events & core::event_bits::kTimedOut) != 0)
        answer.answer = -1;
    answer.value = value;
    answer.session = training->sessionId();
    answer.firstTick = clock.first();
    answer.lastTick = sample.tick;
    answer.exploration_s = clock.exploration_s();
    answer.answer_s = clock.sinceContact_s();
    answer.fidelity = meter.finish();
    answer.spoiled = spoiled;
    if (byButton)
        notes.answerBegins(sample.tick);
    answer.fidelity.circumstances = notes.ofTrial();
    return answer;
}

void LiveStudy::State::endTrial(const FidelitySample& sample) {
    presented = false;
    StudyAnswer answer = answerOf(sample);
    if (!shown.practice || answer.answer < 0 || !answer.spoiled.empty() || stopping)
        return store(answer);
    const int correct = psychophysics::correctAnswer(condition->task, shown.arrangement);
    view.hand = ofTheHand(answer.fidelity.outside);
    view.right = correct >= 0 && answer.fidelity.outside.empty() ? std::optional(answer.answer == correct)
                                                                 : std::nullopt;
    enough = false;
    pending = std::move(answer);
}

void LiveStudy::State::storePending() {
    if (const auto answer = std::exchange(pending, std::nullopt))
        store(*answer);
    view.right.reset();
}

void LiveStudy::State::store(const StudyAnswer& answer) {
    auto trial = progress.record(answer);
    if (!trial)
        return fail(trial.error());
    trial->run = run;
    if (auto kept = storeTrial(database, actor, *trial); !kept)
        return fail(kept.error());
    note(*trial, answer.fidelity);
}

void LiveStudy::State::fail(const core::Error& error) {
    result = tl::unexpected(error);
    finish();
}

void LiveStudy::State::note(const database::StudyTrial& trial, const TrialFidelity& fidelity) {
    numbers.lastFidelity = forcesTell() ? withoutForces(fidelity) : fidelity;
    numbers.lastSpoiled = database::shownReason(trial.spoiled, blinding);
    numbers.practice += trial.practice ? 1 : 0;
    view.right.reset();
    const int correct = psychophysics::correctAnswer(condition->task, trial.arrangement);
    const bool own = trial.spoiled != "taken_back" && trial.spoiled != database::kInterrupted;
    view.unanswered = trial.answer < 0 && own ? trial.spoiled : std::string();
    view.missed = trial.spoiled == "untouched" ? missed : LiveStudyView::Missed::none;
    view.repeated = database::isRepeated(trial) ? trial.spoiled : std::string();
    // Practice trials were explained by their feedback, and are not repeated.
    view.hand = trial.practice ? std::string() : ofTheHand(trial.spoiled);
    if (study.design.trial.feedback && !trial.practice && correct >= 0 && trial.answer >= 0 &&
        trial.spoiled.empty()) {
        view.right = trial.answer == correct;
        feedbackSince = Clock::now();
    }
    waitsToCount = waitsAfterPractice && trial.practice && !progress.done() && !progress.practising();
    if (progress.breakDue())
        breakSince = Clock::now();
}

bool LiveStudy::State::allTouched() const {
    const auto every = (1u << static_cast<unsigned>(view.places)) - 1u;
    return !study.design.trial.mustTouchAll || (last.touched & every) == every;
}

/// True once the time to explore is over. Pauses do not count.
bool LiveStudy::State::timeIsUp() const {
    const double limit_s = study.design.trial.exploreLimit_s;
    return limit_s > 0.0 && clock.exploration_s() >= limit_s;
}

/// What keeps the objects that are left from counting as touched.
LiveStudyView::Missed LiveStudy::State::whatIsMissed() const {
    using Missed = LiveStudyView::Missed;
    const auto missing = ((1u << static_cast<unsigned>(view.places)) - 1u) & ~last.touched;
    if (missing == 0)
        return Missed::none;
    // The objects go when the time is up, and what is held with them, before this is asked.
    const int place = last.place != 0 ? static_cast<int>(last.place) - 1 : letGo;
    const double heldUntil_s = clock.exploration_s() - clock.sinceContact_s();
    if (isTakenHold(condition->stimulus.attribute) && place >= 0 &&
        heldUntil_s >= study.design.trial.exploreLimit_s - kJustHeld_s && ((last.touched >> place) & 1u) != 0)
        return Missed::held;
    return (missing & ~grazed) == 0 ? Missed::tooLight : Missed::never;
}

/// The objects are gone before every one was touched: no answer is possible, so the trial ends here and is
/// repeated.
void LiveStudy::State::spoilUntouched() {
    if (!presented || posted || stopping || last.phase != TrialPhase::running || last.paused != 0 ||
        control.paused() || !timeIsUp() || allTouched())
        return;
    spoiled = "untouched";
    missed = whatIsMissed();
    posted = training->post(CommandKind::answer, simulation::kAnswerSpoiled);
}

/// Decides what comes next between two trials.
void LiveStudy::State::goOn() {
    spoilUntouched();
    if (stopping && !cut && secondsSince(stopSince) > kStopPatience_s)
        // Still paused or arming: the session ends in its current state.
        finishing = cut = training->post(CommandKind::end);
    if (presented || finishing || control.paused() || last.paused != 0)
        return;
    if (showsFeedback())
        return;
    storePending();
    if (trying())
        return goOnTrying();
    if (stopping || progress.done())
        finish();
    else if (!waitsForReady && !waitsToCount && !progress.needsExperimenter() && !progress.breakDue() &&
             (last.phase == TrialPhase::idle || last.phase == TrialPhase::between))
        present();
}

/// Feedback of practice stays until the participant goes on, or the run is stopping.
bool LiveStudy::State::showsFeedback() const {
    if (pending)
        return !enough && !stopping;
    return view.right && secondsSince(feedbackSince) < kFeedback_s;
}

double LiveStudy::State::triedSoFar_s() const {
    return tried_s + (tryPresented && last.phase == TrialPhase::running ? clock.exploration_s() : 0.0);
}

double LiveStudy::State::tryLeft_s() const {
    return trying() ? std::max(0.0, tryFor_s - triedSoFar_s()) : 0.0;
}

/// The candidate with the smallest difference: somebody who tries the controls should learn nothing about the
/// later questions.
int LiveStudy::State::mostAlike() const {
    const auto& differences = condition->stimulus.differences;
    const auto least = std::min_element(differences.begin(), differences.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
    return static_cast<int>(least - differences.begin());
}

/// Runs the free minute: objects stay in place until it is over, without a trial. No limit of the design
/// applies to them (ComparisonParameters::freeFirst).
void LiveStudy::State::goOnTrying() {
    const bool over = stopping || tryLeft_s() <= 0.0;
    if (tryPresented) {
        if (over && !posted && last.phase == TrialPhase::running)
            posted = training->post(CommandKind::answer, simulation::kAnswerSpoiled);
    } else if (over) {
        tryFor_s = 0.0;
        // No trial's clock starts while the hand is still trying the controls.
        waitsForReady = !readySaid && !stopping;
    } else if (last.phase == TrialPhase::idle || last.phase == TrialPhase::between) {
        posted = false;
        tryPresented = training->post(CommandKind::present, core::encode({mostAlike(), 0}));
    }
}

void LiveStudy::State::present() {
    notes.beginTrial();
    shown = progress.next();
    adjusted = shown.candidate;
    meter.begin(shown.values);
    posted = false;
    answered = -1;
    value.reset();
    spoiled.clear();
    missed = LiveStudyView::Missed::none;
    presented = training->post(CommandKind::present, core::encode({shown.candidate, shown.arrangement}));
}

void LiveStudy::State::finish() {
    finishing = training->post(CommandKind::answer, simulation::kAnswerFinish);
}

/// The session is stored: the run is finished, or stays open to be resumed.
void LiveStudy::State::conclude() {
    storePending();
    done = true;
    if (!training->result()) {
        result = tl::unexpected(training->result().error());
        return;
    }
    if (!result && result.error().code != core::ErrorCode::wrongUse)
        return; // a trial could not be stored
    LiveStudyResult ended{run, training->result()->session, progress.done() && !stopping,
                          !progress.done() && !stopping};
    if (ended.completed)
        if (auto closed = finishRun(database, actor, study, run); !closed) {
            result = tl::unexpected(closed.error());
            return;
        }
    result = ended;
}

void LiveStudy::State::describe() {
    view.tryLeft_s = tryLeft_s();
    view.practice = view.tryLeft_s <= 0.0 && (presented || pending ? shown.practice : progress.practising());
    view.mayTakeBack = pending.has_value() && !done;
    view.practiceAnswer = view.mayTakeBack ? pending->answer : -1;
    view.practiceValue = view.mayTakeBack ? pending->value : std::nullopt;
    view.trial = progress.scored();
    view.ofAtMost = presented ? shown.ofAtMost : view.ofAtMost;
    view.place = static_cast<int>(last.place) - 1;
    view.letGo = view.place < 0 ? letGo : -1;
    view.touched = last.touched;
    view.grazed = grazed;
    view.nearForceLimit = presented ? meter.cameNearForceLimit() : meter.nearForceLimit();
    view.probe_N = study.design.trial.mustTouchAll ? study.design.trial.probeAtLeast_N : 0.0;
    const double limit_s = study.design.trial.exploreLimit_s;
    const bool running = presented && last.phase == TrialPhase::running;
    view.timeLeft_s = running && limit_s > 0.0 ? std::max(0.0, limit_s - clock.exploration_s()) : 0.0;
    view.canAnswer = running && !posted && !control.paused() && last.paused == 0 && allTouched();
    view.breakLeft_s = progress.breakDue()
                           ? std::max(0.0, study.design.trial.breakAtLeast_s - secondsSince(breakSince))
                           : 0.0;
    const auto lastCandidate = static_cast<double>(condition->stimulus.differences.size() - 1);
    view.adjusted = lastCandidate > 0.0 ? adjusted / lastCandidate : 0.0;
    view.state = where(running);
    numbers.blind = blind();
    numbers.condition = blind() ? sealedCode : condition->id;
    numbers.sealedCode = sealedCode;
    numbers.scored = progress.scored();
    numbers.spoiled = progress.spoiledTrials();
    numbers.repeats = presented ? shown.repeat : 0;
}

LiveStudyView::State LiveStudy::State::where(bool running) const {
    using View = LiveStudyView::State;
    if (done)
        return View::finished;
    if (control.stopped() && !stopping)
        return View::stopped;
    if (control.paused())
        return View::paused;
    if (last.paused != 0)
        return View::arming; // resuming: force is armed first
    if (view.right || pending)
        return View::feedback;
    if (tryLeft_s() > 0.0 && training->sessionId() != 0)
        return last.phase == TrialPhase::running ? View::trying
               : last.phase == TrialPhase::ready ? View::arming
                                                 : View::coming;
    if (waitsForReady || (trying() && tryLeft_s() <= 0.0 && !readySaid && !stopping))
        return View::tried;
    if (!presented && waitsToCount)
        return View::practised;
    if (!presented && progress.needsExperimenter())
        return View::needsExperimenter;
    if (!presented && progress.breakDue())
        return View::breakDue;
    if (running)
        return !timeIsUp() ? View::exploring : allTouched() ? View::answering : View::coming;
    if (presented && last.phase == TrialPhase::ready)
        return View::arming;
    return training->sessionId() == 0 ? View::starting : View::coming;
}

} // namespace chiron::session
