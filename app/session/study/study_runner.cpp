// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_runner.h"

#include "core/random.h"
#include "session/study/mark_sessions.h"
#include "session/study/rendered_run.h"
#include "session/study/run_seed.h"
#include "session/study/study_director.h"
#include "session/study/study_run_check.h"
#include "session/study/study_setup.h"
#include "session/study/study_store.h"
#include "session/training_run.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

/// The current run, with the data that rendered and quick runs share.
struct Sitting {
    database::Database& database;
    const database::Actor& actor;
    const StudyRunRequest& request;
    const psychophysics::Condition& condition;
    StudyProgress& progress;
    psychophysics::SimulatedObserver observer;
    database::StudyRunNumber run = 0;
    std::string sealedCode;
    std::uint64_t runSeed = 0;
    int before = 0; ///< presentations before this call
    int presented = 0;
    core::Result<void> stored;

    bool store(database::StudyTrial trial) {
        trial.run = run;
        stored = storeTrial(database, actor, trial);
        ++presented;
        if (stored && request.progress)
            request.progress(progress.scored(), trialsOfCondition());
        return stored.has_value();
    }
    int trialsOfCondition() const { return progress.done() ? progress.scored() : progress.next().ofAtMost; }
    bool interrupted() const {
        return (request.trialsAtMost > 0 && presented >= request.trialsAtMost) ||
               (request.cancel && request.cancel->load(std::memory_order_relaxed));
    }
};

core::Result<database::SessionId> runRecorded(Sitting& sitting, const OpenedStudy& study,
                                              std::uint64_t seed) {
    auto level = studyLevel(study.design, sitting.condition, sitting.request.control,
                            sessionLabel(study, sitting.sealedCode));
    CHIRON_TRY(level);
    auto participant = participantStation(*level, core::Random::mix(seed, "participant"));
    CHIRON_TRY(participant);
    FidelityMeter meter(level->parameters.as<simulation::ComparisonParameters>(), study.design.fidelity,
                        study.design.trial.mustTouchAll);
    std::atomic<database::SessionId> session{0};
    StudyDirector director({sitting.progress, sitting.condition, *participant->mind, sitting.observer, meter,
                            [&](database::StudyTrial trial) {
                                trial.session = session.load();
                                return sitting.store(std::move(trial));
                            },
                            [&] { return sitting.interrupted(); }, study.design.trial.exploreLimit_s});
    TrainingRequest request;
    request.level = *level;
    request.seed = seed;
    request.station = std::move(participant->station);
    request.ringFolder = sitting.request.ringFolder;
    request.studyRun = sitting.run;
    request.director = &director;
    request.onSession = [&](database::SessionId id) { session.store(id); };
    auto result = runTrainingOn(sitting.database, sitting.actor, request);
    CHIRON_TRY(result);
    CHIRON_TRY(director.recorded());
    return result->session;
}

/// Runs sessions of the exercise whose marks are asked for until the run is done: a further session repeats
/// spoiled trials, and no session holds more trials than the exercise allows. Returns the last session.
core::Result<database::SessionId> runMarks(const MarkSessions& marks, Sitting& sitting,
                                           const OpenedStudy& study) {
    database::SessionId last = 0;
    while (!sitting.progress.done() && !sitting.interrupted()) {
        const int before = sitting.presented;
        const int wanted = std::clamp(sitting.progress.toCome(), 1, marks.trialsAtMost());
        const int most =
            sitting.request.trialsAtMost > 0 ? sitting.request.trialsAtMost - sitting.presented : wanted;
        const std::uint64_t seed =
            core::Random::mix(sitting.runSeed,
                              "sitting " + std::to_string(sitting.before + sitting.presented)) >>
            1;
        auto session =
            marks.run(sitting.database, sitting.actor,
                      {study, sitting.condition, sitting.progress, sitting.run, sitting.sealedCode,
                       sitting.request.observer.trainee, seed, std::min(wanted, most),
                       sitting.request.ringFolder, sitting.request.cancel,
                       [&](database::StudyTrial trial) { return sitting.store(std::move(trial)); }});
        CHIRON_TRY(session);
        last = *session;
        // Without progress, another session would be stuck as well; runConducted() says so.
        if (!sitting.stored || sitting.presented == before)
            break;
    }
    return last;
}

