// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <string>
#include <vector>

namespace chiron::session {

/// What a level lets a person see and hear, on the kind of device at hand; all else is off.
struct LevelCues {
    bool object = false;
    bool tool = false;
    bool arrow = false;
    bool bars = false;
    bool numbers = false;
    bool plots = false;
    bool sound = false;
    bool coverage = false;
    bool overview = false; ///< endoscopy: a second picture, from outside
    bool guidance = false; ///< endoscopy: the way is marked in the picture
};

/// The cue words that hold on the kind of device at hand: a level's own, or those of its shown-force variant. Pure.
const std::vector<std::string>& cueWordsOf(const catalogue::ExerciseLevel& level, bool felt);

/// A level that needs force, done on a device that renders none, has cues of its own (its shown-force variant). Pure.
LevelCues cuesOf(const catalogue::ExerciseLevel& level, bool felt);

} // namespace chiron::session
