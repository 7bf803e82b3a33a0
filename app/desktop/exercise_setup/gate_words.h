// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <QLocale>
#include <QStringList>

namespace chiron::desktop {

/// A pass mark in words with its unit: "Misses: at most 0".
QString gateInWords(const scoring::Gate& gate, const QLocale& locale);

/// A level's pass marks, in its order, with the limits that they are about: one that allows more than the limit says why, and one that
/// another, stricter one implies is left out.
QStringList gatesInWords(const catalogue::ExerciseLevel& level, const QLocale& locale);

/// What must not be exceeded at a level, a sentence each: force on the tissue first. Without a full stop.
QStringList limitsInWords(const catalogue::ExerciseLevel& level, const QLocale& locale);

} // namespace chiron::desktop