StudyAnswer toldAnswer(Sitting& sitting, const StudyPresentation& shown) {
    const double reference = sitting.condition.stimulus.reference;
    std::vector<double> felt;
    for (const double value : shown.values)
        felt.push_back(std::log10(value / reference));
    StudyAnswer answer;
    if (sitting.condition.task == psychophysics::Task::magnitude)
        answer.value = sitting.observer.magnitude(felt.front());
    if (sitting.condition.task == psychophysics::Task::adjustment) {
        const auto& d = sitting.condition.stimulus.differences;
        answer.value = reference * std::pow(10.0, sitting.observer.adjust(d.front(), d.back()));
    }
    answer.answer = sitting.observer.answer(sitting.condition.task, felt);
    return answer;
}

/// Runs the same trials without rendering: the observer receives the values directly; marks of an apex are
/// drawn from the observer model for planning.
void runQuick(Sitting& sitting) {
    while (!sitting.progress.done() && !sitting.interrupted()) {
        if (sitting.progress.breakDue())
            sitting.progress.breakTaken();
        const StudyPresentation shown = sitting.progress.next();
        const StudyAnswer answer =
            looksForApex(sitting.condition)
                ? plannedMark(sitting.condition.stimulus.reference, sitting.runSeed, shown.ordinal)
                : toldAnswer(sitting, shown);
        auto trial = sitting.progress.record(answer);
        if (!trial) {
            sitting.stored = tl::unexpected(trial.error());
            return;
        }
        if (!sitting.store(std::move(*trial)))
            return;
    }
}

struct BegunRun {
    database::StudyRunNumber number = 0;
    std::string sealedCode;
    std::uint64_t seed = 0;
    std::vector<database::StudyTrial> trials;
    StudyProgress progress;
};

/// A run must be either rendered or quick from its first trial to its last.
core::Result<void> sameKind(const database::StudyRun& run, const std::vector<database::StudyTrial>& trials,
                            bool quick) {
    const bool mixed = std::any_of(trials.begin(), trials.end(),
                                   [&](const auto& trial) { return (trial.session == 0) != quick; });
    return mixed ? core::fail(core::ErrorCode::wrongUse,
                              "run " + std::to_string(run.id) + " was begun " +
                                  (quick ? "through the rendering" : "without a rendering") +
                                  ": it goes on like that")
                 : core::Result<void>();
}

core::Result<BegunRun> beginOrResume(database::Database& database, const database::Actor& actor,
                                     const OpenedStudy& study, const std::string& label,
                                     database::ConductedRun conducted, const StudyRunRequest& request,
                                     double limit) {
    const std::uint64_t seed = seedOf(study, label, request);
    if (const auto& open = conducted.open) {
        auto alike = sameKind(*open, conducted.trials, request.quick);
        if (alike)
            alike = sameSeed(study, *open, request);
        if (alike)
            alike = sameTable(*open, limit);
        CHIRON_TRY(alike);
        auto progress = StudyProgress::resume(study.design, conducted.condition, open->seed, conducted.trials,
                                              StudyProgress::limitOf(open->procedures));
        CHIRON_TRY(progress);
        CHIRON_TRY(sameVersions(*open, progress->procedureIds()));
        return BegunRun{open->id, open->sealedCode, open->seed, std::move(conducted.trials),
                        std::move(*progress)};
    }
    auto progress = StudyProgress::begin(study.design, conducted.condition, seed, limit);
    CHIRON_TRY(progress);
    const auto begun = beginRun(database, actor, study, label, seed, progress->procedureIds());
    CHIRON_TRY(begun);
    return BegunRun{*begun, conducted.sealedCode, seed, {}, std::move(*progress)};
}

/// Fails if trials are left although nobody interrupted the run.
core::Result<void> wentOn(const Sitting& sitting) {
    if (sitting.progress.done() || sitting.interrupted())
        return {};
    return core::fail(core::ErrorCode::device,
                      "run " + std::to_string(sitting.run) +
                          ": its session ended by itself before all trials were done, and nothing more was "
                          "presented. The answered trials are kept, and the run can be resumed");
}

