// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "haptics/display_state.h"
#include "session/level_limits.h"

#include <QLocale>
#include <QString>
#include <functional>

namespace chiron::desktop {

/// The properties of a level with graspers that the training screen needs.
struct Grasping {
    /// Which force on the held object is measured: the tension, or the squeeze of the jaws.
    enum class Measured { tension, squeeze };

    double forceLimit_N = session::LevelLimits{}.force_N; ///< on the tissue
    int tools = 1;
    Measured measured = Measured::squeeze;
    double measuredEnd_N = 1.0;   ///< end of its scale
    double measuredLimit_N = 0.0; ///< 0: it has a band instead
    /// End of the scale of the pull on a fold of tissue; 0: no fold is retracted.
    double retractionEnd_N = 0.0;
    double retractionLimit_N = 0.0; ///< 0: nothing limits the pull
    int retractor = -1;             ///< the tool that retracts the fold; -1: none

    // The rules by which the scene lets jaws grasp (GraspLatch).
    double reach_m = 0.0;
    double holdsBelow_rad = 0.0;
    double opensAbove_rad = 0.0;

    /// The present step as a sentence.
    std::function<QString(const core::LaparoscopyCues&, const QLocale&)> step;
    std::function<QString(const core::LaparoscopyCues&, const QLocale&)> held; ///< "Holding: object 2 of 3"
    /// The load as a number: "Stretched by 12.3 mm".
    std::function<QString(const haptics::DisplayState&, const QLocale&)> load;
};

} // namespace chiron::desktop
