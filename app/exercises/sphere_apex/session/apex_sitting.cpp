// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/session/apex_sitting.h"

#include "curriculum/exercises/sphere_apex/catalogue/apex_study_content.h"
#include "core/random.h"
#include "psychophysics/study/apex_study.h"
#include "app/exercises/sphere_apex/session/apex_director.h"
#include "session/study/study_setup.h"
#include "session/training_run.h"

#include <cmath>

namespace chiron::session {

namespace {

constexpr std::string_view kExercise = "sphere_apex";

} // namespace

bool looksForApex(const psychophysics::Condition& condition) noexcept {
    return condition.stimulus.attribute == psychophysics::Attribute::apex;
}

core::Result<catalogue::ExerciseLevel> apexStudyLevel(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                                                      int trials, const std::string& sealedCode) {
    const auto parameters = catalogue::apexOf(condition, design.trial, trials);
    if (!parameters)
        return tl::unexpected(parameters.error());
    return catalogue::apexLevel(*parameters, design.id, sealedCode.empty() ? condition.id : sealedCode);
}

core::Result<Station> apexStation(const catalogue::ExerciseLevel& level, const std::string& trainee, std::uint64_t seed) {
    const auto kind = exerciseKind(kExercise);
    if (!kind)
        return tl::unexpected(kind.error());
    return scriptedStation(**kind, level, trainee.empty() ? kUsualTrainee : trainee, seed);
}

core::Result<database::SessionId> runApexSitting(database::Database& database, const database::Actor& actor, const ApexSitting& sitting) {
    auto level = apexStudyLevel(sitting.study.design, sitting.condition, sitting.trials, sessionLabel(sitting.study, sitting.sealedCode));
    if (!level)
        return tl::unexpected(level.error());
    TrainingRequest request;
    request.level = *level;
    request.seed = sitting.seed;
    auto station = apexStation(*level, sitting.trainee, core::Random::mix(sitting.seed, "participant"));
    if (!station)
        return tl::unexpected(station.error());
    request.station = std::move(*station);
    std::atomic<database::SessionId> session{0};
    auto director = ApexDirector::create(*level, sitting.seed, request.station,
                                         {sitting.progress, sitting.study.design, sitting.cancel,
                                          [&](database::StudyTrial trial) {
                                              trial.session = session.load();
                                              return sitting.store(std::move(trial));
                                          }});
    if (!director)
        return tl::unexpected(director.error());
    request.ringFolder = sitting.ringFolder;
    request.studyRun = sitting.run;
    request.director = director->get();
    request.onSession = [&](database::SessionId id) { session.store(id); };
    auto result = runTrainingOn(database, actor, request);
    if (!result)
        return tl::unexpected(result.error());
    if (!(*director)->recorded())
        return tl::unexpected((*director)->recorded().error());
    return result->session;
}

StudyAnswer plannedApexAnswer(double radius_m, std::uint64_t seed, int ordinal) {
    auto random = core::Random::stream(seed, "study.apex " + std::to_string(ordinal));
    const double sd_m = psychophysics::ApexObserver{}.sdPercent / 100.0 * radius_m;
    ApexMark mark;
    mark.errorX_m = sd_m * random.normal();
    mark.errorY_m = sd_m * random.normal();
    mark.radius_m = radius_m;
    mark.planned = true;
    StudyAnswer answer;
    answer.answer = 0;
    answer.value = std::hypot(mark.errorX_m, mark.errorY_m);
    answer.fidelity.apex = mark;
    return answer;
}

} // namespace chiron::session
