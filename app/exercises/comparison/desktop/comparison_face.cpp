// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/comparison/desktop/comparison_face.h"

namespace chiron::desktop {

QString ComparisonFace::debriefTitle() const { return DebriefPartTexts::tr("What was compared"); }

QString ComparisonFace::debriefEmpty() const { return DebriefPartTexts::tr("What was compared and answered is shown with its study."); }

DebriefReading ComparisonFace::readDebrief(const catalogue::ExerciseLevel&, const scoring::SessionTrace&) const {
    return nullptr; // shown with its study
}

} // namespace chiron::desktop
