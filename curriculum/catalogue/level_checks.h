// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "catalogue/problems.h"

class QJsonObject;

namespace chiron::catalogue {

/// Checks the rules for a level of any exercise that the ranges of its keys cannot express: every metric
/// exists, gates use the level's own metrics in their units, a level that does not show the object needs
/// force, and only such a level may have a shown-force variant. Paths in `problems` are those of the level's
/// file.
void checkLevel(const ExerciseLevel& level, const QJsonObject& json, Problems& problems);

} // namespace chiron::catalogue
