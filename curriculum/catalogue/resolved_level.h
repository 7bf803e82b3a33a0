// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "catalogue/problems.h"

#include <QJsonObject>

namespace chiron::catalogue {

/// Returns the document that a session stores: `format`, the exercise's id, version and texts, and the level
/// with every default filled in.
QJsonObject resolvedDocument(const QJsonObject& exercise, const QJsonObject& level);

/// Returns the document of a level without its texts, which leaves what was felt and judged. It depends on
/// nothing else, and accepts today's documents and all that sessions have stored.
QJsonObject withoutTexts(QJsonObject document);

/// Converts JSON to an ExerciseLevel. Today's files and stored sessions both use this one conversion. Paths
/// in `problems` are those of the level's own object, from "$".
ExerciseLevel levelFromResolved(const QJsonObject& document, Problems& problems);

} // namespace chiron::catalogue
