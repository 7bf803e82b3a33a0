// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace chiron::desktop {

/// Facts about a level, one per line, to show beside its objective: first those of the exercise
/// (ExerciseFace::levelFacts), then the level's limits.
/// Thread: GUI.
QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale);

/// The translation context of these lines.
struct LevelFactTexts {
    Q_DECLARE_TR_FUNCTIONS(LevelFacts)
};

// Lines that several exercises share.
QString factNumber(double value, const QLocale& locale); ///< "0.6"; three significant digits
QString trialsFact(int trials, double limit_s,
                   const QLocale& locale); ///< "Trials: 10; each ends after 60 s at the latest"

} // namespace chiron::desktop
