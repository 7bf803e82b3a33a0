// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// Where an endoscopic procedure stands, in words. Pure.
QString stageTitle(core::ProcedureStage stage); ///< "Insertion"

/// What a level lets be told beside the stage itself.
struct StageTelling {
    bool numbers = false;  ///< how far in, of how far
    bool guidance = false; ///< how long a landmark has been held
    double goal_m = 0.0;   ///< depth that ends the insertion
    double clear_m = 0.0;  ///< how far the tip has to be outside to end the withdrawal: its beak is out as well
};

/// One sentence about what to do now; "Insertion: 32 of 97 mm" where numbers are shown.
QString stageText(const simulation::EndoscopeCues& cues, const StageTelling& telling, const QLocale& locale);

/// How much of the stage is done, 0..1; below 0 where nothing of it may be told or the stage has no measure.
double stageProgress(const simulation::EndoscopeCues& cues, const StageTelling& telling);

int landmarksSeen(const simulation::EndoscopeCues& cues); ///< how many

} // namespace chiron::desktop
