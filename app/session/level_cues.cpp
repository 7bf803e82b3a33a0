// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/level_cues.h"

#include "simulation/scene_parameters.h"

namespace chiron::session {

const std::vector<std::string>& cueWordsOf(const catalogue::ExerciseLevel& level, bool felt) {
    return !felt && level.needsForce && level.shownForce ? level.shownForce->cues : level.cues;
}

LevelCues cuesOf(const catalogue::ExerciseLevel& level, bool felt) {
    const std::vector<std::string>& words = cueWordsOf(level, felt);
    const auto has = [&words](const char* word) { return simulation::hasCue(words, word); };
    return {.felt = felt,
            .object = has("object"),
            .tool = has("tool"),
            .arrow = has("arrow"),
            .bars = has("bars"),
            .numbers = has("numbers"),
            .plots = has("plots"),
            .sound = has("sound"),
            .coverage = has("coverage"),
            .overview = has("overview"),
            .guidance = has("guidance")};
}

} // namespace chiron::session
