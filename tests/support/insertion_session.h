// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/desktop_fixture.h"

namespace chiron::tests {

/// A scripted insertion done in the name of a person, as fast as the machine can, at a level as it is shipped.
inline database::SessionId addInsertion(DesktopFixture& desktop, const std::string& person, int level = 1,
                                        const std::string& operatorName = "expert", std::uint64_t seed = 1) {
    const catalogue::ExerciseLevel* shipped = desktop.context.site().catalogue().find("urethra_insertion", level);
    if (!shipped)
        qFatal("no level %d of urethra_insertion", level);
    session::TrainingRequest request;
    request.level = *shipped;
    request.seed = seed;
    request.ringFolder = recording::defaultRingFolder();
    auto station = session::scriptedStation(**session::exerciseKind(shipped->exercise), operatorName, seed);
    if (!station)
        qFatal("%s", station.error().message.c_str());
    request.station = std::move(*station);
    auto result = session::runTraining(desktop.database(), desktop.actor(person), std::move(request));
    if (!result)
        qFatal("%s", result.error().message.c_str());
    return result->session;
}

} // namespace chiron::tests
