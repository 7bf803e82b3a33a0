// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::session {

class PlaybackTrack;

/// Names each stage change of a task with graspers after the step that began (PlaybackMark::detail), from its
/// recorded quantity "step" (core::LaparoscopyStep); changes nothing if the steps were not recorded. For
/// ExerciseKind::addMarks.
void nameSteps(PlaybackTrack& track);

} // namespace chiron::session
