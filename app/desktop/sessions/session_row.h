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

/// One row of the session list, with cached texts for searching and display.
struct SessionRow {
    database::SessionSummary summary;
    QString person;   ///< name as screens show it
    QString exercise; ///< its title
    QString search;   ///< folded: number, both names of the person, exercise, operator
};

/// Titles of exercises by id, in the displayed language. A value that is passed to workers.
using ExerciseTitles = QHash<QString, QString>;
ExerciseTitles exerciseTitles(const catalogue::Catalogue& catalogue, const QString& language);

SessionRow makeSessionRow(database::SessionSummary summary, const ExerciseTitles& titles,
                          const PeopleNames& names = {});

/// Reads the rows that match the filter.
/// Thread: worker; blocks.
/// Errors: those of the repository.
core::Result<std::vector<SessionRow>> readSessionRows(const database::Database& database,
                                                      const database::Actor& actor,
                                                      const ExerciseTitles& titles,
                                                      const database::SessionFilter& filter);
/// Reads one row again after its session changed.
core::Result<SessionRow> readSessionRow(const database::Database& database, const database::Actor& actor,
                                        const ExerciseTitles& titles, database::SessionId session);

} // namespace chiron::desktop
