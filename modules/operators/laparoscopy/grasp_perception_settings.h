// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "operators/hand/perception_settings.h"

namespace chiron::operators {

/// How well any of the scripted laparoscopists feels and sees. The same for all of them: they differ in what they do. Each noise
/// is a stationary first-order Gauss–Markov process given by SD and correlation time.
struct GraspPerceptionSettings {
    /// Place and force of each hand: the very noises of the sphere-apex trainees, with their sources. Seen instruments and
    /// objects take the place of the felt hand where the screen shows them.
    PerceptionSettings hand;
    /// Reading a bar: of what is read, and a floor. Assumption, about a line's width of the bar.
    double gaugeWeberFraction = 0.02;
    double gaugeFloorSd_N = 0.015;
    double gaugeNoiseTime_s = 0.5;
    /// Length of something seen: Weber fraction of 2–3 % for lines (Ono 1967, Percept Psychophys 2:201).
    double lengthWeberFraction = 0.025;
    double lengthNoiseTime_s = 0.5; ///< assumption, as for sight
};

} // namespace chiron::operators
