// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace chiron::desktop {

/// What is particular about a level, a line each, beside its objective: what its exercise says of it (ExerciseFace::levelFacts), then its
/// limits. GUI thread.
QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale);

/// The translation context of these lines.
struct LevelFactTexts {
    Q_DECLARE_TR_FUNCTIONS(LevelFacts)
};

// Lines of several exercises.
QString factNumber(double value, const QLocale& locale); ///< "0.6", to three digits
QString trialsFact(int trials, double limit_s, const QLocale& locale); ///< "Trials: 10, at most 60 s each"

} // namespace chiron::desktop
