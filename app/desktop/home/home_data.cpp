// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/home_data.h"

#include "database/accounts/account_service.h"
#include "database/repositories/session_reader.h"
#include "desktop/home/comment_list.h"
#include "desktop/playback/playback_data.h"
#include "desktop/sessions/session_words.h"
#include "recording/crash_ring.h"
#include "session/backup_list.h"
#include "session/backup_schedule.h"
#include "session/loop_report.h"
#include "session/withdrawn_participants.h"

#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr int kNewest = 300;      // sessions in which to look for people who trained recently
constexpr std::size_t kShown = 8; // lines per list on the home screen
constexpr std::size_t kOwnShown = 5;
constexpr int kLookedThrough = 50; // of the newest sessions with comments

using database::Role;
using database::SessionFilter;
using database::SessionReader;

/// Who asks for what, and the names of people.
struct HomeReading {
    const HomeQuestion& question;
    const PeopleNames& names;

    SessionRow row(database::SessionSummary session) const {
        return makeSessionRow(std::move(session), question.titles, names);
    }
};

std::vector<SessionRow> rowsOf(std::vector<database::SessionSummary> sessions, const HomeReading& reading,
                               std::size_t most) {
    std::vector<SessionRow> rows;
    for (database::SessionSummary& session : sessions) {
        if (rows.size() == most)
            break;
        rows.push_back(reading.row(std::move(session)));
    }
    return rows;
}

core::Result<void> readCommented(database::Connection& connection, SessionReader& reader,
                                 const HomeReading& reading, HomeData& data) {
    const HomeQuestion& question = reading.question;
    auto sessions = reader.commentedSessions({.toRead = true, .most = kLookedThrough});
    CHIRON_TRY(sessions);
    const std::map<database::PersonId, std::string> names = shownNames(connection);
    for (database::CommentedSession& session : *sessions) {
        std::vector<database::PersonId> authors;
        for (const database::SessionComment& comment : session.comments)
            authors.push_back(comment.author);
        const bool own = session.session.person == question.actor.personId();
        const int upTo = newsUpTo(authors, question.actor.personId(), own);
        if (upTo == 0)
            continue;
        const auto name = names.find(authors[static_cast<std::size_t>(upTo) - 1]);
        data.commented.push_back({reading.row(std::move(session.session)),
                                  name == names.end() ? std::string() : name->second, upTo, own});
    }
    return {};
}

core::Result<void> readOwn(database::Connection& connection, SessionReader& reader,
                           const HomeReading& reading, HomeData& data) {
    const HomeQuestion& question = reading.question;
    SessionFilter filter;
    filter.person = question.actor.personId();
    filter.newestFirst = true;
    auto own = reader.listSessions(filter);
    CHIRON_TRY(own);
    data.standings = session::levelStandings(question.catalogue, *own);
    std::erase_if(*own, [](const auto& session) { return session.state == database::SessionState::running; });
    CHIRON_TRY(readCommented(connection, reader, reading, data));
    data.own = rowsOf(std::move(*own), reading, kOwnShown);
    return {};
}

std::vector<RecentPerson> recentPeople(const std::vector<database::SessionSummary>& newest,
                                       const PeopleNames& names) {
    const std::string weekAgo =
        QDateTime::currentDateTimeUtc().addDays(-7).toString(Qt::ISODateWithMs).toStdString();
    std::vector<RecentPerson> people;
    for (const database::SessionSummary& session : newest) {
        if (session.person == database::Actor::kSimulatedPerson)
            continue;
        auto found = std::find_if(people.begin(), people.end(),
                                  [&](const RecentPerson& p) { return p.person == session.person; });
        if (found == people.end()) {
            people.push_back(
                {session.person, QString::fromStdString(names.of(session)), session.startedUtc, 0});
            found = std::prev(people.end());
        }
        found->sessions += session.startedUtc >= weekAgo ? 1 : 0;
    }
    people.resize(std::min(people.size(), kShown));
    return people;
}

