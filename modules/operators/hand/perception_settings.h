// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::operators {

/// How well the scripted operators feel and see. The settings are the same for all of them; operators differ
/// in their strategies. Each noise is a stationary first-order Gauss–Markov process, given by SD and
/// correlation time.
struct PerceptionSettings {
    /// Error of the unseen hand's felt position, per axis. SD: joint angles are known to 0.6–1.1° (van Beers,
    /// Sittig & Denier van der Gon 1998, Exp Brain Res 122:367), about 6 mm at 0.4 m of arm. The error
    /// wanders slowly (drift of the unseen hand: Wann & Ibrahim 1992, Exp Brain Res 91:162; Brown, Rosenbaum
    /// & Sainburg 2003, Exp Brain Res 153:266); the time is an assumption.
    double positionBiasSd_m = 0.006;
    double positionBiasTime_s = 120.0;
    /// Fast variation of the same sense within a movement: assumption.
    double positionNoiseSd_m = 0.0015;
    double positionNoiseTime_s = 0.25;
    /// Error of the seen tool relative to the seen object; it replaces the two above: assumption.
    double visionNoiseSd_m = 0.0015;
    double visionNoiseTime_s = 0.5;
    /// Force magnitude: Weber fraction of about 7 % (Pang, Tan & Durlach 1991, Percept Psychophys 49:531),
    /// and a floor in newtons (assumption).
    double forceWeberFraction = 0.07;
    double forceFloorSd_N = 0.03;
    double forceNoiseTime_s = 0.25; ///< duration of one percept: assumption
    /// Force direction, about each of two axes. A discrimination threshold of 25.6° (Barbagli et al. 2006,
    /// ACM Trans Appl Percept 3:125; Tan et al. 2006: similar) between two percepts leaves 25.6°/√2 = 18° for
    /// each.
    double directionNoiseSd_rad = 0.316;
    /// Lasting error in the judged force direction, wandering slowly: assumption.
    double directionBiasSd_rad = 0.087;
    double directionBiasTime_s = 120.0;
};

} // namespace chiron::operators
