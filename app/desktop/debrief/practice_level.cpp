// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/practice_level.h"

#include <algorithm>

namespace chiron::desktop {

const catalogue::ExerciseLevel* practiceLevel(const catalogue::Exercise& exercise, int level,
                                              std::string_view metric) {
    const auto judges = [metric](const catalogue::ExerciseLevel& lower) {
        return std::any_of(lower.gates.begin(), lower.gates.end(),
                           [metric](const scoring::Gate& gate) { return gate.metric == metric; });
    };
    const catalogue::ExerciseLevel* best = nullptr;
    for (const catalogue::ExerciseLevel& lower : exercise.levels) // by number, from 1
        if (lower.number < level && judges(lower) && (best == nullptr || lower.feedback || !best->feedback))
            best = &lower;
    return best;
}

} // namespace chiron::desktop
