// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/debrief/debrief_data.h"
#include "desktop/theme/theme.h"

#include <QLocale>
#include <QString>
#include <memory>

class QWidget;

namespace chiron::desktop {

// The part of a debrief that only one exercise has. Each is chosen by the type of its level's parameters: an exercise without one does
// not compile, and no branch stands for "all others". GUI thread.

/// What stands above it.
QString exercisePartTitle(const catalogue::ExerciseParameters& level);
/// What to say where no trial was begun.
QString exercisePartEmpty(const catalogue::ExerciseParameters& level);
/// Null where there is nothing to show.
std::unique_ptr<QWidget> exercisePart(const Theme& theme, const QLocale& locale, const catalogue::ExerciseParameters& level,
                                      const DebriefDetails& details);

} // namespace chiron::desktop
