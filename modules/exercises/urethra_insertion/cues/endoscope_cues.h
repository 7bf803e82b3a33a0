// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/procedure_stage.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::simulation {

/// What the picture at an endoscope's tip and the marks on its shaft tell at this tick, for scripted operators and for the
/// screen's words. The camera frame is T: it looks along −z of T, x to the right and y up. Whatever the level does not show
/// stays zero. Trivially copyable.
struct EndoscopeCues {
    bool present = false;      ///< this exercise has an endoscope
    bool pictureShown = false; ///< cue "object": the camera's picture is on
    bool guided = false;       ///< cue "guidance": the way is marked in the picture
    core::ProcedureStage stage = core::ProcedureStage::outside;
    double depth_m = 0.0; ///< how far the tip is in, by the marks on the shaft (arc length of the urethra); < 0 before A
    /// Unit direction, in T, to the middle of the lumen as far ahead as it can be seen (pictureShown), else zero; zero, too,
    /// where the picture shows wall alone (simulation's LumenSight has the rule).
    std::array<double, 3> toLumen_T{};
    double lumenDistance_m = 0.0;
    bool landmarkShown = false;          ///< the next landmark of the bladder lies in the picture
    std::array<double, 3> toLandmark_T{}; ///< m, from the tip; zero unless landmarkShown
    int landmarks = 0;                   ///< to be visited in this trial
    std::uint32_t landmarksSeen = 0;     ///< one bit each, in the order of the content
    double dwell = 0.0;                  ///< 0..1: how much of the holding time the landmark in view has had
};

static_assert(std::is_trivially_copyable_v<EndoscopeCues>);

} // namespace chiron::simulation
