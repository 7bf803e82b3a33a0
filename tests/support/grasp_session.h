// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "support/desktop_fixture.h"

#include <algorithm>

namespace chiron::tests {

/// A session of an exercise with graspers by a scripted operator, in the name of a person as by their own
/// hand: a level as it is shipped, with fewer trials, as fast as the machine can. 0 where the catalogue has
/// no such level.
inline database::SessionId addGrasping(DesktopFixture& desktop, const std::string& person,
                                       const std::string& exercise, int level = 1,
                                       const std::string& operatorName = "intermediate", int trials = 2) {
    const catalogue::ExerciseLevel* shipped = desktop.context.site().catalogue().find(exercise, level);
    if (!shipped)
        return 0;
    session::TrainingRequest request;
    request.level = *shipped;
    request.seed = 7;
    request.ringFolder = recording::defaultRingFolder();
    if (auto* tube = request.level.parameters.find<simulation::ElasticTubeParameters>())
        tube->trials = std::min(tube->trials, trials);
    if (auto* handling = request.level.parameters.find<simulation::ObjectHandlingParameters>())
        handling->trials = std::min(handling->trials, trials);
    const auto kind = session::exerciseKind(exercise);
    auto station = session::scriptedStation(**kind, request.level, operatorName, request.seed);
    if (!station)
        qFatal("%s", station.error().message.c_str());
    request.station = std::move(*station);
    request.station.operatorName.clear();
    auto result = session::runTraining(desktop.database(), desktop.actor(person), std::move(request));
    if (!result)
        qFatal("%s", result.error().message.c_str());
    return result->session;
}

} // namespace chiron::tests
