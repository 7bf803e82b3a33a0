// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::operators {

/// How well the scripted endoscopists feel and see. The settings are the same for all of them; they differ in
/// what they do. Each noise is a stationary first-order Gauss–Markov process given by SD and correlation
/// time.
struct EndoscopePerceptionSettings {
    /// Felt orientation of the instrument in the unseen hand, per angle: joint angles are known to 0.6–1.1°
    /// (van Beers, Sittig & Denier van der Gon 1998, Exp Brain Res 122:367). It wanders slowly, as the felt
    /// position does (Wann & Ibrahim 1992, Exp Brain Res 91:162; the time is an assumption).
    double angleBiasSd_rad = 0.017;
    double angleBiasTime_s = 120.0;
    /// Fast variation of the same sense: assumption.
    double angleNoiseSd_rad = 0.009;
    double angleNoiseTime_s = 0.25;
    /// Direction of the lumen (or a landmark) in the picture, per axis: assumption, about a tenth of the
    /// picture's radius where the path is marked in it …
    double pictureNoiseSd_rad = 0.025;
    double pictureNoiseTime_s = 0.5;
    /// … and larger by this factor where it is not marked (level without guidance): assumption.
    double unmarkedFactor = 2.0;
    double distanceWeberFraction = 0.25; ///< distance ahead as judged from a monocular picture: assumption
    double depthNoiseSd_m = 0.0015;      ///< reading the marks on the shaft, 10 mm apart: assumption
    double depthNoiseTime_s = 1.0;
    /// Force magnitude: Weber fraction of about 7 % (Pang, Tan & Durlach 1991, Percept Psychophys 49:531),
    /// and a floor in newtons (assumption). Torque likewise; discrimination of torque is coarser, about 13 %
    /// (Jandura & Srinivasan 1994, ASME DSC 55-1:369).
    double forceWeberFraction = 0.07;
    double forceFloorSd_N = 0.03;
    double torqueWeberFraction = 0.13;
    double torqueFloorSd_Nm = 0.002;
    double forceNoiseTime_s = 0.25; ///< duration of one look: assumption
    /// Force direction: 18° per look, from a discrimination threshold of 25.6° between two (Barbagli et al.
    /// 2006, ACM Trans Appl Percept 3:125), and a lasting misjudgement (assumption).
    double directionNoiseSd_rad = 0.316;
    double directionBiasSd_rad = 0.087;
    double directionBiasTime_s = 120.0;
};

} // namespace chiron::operators
