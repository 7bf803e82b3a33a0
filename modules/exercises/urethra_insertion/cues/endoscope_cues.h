// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/cues/procedure_stage.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::simulation {

/// Contents of the picture at an endoscope's tip and of the marks on its shaft in this tick, for scripted
/// operators and for the screen's texts. The camera frame is T: it looks along −z of T, with x to the right
/// and y up. Values that the level does not show stay zero. Trivially copyable.
struct EndoscopeCues {
    bool present = false;      ///< this exercise has an endoscope
    bool pictureShown = false; ///< cue "object": the camera's picture is on
    bool guided = false;       ///< cue "guidance": the path is marked in the picture
    simulation::ProcedureStage stage = simulation::ProcedureStage::outside;
    /// Insertion depth of the tip by the marks on the shaft (arc length of the urethra); < 0 before A.
    double depth_m = 0.0;
    /// Unit direction, in T, to the centre of the lumen at the greatest distance at which it can be seen.
    /// Zero if not pictureShown, or where the picture shows only wall (simulation's LumenSight has the rule).
    std::array<double, 3> toLumen_T{};
    double lumenDistance_m = 0.0;
    bool landmarkShown = false;           ///< the next landmark of the bladder lies in the picture
    std::array<double, 3> toLandmark_T{}; ///< m, from the tip; zero unless landmarkShown
    int landmarks = 0;                    ///< number to be visited in this trial
    std::uint32_t landmarksSeen = 0;      ///< one bit each, in the order of the content
    /// 0..1: share of the holding time that the landmark in view has had.
    double dwell = 0.0;
};

static_assert(std::is_trivially_copyable_v<EndoscopeCues>);

} // namespace chiron::simulation
