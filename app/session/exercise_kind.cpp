// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/exercise_kind.h"

namespace chiron::session {

std::vector<devices::WorkspaceMapping> usualPlaces(const ExerciseKind& kind, const catalogue::ExerciseLevel& level) {
    std::vector<devices::WorkspaceMapping> places;
    for (int tool = 0; tool < kind.toolCount(level); ++tool)
        places.push_back(kind.toolPlace(level, tool));
    return places;
}

} // namespace chiron::session
