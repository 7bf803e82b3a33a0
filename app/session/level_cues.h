// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <string>
#include <vector>

namespace chiron::session {

/// The cues that a level shows or plays on the current class of device; all others are off.
struct LevelCues {
    bool felt = false; ///< the class: the person feels the force; otherwise it is only shown
    bool object = false;
    bool tool = false;
    bool arrow = false;
    bool bars = false;
    bool numbers = false;
    bool plots = false;
    bool sound = false;
    bool coverage = false;
    bool overview = false; ///< endoscopy: a second picture, from outside
    bool guidance = false; ///< endoscopy: the picture marks the way
};

/// The cue words for the current class of device: the level's own, or those of its shown-force variant. Pure
/// function.
const std::vector<std::string>& cueWordsOf(const catalogue::ExerciseLevel& level, bool felt);

/// The cues of a level. A level that needs force uses its shown-force variant on a device that renders none.
/// Pure function.
LevelCues cuesOf(const catalogue::ExerciseLevel& level, bool felt);

} // namespace chiron::session
