// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "catalogue/problems.h"

#include <QJsonObject>

namespace chiron::catalogue {

/// The document that a session stores: `format`, the exercise's id, version and texts, and the level, every
/// default filled in.
QJsonObject resolvedDocument(const QJsonObject& exercise, const QJsonObject& level);

/// The document of a level without its texts: what was felt and judged. Pure; for today's documents and for all that sessions have stored.
QJsonObject withoutTexts(QJsonObject document);

/// The one way from JSON to an ExerciseLevel, for today's files and for stored sessions alike. Paths in
/// `problems` are those of the level's own object, from "$".
ExerciseLevel levelFromResolved(const QJsonObject& document, Problems& problems);

} // namespace chiron::catalogue
