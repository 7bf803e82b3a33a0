// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "operators/hand/perception_settings.h"

#include <string>

namespace chiron::operators {

/// How well any of the scripted palpators feels. The same for all of them: they differ in what they do. Every noise is drawn anew
/// for each look at a press (PerceptionSettings::forceNoiseTime_s; a longer hold holds several looks).
struct PalpationPerceptionSettings {
    /// Sight of the own finger on the drawn surface, force magnitude, and force direction where no platform tilts the pad: the
    /// very noises of the sphere-apex trainees, with their sources.
    PerceptionSettings hand;
    /// How far the finger went in: limb movement is told apart by 8 % (Jones, Hunter & Irwin 1992, Percept Psychophys 52:529).
    double depthWeberFraction = 0.08;
    /// A felt stiffness against remembered ones. Two stiffnesses are told apart by 23 % (Jones & Hunter 1990, Exp Brain Res
    /// 79:150), 23 %/√2 = 16 % a look; 7 % of force and 8 % of depth explain 11 % of that, this is the rest.
    double memoryFraction = 0.12;
    /// Tilt of the pad, each of its two axes: assumption, of the order of what is known of felt angles, told apart by 4.7° (Voisin,
    /// Lamarre & Chapman 2002, Exp Brain Res 145:251), /√2.
    double leanNoiseSd_rad = 0.058;
    double touch_N = 0.05; ///< from here on the finger is taken to be in the tissue: assumption
};

enum class SearchKind {
    grid,   ///< strips along y, one beside the other, a press at each spot: the vertical strips of clinical breast examination
    spiral, ///< from the middle outwards
    random, ///< here and there
};

/// One scripted palpator: how it searches, presses and decides. Assumptions, plausible for people; no gate of a level is tuned to
/// them (README.md). SI.
struct PalpationOperatorSettings {
    std::string name = "expert";
    PalpationPerceptionSettings perception;
    mechanisms::HandParameters hand; ///< give it to the simulated device's Configuration::hand

    SearchKind search = SearchKind::grid;
    double spacing_m = 0.008;    ///< between spots, at the closest; wider where time does not reach
    double reach = 1.0;          ///< share of the area's half-widths that it searches
    double searchShare = 0.66;   ///< of a trial's time for the search, at most
    double pressTime_s = 0.68;   ///< that a spot takes, as it knows from experience; to plan with
    double aimSd_m = 0.001;      ///< how far beside a spot it goes, either axis

    double forceShare = 0.45;    ///< the force it wants: 0 the low, 1 the high end of the band it was told
    double pressSd = 0.06;       ///< how unevenly it presses: SD of the logarithm of depth
    int pressures = 1;           ///< at each spot, one deeper than the other, 1..3
    double reachSpeed_m_per_s = 0.15;
    double pressSpeed_m_per_s = 0.06;
    double hover_m = 0.003;      ///< above the surface between spots
    double hold_s = 0.32;        ///< each press

    int revisits = 4;            ///< so many candidates are pressed again before it decides
    double revisitRadius_m = 0.005; ///< in the middle and so far to four sides
    double revisitAbove = 1.2;   ///< only candidates with at least this evidence
    double criterion = 3.6;      ///< evidence, in standard errors, from which it says "a lump"
};

} // namespace chiron::operators
