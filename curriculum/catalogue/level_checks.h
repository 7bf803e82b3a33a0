// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "catalogue/problems.h"

class QJsonObject;

namespace chiron::catalogue {

/// What a level of any exercise must keep beyond its keys' ranges: metrics that exist, gates on the level's
/// own metrics in their units, force where nothing is seen, a shown-force variant only there. Paths are those
/// of the level's file.
void checkLevel(const ExerciseLevel& level, const QJsonObject& json, Problems& problems);

} // namespace chiron::catalogue
