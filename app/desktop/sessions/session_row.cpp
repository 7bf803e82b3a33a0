// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/session_row.h"

#include "catalogue/catalogue.h"
#include "database/repositories/session_reader.h"
#include "desktop/sessions/session_words.h"
#include "session/exercise_kind.h"

namespace chiron::desktop {

ExerciseTitles exerciseTitles(const catalogue::Catalogue& catalogue, const QString& language) {
    ExerciseTitles titles;
    for (const catalogue::Exercise& exercise : catalogue.exercises())
        titles.insert(QString::fromStdString(exercise.id),
                      QString::fromStdString(catalogue::textIn(exercise.title, language.toStdString())));
    for (const session::ExerciseKind* kind : session::exerciseKinds())
        if (kind->onlyInStudies())
            titles.insert(QString::fromUtf8(kind->id().data(), static_cast<qsizetype>(kind->id().size())),
                          SessionWords::study());
    return titles;
}

SessionRow makeSessionRow(database::SessionSummary summary, const ExerciseTitles& titles,
                          const PeopleNames& names) {
    SessionRow row;
    row.person = QString::fromStdString(names.of(summary));
    const QString id = QString::fromStdString(summary.exercise);
    row.exercise = titles.value(id, id);
    row.search = (QString::number(summary.id) + QLatin1Char('\n') + row.person + QLatin1Char('\n') +
                  QString::fromStdString(summary.personName) + QLatin1Char('\n') + row.exercise +
                  QLatin1Char('\n') + QString::fromStdString(summary.operatorName))
                     .toCaseFolded();
    row.summary = std::move(summary);
    return row;
}

core::Result<std::vector<SessionRow>> readSessionRows(const database::Database& database,
                                                      const database::Actor& actor,
                                                      const ExerciseTitles& titles,
                                                      const database::SessionFilter& filter) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    auto sessions = database::SessionReader(**reader, actor).listSessions(filter);
    CHIRON_TRY(sessions);
    const auto names = PeopleNames::read(**reader, actor);
    CHIRON_TRY(names);
    std::vector<SessionRow> rows;
    rows.reserve(sessions->size());
    for (database::SessionSummary& session : *sessions)
        rows.push_back(makeSessionRow(std::move(session), titles, *names));
    return rows;
}

core::Result<SessionRow> readSessionRow(const database::Database& database, const database::Actor& actor,
                                        const ExerciseTitles& titles, database::SessionId session) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    auto record = database::SessionReader(**reader, actor).session(session);
    CHIRON_TRY(record);
    const auto names = PeopleNames::read(**reader, actor);
    CHIRON_TRY(names);
    return makeSessionRow(std::move(record->summary), titles, *names);
}

} // namespace chiron::desktop
