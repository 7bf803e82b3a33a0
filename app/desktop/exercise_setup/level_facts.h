// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <QLocale>
#include <QStringList>

namespace chiron::desktop {

/// What is particular about a level, a line each, beside its objective; empty where the objective says it all. GUI thread.
QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale);

} // namespace chiron::desktop