core::Result<void> readForTrainer(SessionReader& reader, const HomeReading& reading, HomeData& data) {
    SessionFilter filter;
    filter.newestFirst = true;
    filter.limit = kNewest;
    auto newest = reader.listSessions(filter);
    CHIRON_TRY(newest);
    data.people = recentPeople(*newest, reading.names);
    SessionFilter waiting;
    waiting.newestFirst = true;
    waiting.toReview = true;
    auto toReview = reader.listSessions(waiting);
    CHIRON_TRY(toReview);
    data.toReview = static_cast<int>(toReview->size());
    std::stable_sort(toReview->begin(), toReview->end(), [](const auto& a, const auto& b) {
        return session::attentionRank(a) < session::attentionRank(b);
    });
    data.toLook = rowsOf(std::move(*toReview), reading, kShown);
    return {};
}

core::Result<void> readForAdmin(database::Database& database, database::Connection& connection,
                                SessionReader& reader, const HomeQuestion& question, HomeData& data) {
    const auto people = database::AccountService(database).listPeople(question.actor);
    CHIRON_TRY(people);
    data.accounts = static_cast<int>(
        std::count_if(people->begin(), people->end(), [](const auto& person) { return person.enabled; }));
    const auto code = database::AccountService(database).hasRecoveryCode(question.actor);
    CHIRON_TRY(code);
    data.lacksRecoveryCode = !*code;
    database::StudyReader studies(connection, question.actor);
    const auto withdrawn = session::withdrawnParticipants(studies);
    CHIRON_TRY(withdrawn);
    data.toErase = static_cast<int>(std::count_if(withdrawn->begin(), withdrawn->end(), [](const auto& each) {
        return each.participant.recordingsToErase;
    }));
    data.room = session::storageRoom(question.databaseFile, recording::defaultRingFolder());
    auto standing = database::Upkeep::backupStanding(connection, question.actor);
    CHIRON_TRY(standing);
    data.backups = std::move(*standing);
    const auto backups = session::listBackups(
        session::folderOfPlan(data.backups.plan, question.backupFolder, question.databaseFile));
    data.latestBackupUtc = backups.empty() ? std::string() : backups.front().createdUtc;
    SessionFilter filter;
    filter.newestFirst = true;
    filter.limit = 1;
    const auto newest = reader.listSessions(filter);
    CHIRON_TRY(newest);
    if (newest->empty())
        return {};
    if (const auto record = reader.session(newest->front().id)) {
        const auto loop = session::loopReportFrom(record->loopJson);
        data.lastLoopTimed = loop && loop->realtime;
        data.lastLoopPriority = loop && loop->priorityGranted;
    }
    return {};
}

void readRecovered(SessionReader& reader, const HomeReading& reading, HomeData& data) {
    for (const session::RecoveredSession& recovered : reading.question.recovered) {
        auto record = reader.session(recovered.session);
        if (record) // otherwise it belongs to another person, who sees it after logging in
            data.recovered.push_back(
                {reading.row(std::move(record->summary)), recovered.framesFromRing, recovered.problem});
    }
}

} // namespace

core::Result<HomeData> readHome(database::Database& database, const HomeQuestion& question) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    SessionReader reader(**connection, question.actor);
    const auto self = database::AccountService(database).self(question.actor);
    CHIRON_TRY(self);
    const database::RoleSet& roles = self->roles; // as they are now
    const auto names = PeopleNames::read(**connection, question.actor);
    CHIRON_TRY(names);
    const HomeReading reading{question, *names};
    HomeData data;
    data.name = self->displayName.empty() ? self->name : self->displayName;
    core::Result<void> done;
    done = readOwn(**connection, reader, reading, data); // everybody may train
    if (done && roles.contains(Role::trainer))
        done = readForTrainer(reader, reading, data);
    if (done && roles.contains(Role::admin))
        done = readForAdmin(database, **connection, reader, question, data);
    CHIRON_TRY(done);
    readRecovered(reader, reading, data);
    return data;
}

} // namespace chiron::desktop
