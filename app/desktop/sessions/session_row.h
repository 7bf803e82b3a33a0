// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/database.h"
#include "database/repositories/session_types.h"
#include "desktop/sessions/people_names.h"

#include <QHash>
#include <QString>
#include <vector>

namespace chiron::catalogue {
class Catalogue;
}

namespace chiron::desktop {

/// One line of the list of sessions, with what searching and showing it again and again would otherwise make anew.
struct SessionRow {
    database::SessionSummary summary;
    QString person;   ///< as screens call them
    QString exercise; ///< its title
    QString search;   ///< folded: number, person by both names, exercise, operator
};

/// Titles of exercises in the language shown, by id. A value that workers are given.
using ExerciseTitles = QHash<QString, QString>;
ExerciseTitles exerciseTitles(const catalogue::Catalogue& catalogue, const QString& language);

SessionRow makeSessionRow(database::SessionSummary summary, const ExerciseTitles& titles, const PeopleNames& names = {});

/// Lines that the filter asks for. Blocking: a worker's task. Failure: the repository's.
core::Result<std::vector<SessionRow>> readSessionRows(const database::Database& database, const database::Actor& actor,
                                                      const ExerciseTitles& titles, const database::SessionFilter& filter);
/// One line anew, after something about it was changed.
core::Result<SessionRow> readSessionRow(const database::Database& database, const database::Actor& actor,
                                        const ExerciseTitles& titles, database::SessionId session);

} // namespace chiron::desktop
