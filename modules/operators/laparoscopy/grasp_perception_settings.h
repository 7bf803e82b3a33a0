// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "operators/hand/perception_settings.h"

namespace chiron::operators {

/// How well the scripted laparoscopists feel and see. The settings are the same for all of them; they differ
/// in their strategies. Each noise is a stationary first-order Gauss–Markov process, given by SD and
/// correlation time.
struct GraspPerceptionSettings {
    /// Position and force of each hand: the same noises, with the same sources, as for the sphere-apex
    /// operators. Where the screen shows instruments and objects, sight replaces the felt position.
    PerceptionSettings hand;
    /// Error in reading a bar: a share of the reading, and a floor. Assumption, about the width of the bar's
    /// line.
    double gaugeWeberFraction = 0.02;
    double gaugeFloorSd_N = 0.015;
    double gaugeNoiseTime_s = 0.5;
    /// Error of a seen length: Weber fraction of 2–3 % for lines (Ono 1967, Percept Psychophys 2:201).
    double lengthWeberFraction = 0.025;
    double lengthNoiseTime_s = 0.5; ///< assumption, as for sight
};

} // namespace chiron::operators
