// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace chiron::desktop {

/// The translation context of pass marks and limits.
struct GateTexts {
    Q_DECLARE_TR_FUNCTIONS(GateWords)
};

/// A pass mark as text with its unit, for example "Misses: at most 1", "Critical errors: none" or, of 100 %,
/// "The procedure is completed". `trials`: the number of trials of the level.
QString gateInWords(const scoring::Gate& gate, const QLocale& locale, int trials = 1);

/// The pass marks of a level, in the level's order. A pass mark that allows more than the limit behind it
/// names that limit and explains the difference. A pass mark that a stricter one implies is left out.
QStringList gatesInWords(const catalogue::ExerciseLevel& level, const QLocale& locale);

/// The limits of a level, one sentence each without a full stop; the force limit on the tissue comes first,
/// then those of the exercise (ExerciseFace::limitWords).
QStringList limitsInWords(const catalogue::ExerciseLevel& level, const QLocale& locale);

} // namespace chiron::desktop
