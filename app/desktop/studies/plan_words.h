// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/planning/study_plan.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// How many of a condition's simulated runs would give no value that a group can use, and from how many
/// trials on hardly any would. `plan`: with simulated runs and `withoutValue`. Thread: GUI.
QString runsWithoutValueWords(const psychophysics::ConditionPlan& plan, const QLocale& locale);

} // namespace chiron::desktop
