// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/palette_search.h"

#include "database/repositories/account_repository.h"
#include "database/repositories/session_reader.h"
#include "database/repositories/study_reader.h"
#include "desktop/sessions/session_row.h"
#include "desktop/sessions/session_words.h"

#include <algorithm>

namespace chiron::desktop {

namespace {

/// The translation context of the texts.
struct PaletteSearch {
    Q_DECLARE_TR_FUNCTIONS(PaletteSearch)
};

std::vector<NamedThing>& of(SearchIndex& index, ThingKind kind) {
    return index.things[static_cast<std::size_t>(kind)];
}

void add(SearchIndex& index, ThingKind kind, const QString& text, const QString& more, Place place) {
    of(index, kind).push_back({text, forSearch(text + QLatin1Char(' ') + more), std::move(place)});
}

/// Returns whether the reading succeeded. A missing permission gives no results; any other error is reported.
template <class T> bool isThere(const core::Result<T>& read, SearchIndex& index) {
    if (!read && read.error().code != core::ErrorCode::notAllowed)
        index.problems.push_back(read.error());
    return read.has_value();
}

QString in(const catalogue::Translated& text, const SearchQuestion& question) {
    return QString::fromStdString(catalogue::textIn(text, question.language.toStdString()));
}

void addExercises(SearchIndex& index, const SearchQuestion& question) {
    for (const catalogue::Exercise& exercise : question.catalogue.exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            add(index, ThingKind::exercise,
                PaletteSearch::tr("%1, level %2: %3")
                    .arg(in(exercise.title, question), question.locale.toString(level.number),
                         in(level.title, question)),
                {},
                {QStringLiteral("exercise_setup"),
                 {{QStringLiteral("exercise"), QString::fromStdString(exercise.id)},
                  {QStringLiteral("level"), level.number}}});
}

/// The person's roles as they are now; they may have changed since the login.
database::RoleSet rolesNow(SearchIndex& index, database::Connection& connection,
                           const SearchQuestion& question) {
    const auto self =
        database::AccountRepository(connection, question.actor).person(question.actor.personId());
    return isThere(self, index) ? self->roles : database::RoleSet();
}

void addPeople(SearchIndex& index, database::Connection& connection, const SearchQuestion& question,
               const database::RoleSet& roles) {
    const auto people = database::AccountRepository(connection, question.actor).listPeople();
    if (!isThere(people, index))
        return;
    const bool keepsAccounts = roles.contains(database::Role::admin);
    for (const database::Person& person : *people) {
        const QString name = QString::fromStdString(person.name),
                      full = QString::fromStdString(person.displayName);
        add(index, ThingKind::person, full.isEmpty() ? name : PaletteSearch::tr("%1 (%2)").arg(full, name),
            {},
            {keepsAccounts ? QStringLiteral("people") : QStringLiteral("sessions"),
             {{QStringLiteral("person"), qlonglong(person.id)}}});
    }
}

void addSessions(SearchIndex& index, database::Connection& connection, const SearchQuestion& question,
                 const database::RoleSet& roles, const std::atomic<bool>& cancel) {
    database::SessionFilter filter;
    filter.newestFirst = true;
    const auto sessions = database::SessionReader(connection, question.actor).listSessions(filter);
    if (!isThere(sessions, index))
        return;
    const auto names = PeopleNames::read(connection, question.actor);
    if (!isThere(names, index))
        return;
    const ExerciseTitles titles = exerciseTitles(question.catalogue, question.language);
    const bool hasList = roles.contains(database::Role::trainer) ||
                         roles.contains(database::Role::researcher) || roles.contains(database::Role::admin);
    for (const database::SessionSummary& session : *sessions) {
        if (cancel.load(std::memory_order_relaxed))
            return;
        const bool opens = session.state != database::SessionState::running && !session.sealed;
        if (!opens && !hasList)
            continue;
        const QString id = QString::fromStdString(session.exercise);
        const QString when = SessionWords::started(session, question.locale);
        const qlonglong number = session.id;
        add(index, ThingKind::session,
            PaletteSearch::tr("Session %1: %2, level %3, %4, %5")
                .arg(QString::number(number), titles.value(id, id), question.locale.toString(session.level),
                     QString::fromStdString(names->of(session)), when),
            QString::fromStdString(session.personName + ' ' + session.operatorName),
            opens ? Place{QStringLiteral("debrief"), {{QStringLiteral("session"), number}}}
                  : Place{QStringLiteral("sessions"), {{QStringLiteral("selected"), number}}});
    }
}

void addStudies(SearchIndex& index, database::Connection& connection, const SearchQuestion& question) {
    const auto studies = database::StudyReader(connection, question.actor).listStudies();
    if (!isThere(studies, index))
        return;
    for (const database::StudySummary& study : *studies) {
        const QString key = QString::fromStdString(study.key), title = QString::fromStdString(study.title);
        add(index, ThingKind::study, title.isEmpty() ? key : title, key,
            {QStringLiteral("study"), {{QStringLiteral("study"), qlonglong(study.id)}}});
    }
}

/// 0: a word is missing; 1: all words occur; 2: each is at the beginning of a word.
int fitOf(const QStringList& words, const QString& folded) {
    int fit = 2;
    for (const QString& word : words) {
        qsizetype at = folded.indexOf(word);
        if (at < 0)
            return 0;
        while (at > 0 && folded.at(at - 1).isLetterOrNumber()) {
            at = folded.indexOf(word, at + 1);
            if (at < 0)
                break;
        }
        fit = at < 0 ? 1 : fit;
    }
    return fit;
}

} // namespace

QString forSearch(const QString& text) {
    QString out;
    out.reserve(text.size());
    for (const QChar c : text.normalized(QString::NormalizationForm_D).toCaseFolded())
        if (!c.isMark())
            out += c;
    return out;
}

SearchIndex readSearchIndex(const database::Database& database, const SearchQuestion& question,
                            const std::atomic<bool>& cancel) {
    SearchIndex index;
    addExercises(index, question);
    const auto reader = database.openReader();
    if (!isThere(reader, index))
        return index;
    const database::RoleSet roles = rolesNow(index, **reader, question);
    addPeople(index, **reader, question, roles);
    addStudies(index, **reader, question);
    addSessions(index, **reader, question, roles, cancel);
    return index;
}

FoundThings findThings(const SearchIndex& index, ThingKind kind, const QString& typed, int most) {
    const QStringList words = forSearch(typed).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    FoundThings found;
    if (words.isEmpty())
        return found;
    std::vector<const NamedThing*> further;
    for (const NamedThing& thing : index.things[static_cast<std::size_t>(kind)]) {
        const int fit = fitOf(words, thing.folded);
        found.all += fit > 0 ? 1 : 0;
        if (fit > 0 && static_cast<int>((fit == 2 ? found.best : further).size()) < most)
            (fit == 2 ? found.best : further).push_back(&thing);
    }
    for (const NamedThing* thing : further)
        if (static_cast<int>(found.best.size()) < most)
            found.best.push_back(thing);
    return found;
}

} // namespace chiron::desktop
