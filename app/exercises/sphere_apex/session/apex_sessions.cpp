// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/session/apex_sessions.h"

#include "app/exercises/sphere_apex/session/apex_director.h"
#include "app/exercises/sphere_apex/session/live_apex.h"
#include "core/random.h"
#include "curriculum/exercises/sphere_apex/catalogue/apex_study_content.h"
#include "session/exercise_kind.h"
#include "session/study/study_setup.h"
#include "session/training_run.h"

#include <atomic>
#include <utility>

namespace chiron::session {

namespace {

constexpr std::string_view kExercise = "sphere_apex";

} // namespace

int ApexSessions::trialsAtMost() const noexcept {
    return catalogue::kApexTrialsAtMost;
}

core::Result<catalogue::ExerciseLevel> ApexSessions::level(const psychophysics::StudyDesign& design,
                                                           const psychophysics::Condition& condition,
                                                           int trials, const std::string& label) const {
    const auto parameters = catalogue::apexOf(condition, design.trial, trials);
    CHIRON_TRY(parameters);
    return catalogue::apexLevel(*parameters, design.id, label.empty() ? condition.id : label);
}

core::Result<Station> ApexSessions::scripted(const catalogue::ExerciseLevel& level,
                                             const std::string& trainee, std::uint64_t seed) const {
    const auto kind = exerciseKind(kExercise);
    CHIRON_TRY(kind);
    return scriptedStation(**kind, level, trainee.empty() ? kUsualTrainee : trainee, seed);
}

core::Result<database::SessionId> ApexSessions::run(database::Database& database,
                                                    const database::Actor& actor,
                                                    const MarkSitting& sitting) const {
    auto level = this->level(sitting.study.design, sitting.condition, sitting.trials,
                             sessionLabel(sitting.study, sitting.sealedCode));
    CHIRON_TRY(level);
    TrainingRequest request;
    request.level = *level;
    request.seed = sitting.seed;
    auto station = scripted(*level, sitting.trainee, core::Random::mix(sitting.seed, "participant"));
    CHIRON_TRY(station);
    request.station = std::move(*station);
    std::atomic<database::SessionId> session{0};
    auto director = ApexDirector::create(
        *level, sitting.seed, request.station,
        {sitting.progress, sitting.study.design, sitting.cancel, [&](database::StudyTrial trial) {
             trial.session = session.load();
             return sitting.store(std::move(trial));
         }});
    CHIRON_TRY(director);
    request.ringFolder = sitting.ringFolder;
    request.studyRun = sitting.run;
    request.director = director->get();
    request.onSession = [&](database::SessionId id) { session.store(id); };
    auto result = runTrainingOn(database, actor, request);
    CHIRON_TRY(result);
    CHIRON_TRY((*director)->recorded());
    return result->session;
}

SittingResult<std::unique_ptr<LiveSitting>> ApexSessions::begin(database::Database& database,
                                                                const database::Actor& actor,
                                                                const ConductedSitting& sitting,
                                                                LiveStudyRequest request) const {
    return LiveApex::start(database, actor, sitting, std::move(request));
}

} // namespace chiron::session
