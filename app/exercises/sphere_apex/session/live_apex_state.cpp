// SPDX-License-Identifier: GPL-3.0-or-later
// A run of the apex study from tick to tick and from session to session.
#include "app/exercises/sphere_apex/session/live_apex_state.h"

#include "app/exercises/sphere_apex/session/apex_sessions.h"
#include "core/random.h"
#include "core/units.h"
#include "curriculum/exercises/sphere_apex/catalogue/apex_study_content.h"
#include "session/study/apex_analysis.h"

#include <algorithm>
#include <utility>

namespace chiron::session {

using core::CommandKind;
using core::TrialPhase;

namespace {
constexpr double kFeedback_s = 2.0;       // reading a distance takes longer than reading "right"
constexpr int kTriedSpheres = 10;         // more than anybody can mark in a minute
constexpr std::uint64_t kSummarySeed = 1; // used only for intervals
} // namespace

/// Begins a session as the command line does: the positions of its spheres follow from the run's seed and the
/// number of earlier presentations.
core::Result<void> LiveApex::State::beginSession(Station station) {
    const bool free = tryFor_s > 0.0;
    const int wanted = free ? kTriedSpheres : std::clamp(progress.toCome(), 1, catalogue::kApexTrialsAtMost);
    psychophysics::StudyDesign asked = study.design;
    if (free)
        asked.trial.exploreLimit_s = 0.0; // a limit of the trials does not end what is only tried
    auto made = ApexSessions().level(asked, *condition, wanted, sessionLabel(study, sealedCode));
    CHIRON_TRY(made);
    const std::uint64_t seed =
        core::Random::mix(runSeed,
                          free ? std::string("free minute") : "sitting " + std::to_string(trials.size())) >>
        1;
    auto watching = ApexWatch::create(*made, seed, station, study.design);
    CHIRON_TRY(watching);
    auto ticks = std::make_unique<ApexTap>();
    TrainingRequest request;
    request.level = *made;
    request.seed = seed;
    request.station = std::move(station);
    request.ringFolder = ringFolder;
    request.studyRun = run;
    request.witness = ticks.get();
    auto live = LiveTraining::start(database, actor, std::move(request));
    CHIRON_TRY(live);
    level = std::move(*made);
    watch = std::move(*watching);
    before = std::move(training);
    tapBefore = std::move(tap);
    tap = std::move(ticks);
    training = std::move(*live);
    last = {};
    ending = waits = false;
    presented = 0;
    tries = free;
    ++sessions;
    control.begin();
    training->post(CommandKind::start);
    return {};
}

void LiveApex::State::drain() {
    ApexTick tick;
    while (!done && tap->ring().tryPop(tick))
        take(tick);
}

void LiveApex::State::take(const ApexTick& tick) {
    last = tick.sample;
    if ((tick.sample.events & core::event_bits::kTrialStarted) != 0)
        lost = false;
    lost = lost || tick.lost;
    if (stopping)
        return; // the current trial was already stored as stopped
    if ((tick.sample.events & core::event_bits::kTrialStarted) != 0)
        notes.beginTrial();
    auto answer = watch->take(tick.sample, tick.tool);
    if (answer && tries)
        // Belongs to the free minute, not to a trial.
        tried_s += watch->clock().exploration_s();
    else if (answer)
        record(std::move(*answer));
}

void LiveApex::State::record(StudyAnswer answer) {
    answer.session = training->sessionId();
    answer.spoiled = spoiled.empty() && lost ? "late_ticks" : spoiled;
    spoiled.clear();
    ++presented;
    answer.fidelity.circumstances = notes.ofTrial();
    if (stopping || progress.done() || !progress.next().practice || answer.answer < 0 ||
        !answer.spoiled.empty())
        return store(answer);
    view.beside_m = answer.value;
    enough = false;
    pending = std::move(answer);
}

void LiveApex::State::storePending() {
    if (const auto answer = std::exchange(pending, std::nullopt)) {
        store(*answer);
        view.beside_m.reset();
    }
}

bool LiveApex::State::feedbackOver() const {
    return pending ? enough || stopping : secondsSince(feedbackSince) >= kFeedback_s;
}

double LiveApex::State::triedSoFar_s() const {
    return tried_s + (watch->inTrial() ? watch->clock().exploration_s() : 0.0);
}

double LiveApex::State::tryLeft_s() const {
    return tries ? std::max(0.0, tryFor_s - triedSoFar_s()) : 0.0;
}

void LiveApex::State::store(const StudyAnswer& answer) {
    auto trial = progress.record(answer);
    if (!trial)
        return fail(trial.error());
    trial->run = run;
    if (auto kept = storeTrial(database, actor, *trial); !kept)
        return fail(kept.error());
    trials.push_back(std::move(*trial));
    note(answer.fidelity);
}

void LiveApex::State::note(const TrialFidelity& fidelity) {
    const database::StudyTrial& trial = trials.back();
    numbers.lastFidelity = forcesTell() ? withoutForces(fidelity) : fidelity;
    numbers.lastSpoiled = database::shownReason(trial.spoiled, blinding);
    view.repeated = database::isRepeated(trial) ? trial.spoiled : std::string();
    const bool own = trial.spoiled != "taken_back" && trial.spoiled != database::kInterrupted;
    view.unanswered = trial.answer < 0 && own ? trial.spoiled : std::string();
    summarise();
    if (study.design.trial.feedback && !trial.practice && trial.value && trial.spoiled.empty() &&
        !progress.done()) {
        view.beside_m = trial.value;
        feedbackSince = Clock::now();
    }
    waitsToCount = waitsAfterPractice && trial.practice && !progress.done() && !progress.practising();
    if (progress.breakDue())
        breakSince = Clock::now();
}

void LiveApex::State::summarise() {
    numbers.practice = static_cast<int>(
        std::count_if(trials.begin(), trials.end(), [](const auto& trial) { return trial.practice; }));
    numbers.apex.reset();
    if (!study.blind())
        numbers.apex =
            psychophysics::summariseApex(apexTrials(trials, 0), condition->stimulus.reference, kSummarySeed);
}

bool LiveApex::State::heldBetween() const {
    return view.beside_m.has_value() || pending.has_value() ||
           (!watch->inTrial() && (waitsToCount || progress.breakDue() || progress.needsExperimenter()));
}

/// The exercise proceeds from trial to trial by itself; this function holds it and ends it.
void LiveApex::State::goOn() {
    if (pending && feedbackOver())
        storePending();
    if (view.beside_m && feedbackOver())
        view.beside_m.reset();
    if (done || waits)
        return;
    control.hold(!stopping && heldBetween());
    if (watch->over())
        control.hold(false);
    if (stopping || watch->over())
        // A paused scene would never reach its end.
        control.letGo();
    const bool tried = tries && tryLeft_s() <= 0.0;
    if (tried) {
        tried_s = tryFor_s; // it stays over while the session ends
        control.letGo();
    }
    if ((stopping || progress.done() || tried) && !watch->over())
        endSession();
}

void LiveApex::State::endSession() {
    if (!ending)
        ending = training->post(CommandKind::end);
}

void LiveApex::State::fail(const core::Error& error) {
    result = tl::unexpected(error);
    stopping = true;
}

/// A session has been stored: the study's run is complete, the person stops, or another session follows.
void LiveApex::State::sessionEnded() {
    drain(); // the samples of the last ticks
    const bool tried = std::exchange(tries, false);
    tryFor_s = tried ? 0.0 : tryFor_s;
    // No trial's clock starts while the hand is still trying the controls.
    waitsForReady = tried && !readySaid && !stopping;
    if (!training->result())
        result = tl::unexpected(training->result().error());
    const bool failed = !result && result.error().code != core::ErrorCode::wrongUse;
    // Without any presentation the session was stuck, and another one would be as well: endedByItself.
    const bool further =
        !failed && training->result() && !stopping && !progress.done() && (presented > 0 || tried);
    if (!further)
        return conclude(!progress.done() && !stopping);
    waits = true;
    goOnWithNext();
}

void LiveApex::State::goOnWithNext() {
    if (stopping || !nextStation)
        return conclude();
    if (waitsForReady)
        return;
    if (control.held() || heldBetween())
        return control.hold(heldBetween());
    auto station = nextStation();
    auto begun =
        station ? beginSession(std::move(*station)) : core::Result<void>(tl::unexpected(station.error()));
    if (begun)
        return;
    fail(begun.error());
    conclude();
}

void LiveApex::State::conclude(bool byItself) {
    storePending();
    done = true;
    if (!result && result.error().code != core::ErrorCode::wrongUse)
        return; // a trial could not be stored, or a session could not be run
    LiveStudyResult ended{run, training->sessionId(), progress.done() && !progress.gaveUp(), byItself};
    if (ended.completed)
        if (auto closed = finishRun(database, actor, study, run); !closed) {
            result = tl::unexpected(closed.error());
            return;
        }
    result = ended;
}

void LiveApex::State::describe() {
    const StudyPresentation shown = progress.done() ? StudyPresentation{} : progress.next();
    const bool running = watch->inTrial() && last.phase == TrialPhase::running && !stopping;
    view.tryLeft_s = tryLeft_s();
    view.practice = shown.practice && view.tryLeft_s <= 0.0;
    view.mayTakeBack = pending.has_value() && !done;
    view.trial = progress.scored();
    view.ofAtMost = progress.done() ? view.ofAtMost : shown.ofAtMost;
    view.touched = watch->touched() ? 1u : 0u;
    view.nearForceLimit = tries ? watch->nearForceLimit() : watch->cameNearForceLimit();
    const double limit_s = study.design.trial.exploreLimit_s;
    const double spent_s = watch->clock().exploration_s();
    view.timeLeft_s = running && !tries && limit_s > 0.0 ? std::max(0.0, limit_s - spent_s) : 0.0;
    view.canAnswer = running && !control.held() && last.paused == 0 && (!tries || view.tryLeft_s > 0.0) &&
                     (watch->touched() || !study.design.trial.mustTouchAll);
    view.breakLeft_s = progress.breakDue()
                           ? std::max(0.0, study.design.trial.breakAtLeast_s - secondsSince(breakSince))
                           : 0.0;
    view.state = where();
    numbers.sealedCode = sealedCode;
    numbers.blind = study.blind();
    numbers.condition = numbers.blind ? sealedCode : condition->id;
    numbers.scored = progress.scored();
    numbers.spoiled = progress.spoiledTrials();
    numbers.repeats = shown.repeat;
    numbers.spoiling = !spoiled.empty();
}

LiveStudyView::State LiveApex::State::where() const {
    using View = LiveStudyView::State;
    if (done)
        return View::finished;
    if (control.stopped() && !stopping)
        return View::stopped;
    if (control.paused())
        return View::paused;
    if (view.beside_m || pending)
        return View::feedback;
    if (waitsForReady || (tries && tryLeft_s() <= 0.0 && !readySaid && !stopping))
        return View::tried;
    if (!watch->inTrial() && waitsToCount)
        return View::practised;
    if (!watch->inTrial() && progress.needsExperimenter())
        return View::needsExperimenter;
    if (!watch->inTrial() && progress.breakDue())
        return View::breakDue;
    if (waits || stopping || training->sessionId() == 0)
        return View::starting;
    if (last.paused != 0)
        return View::arming; // resuming: force is armed first
    if (tries && last.phase == TrialPhase::running)
        return tryLeft_s() > 0.0 ? View::trying : View::coming;
    if (last.phase == TrialPhase::running)
        return watch->inTrial() ? View::exploring : View::coming;
    return last.phase == TrialPhase::ready ? View::arming : View::coming;
}

} // namespace chiron::session