core::Result<StudyRunSummary> runConducted(database::Database& database, const database::Actor& actor,
                                           const StudyRunRequest& request, const OpenedStudy& study,
                                           const std::string& label, const database::ConductedRun& conducted,
                                           const RenderingLimits& limits) {
    const psychophysics::Condition* found = conditionOf(study.design, conducted.condition);
    if (!found)
        return core::fail(core::ErrorCode::notFound, "condition \"" + label + "\" is not one of the study's");
    const auto limit = limitOnStation(study.design, study.blind(), *found, request, limits);
    CHIRON_TRY(limit);
    auto run = beginOrResume(database, actor, study, label, conducted, request, *limit);
    CHIRON_TRY(run);
    // Each resumption has its own random streams, so that it does not repeat numbers that an earlier part of
    // the run has drawn.
    const std::uint64_t seed = core::Random::mix(run->seed, "sitting " + std::to_string(run->trials.size()));
    Sitting sitting{database,
                    actor,
                    request,
                    *found,
                    run->progress,
                    psychophysics::SimulatedObserver(request.observer, core::Random::mix(seed, "observer")),
                    run->number,
                    run->sealedCode,
                    run->seed,
                    static_cast<int>(run->trials.size()),
                    0,
                    {}};
    StudyRunSummary summary;
    summary.condition = label;
    summary.run = run->number;
    if (request.quick) {
        runQuick(sitting);
    } else if (!run->progress.done()) {
        const MarkSessions* marks = markSessionsOf(*found);
        auto session = marks ? runMarks(*marks, sitting, study) : runRecorded(sitting, study, seed >> 1);
        CHIRON_TRY(session);
        summary.session = *session;
    }
    CHIRON_TRY(sitting.stored);
    CHIRON_TRY(wentOn(sitting));
    summary.scored = run->progress.scored();
    summary.spoiled = run->progress.spoiledTrials();
    summary.completed = run->progress.done() && !run->progress.gaveUp();
    summary.estimates = run->progress.estimates();
    if (summary.completed)
        CHIRON_TRY(finishRun(database, actor, study, run->number));
    return summary;
}

core::Result<StudyRunSummary> runCondition(database::Database& database, const database::Actor& actor,
                                           const StudyRunRequest& request, const OpenedStudy& study,
                                           const std::string& label, const RenderingLimits& limits) {
    const auto conducted = conduct(database, actor, study, label);
    CHIRON_TRY(conducted);
    const auto open = unmasked(study, *conducted);
    CHIRON_TRY(open);
    auto run = runConducted(database, actor, request, *open, label, *conducted, limits);
    return run ? std::move(run) : tl::unexpected(sealedError(study, *conducted, run.error()));
}

/// Checks that the participant is simulated and is the one that was enrolled.
core::Result<void> mayBeSimulated(const OpenedStudy& study, const StudyRunRequest& request) {
    const database::Participant& participant = study.participant;
    if (!participant.simulated)
        return core::fail(core::ErrorCode::wrongUse, "participant " + participant.code +
                                                         " is a person: expected a simulated participant");
    if (participant.observer.empty())
        return {};
    const auto enrolled = psychophysics::parseObserver(participant.observer);
    CHIRON_TRY(enrolled);
    if (psychophysics::observerText(*enrolled) != psychophysics::observerText(request.observer))
        return core::fail(core::ErrorCode::wrongUse, "participant " + participant.code + " was enrolled as " +
                                                         participant.observer + ", not as " +
                                                         psychophysics::observerText(request.observer));
    return {};
}

} // namespace

core::Result<StudyRunReport> runStudyHeadless(database::Database& database, const database::Actor& actor,
                                              const StudyRunRequest& request) {
    auto study = openStudy(database, actor, request.study, request.participantCode);
    CHIRON_TRY(study);
    CHIRON_TRY(mayBeSimulated(*study, request));
    CHIRON_TRY(checkObserver(study->design, request.observer));
    std::vector<std::string> conditions = openConditions(*study);
    if (!request.condition.empty())
        conditions = {request.condition};
    else if (conditions.empty())
        CHIRON_TRY(seedIsOfWhatWasDone(*study, request));
    const auto limits = limitsOfRun(request);
    CHIRON_TRY(limits);
    StudyRunReport report;
    if (!request.quick)
        report.limits = *limits;
    for (const std::string& label : conditions) {
        auto run = runCondition(database, actor, request, *study, label, *limits);
        CHIRON_TRY(run);
        report.runs.push_back(std::move(*run));
        if (!report.runs.back().completed)
            break;
    }
    auto now = openStudy(database, actor, request.study, request.participantCode);
    CHIRON_TRY(now);
    report.completed = openConditions(*now).empty();
    return report;
}

} // namespace chiron::session
