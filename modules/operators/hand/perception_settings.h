// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::operators {

/// How well any of the scripted trainees feels and sees. The same for all of them: they differ in what they
/// do. Each noise is a stationary first-order Gauss–Markov process given by SD and correlation time.
struct PerceptionSettings {
    /// Where the unseen hand is, per axis. SD: joint angles are known to 0.6–1.1° (van Beers, Sittig & Denier
    /// van der Gon 1998, Exp Brain Res 122:367), about 6 mm at 0.4 m of arm. It wanders slowly (drift of the
    /// unseen hand: Wann & Ibrahim 1992, Exp Brain Res 91:162; Brown, Rosenbaum & Sainburg 2003, Exp Brain
    /// Res 153:266); the time is an assumption.
    double positionBiasSd_m = 0.006;
    double positionBiasTime_s = 120.0;
    /// Quick variation of the same sense within a movement: assumption.
    double positionNoiseSd_m = 0.0015;
    double positionNoiseTime_s = 0.25;
    /// Seen tool against seen object, in place of the two above: assumption.
    double visionNoiseSd_m = 0.0015;
    double visionNoiseTime_s = 0.5;
    /// Force magnitude: Weber fraction of about 7 % (Pang, Tan & Durlach 1991, Percept Psychophys 49:531),
    /// and a floor in newtons (assumption).
    double forceWeberFraction = 0.07;
    double forceFloorSd_N = 0.03;
    double forceNoiseTime_s = 0.25; ///< one look takes that long: assumption
    /// Force direction, about each of two axes: a discrimination threshold of 25.6° (Barbagli et al. 2006,
    /// ACM Trans Appl Percept 3:125; Tan et al. 2006: similar) between two looks leaves 25.6°/√2 = 18° a
    /// look.
    double directionNoiseSd_rad = 0.316;
    /// Lasting misjudgement of force direction, wandering slowly: assumption.
    double directionBiasSd_rad = 0.087;
    double directionBiasTime_s = 120.0;
};

} // namespace chiron::operators
