// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// What participants read in addition to the frozen instructions, because it depends on the station or is not
/// part of those: whether they hear a noise, and the force and speed from which on a trial is repeated.
/// `noise`: the masking noise is played and can be heard. In the program's language.
QString sittingSentences(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                         bool noise, const QLocale& locale);

} // namespace chiron::desktop
