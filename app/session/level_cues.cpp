// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/level_cues.h"

#include <algorithm>

namespace chiron::session {

LevelCues cuesOf(const catalogue::ExerciseLevel& level, bool felt) {
    const bool shown = !felt && level.needsForce && level.shownForce;
    const std::vector<std::string>& words = shown ? level.shownForce->cues : level.cues;
    const auto has = [&words](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); };
    return {.object = has("object"),
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
