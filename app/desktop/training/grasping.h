// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/display_state.h"
#include "session/level_limits.h"
#include "core/laparoscopy_cues.h"

#include <QLocale>
#include <QString>
#include <functional>

namespace chiron::desktop {

/// What the training screen asks of a level that is done with graspers.
struct Grasping {
    enum class Measured { tension, squeeze }; ///< what is done to what is held: pulled, or squeezed by the jaws

    session::LevelLimits limits{};
    int tools = 1;
    Measured measured = Measured::squeeze;
    double measuredEnd_N = 1.0;   ///< of its scale
    double measuredLimit_N = 0.0; ///< 0: it has a band
    double retractionEnd_N = 0.0; ///< of the scale of the pull on a fold of tissue; 0: none is held back
    int retractor = -1;           ///< the tool that holds it back; -1: none

    // The rules by which the scene lets jaws take hold (GraspLatch).
    double reach_m = 0.0;
    double holdsBelow_rad = 0.0;
    double opensAbove_rad = 0.0;

    std::function<QString(const core::LaparoscopyCues&, const QLocale&)> step; ///< what to do now, as a sentence
    std::function<QString(const core::LaparoscopyCues&, const QLocale&)> held; ///< "Holding: object 2 of 3"
    std::function<QString(const haptics::DisplayState&, const QLocale&)> load; ///< what is held, in a number: "Stretched by 12.3 mm"
};

} // namespace chiron::desktop
