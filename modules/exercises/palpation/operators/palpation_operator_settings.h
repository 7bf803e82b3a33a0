// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "operators/hand/perception_settings.h"

#include <string>

namespace chiron::operators {

/// How well the scripted palpators feel. The settings are the same for all of them; they differ in what they
/// do. The noises are drawn anew for each press; those of force and lean shrink with the number of looks that
/// a hold contains (PerceptionSettings::forceNoiseTime_s each).
struct PalpationPerceptionSettings {
    /// Sight of the own finger on the drawn surface, force magnitude, and force direction where no platform
    /// tilts the pad: the same noises as those of the sphere-apex trainees, with their sources.
    PerceptionSettings hand;
    /// How far the finger went in: differences of 8 % in limb movement are discriminated (Jones, Hunter &
    /// Irwin 1992, Percept Psychophys 52:529).
    double depthWeberFraction = 0.08;
    /// Comparison of a felt stiffness with remembered ones. Two stiffnesses are discriminated at 23 % (Jones
    /// & Hunter 1990, Exp Brain Res 79:150), which is 23 %/√2 = 16 % per look; 7 % of force and 8 % of depth
    /// explain 11 % of that, and this value is the rest.
    double memoryFraction = 0.12;
    /// Tilt of the pad, for each of its two axes: assumption, of the order of the discrimination of felt
    /// angles, 4.7° (Voisin, Lamarre & Chapman 2002, Exp Brain Res 145:251), /√2.
    double leanNoiseSd_rad = 0.058;
    double touch_N = 0.05; ///< from this force on the finger is taken to be in the tissue: assumption
};

enum class SearchKind {
    /// Strips along y, side by side, with a press at each spot: the vertical strips of clinical breast
    /// examination.
    grid,
    spiral, ///< from the middle outwards
    random, ///< at random places
};

/// One scripted palpator: how it searches, presses and decides. The values are assumptions that are plausible
/// for people; no gate of a level is tuned to them (README.md).
/// Unit: SI.
struct PalpationOperatorSettings {
    std::string name = "expert";
    PalpationPerceptionSettings perception;
    mechanisms::HandParameters hand; ///< pass it on as the simulated device's Configuration::hand

    SearchKind search = SearchKind::grid;
    double spacing_m = 0.008;  ///< least distance between spots; larger where the time is too short
    double reach = 1.0;        ///< share of the area's half-widths that it searches
    double searchShare = 0.66; ///< largest share of a trial's time for the search
    double pressTime_s = 0.68; ///< duration of a spot, known from experience; used for planning
    double aimSd_m = 0.001;    ///< error with which it aims at a spot, per axis

    /// Force that it aims for: 0 is the low, 1 the high end of the instructed band.
    double forceShare = 0.45;
    double pressSd = 0.06; ///< unevenness of its presses: SD of the logarithm of depth
    int pressures = 1;     ///< number of presses at each spot, each deeper than the one before, 1..3
    double reachSpeed_m_per_s = 0.15;
    double pressSpeed_m_per_s = 0.06;
    double hover_m = 0.003; ///< height above the surface between spots
    double hold_s = 0.32;   ///< duration of each press

    int revisits = 4; ///< number of candidates that it presses again before it decides
    /// A candidate is pressed in the middle and at this distance on four sides.
    double revisitRadius_m = 0.005;
    double revisitAbove = 1.2; ///< only candidates with at least this evidence
    double criterion = 3.6;    ///< evidence, in standard errors, from which it reports a lump
};

} // namespace chiron::operators
