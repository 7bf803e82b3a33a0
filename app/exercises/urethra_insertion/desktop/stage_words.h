// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// The stage of an endoscopic procedure, in words. All functions of this header are pure.
QString stageTitle(simulation::ProcedureStage stage); ///< "Insertion"

/// The facts beside the stage itself that a level allows to be shown.
struct StageTelling {
    bool numbers = false;  ///< the depth reached and the depth to reach
    bool guidance = false; ///< how long a landmark has been held
    double goal_m = 0.0;   ///< depth that ends the insertion
    double clear_m = 0.0;  ///< distance outside at which the tip ends the withdrawal, since its beak must be
                           ///< out as well
};

/// One sentence about what to do now; "Insertion: 32 of 97 mm" where numbers are shown.
QString stageText(const simulation::EndoscopeCues& cues, const StageTelling& telling, const QLocale& locale);

/// The completed share of the stage, 0..1; negative if the level hides it or the stage has no measure.
double stageProgress(const simulation::EndoscopeCues& cues, const StageTelling& telling);

int landmarksSeen(const simulation::EndoscopeCues& cues); ///< number of landmarks seen

} // namespace chiron::desktop
