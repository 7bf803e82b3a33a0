// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/playback_data.h"

#include "database/repositories/account_repository.h"
#include "database/repositories/score_repository.h"
#include "desktop/exercise_face.h"
#include "desktop/sessions/people_names.h"
#include "session/session_view.h"

#include <algorithm>
#include <map>

namespace chiron::desktop {

namespace {

constexpr std::size_t kMostGhosts = 40;

std::optional<double> metricOf(database::Connection& connection, const database::Actor& actor,
                               database::SessionId session, const std::string& metric) {
    const auto card = database::ScoreRepository(connection, actor).scores(session);
    if (!card)
        return std::nullopt; // without a score it cannot be the best
    for (const scoring::MetricValue& value : card->metrics)
        if (value.id == metric)
            return value.value;
    return std::nullopt;
}

GhostCandidate* bestOf(std::vector<GhostCandidate>& own, database::Connection& connection,
                       const database::Actor& actor, const std::string& metric, bool lowerIsBetter) {
    GhostCandidate* best = nullptr;
    double bestValue = 0.0;
    for (GhostCandidate& candidate : own) {
        const auto value = metricOf(connection, actor, candidate.summary.id, metric);
        if (value && (!best || (lowerIsBetter ? *value < bestValue : *value > bestValue))) {
            best = &candidate;
            bestValue = *value;
        }
    }
    return best;
}

} // namespace

core::Result<PlaybackData> loadPlayback(database::Connection& connection, const database::Actor& actor,
                                        database::SessionId session,
                                        const std::function<bool(double)>& progress) {
    PlaybackData data;
    auto record = database::SessionReader(connection, actor).session(session);
    CHIRON_TRY(record);
    data.record = std::move(*record);
    const auto names = PeopleNames::read(connection, actor);
    CHIRON_TRY(names);
    data.record.summary.personName = names->of(data.record.summary);
    auto setup = session::setupFromStored(data.record.setup);
    CHIRON_TRY(setup);
    data.setup = std::move(*setup);
    if (data.record.summary.recordingErased)
        return data;
    auto stored = session::SessionView::open(connection, actor, session);
    CHIRON_TRY(stored);
    CHIRON_TRY(addRecording(data, **stored, progress));
    return data;
}

core::Result<void> addRecording(PlaybackData& data, session::SessionView& session,
                                const session::ReadProgress& progress) {
    CHIRON_TRY(session.decode(progress));
    data.track = **session.track();
    const auto face = exerciseFace(data.setup.level.exercise);
    CHIRON_TRY(face);
    data.layer = (*face)->playbackLayer(data.setup, **session.trace());
    return {};
}

core::Result<std::vector<GhostCandidate>> listGhosts(database::Connection& connection,
                                                     const database::Actor& actor,
                                                     const database::SessionRecord& record,
                                                     const std::string& mainMetric, bool lowerIsBetter) {
    database::SessionFilter filter;
    filter.exercise = record.summary.exercise;
    filter.level = record.summary.level;
    filter.state = database::SessionState::completed;
    auto sessions = database::SessionReader(connection, actor).listSessions(filter);
    CHIRON_TRY(sessions);
    const auto names = PeopleNames::read(connection, actor);
    CHIRON_TRY(names);
    std::vector<GhostCandidate> own;
    std::vector<GhostCandidate> scripted;
    std::vector<GhostCandidate> others;
    for (database::SessionSummary& summary : *sessions) {
        summary.personName = names->of(summary);
        if (summary.id == record.summary.id || summary.recordingErased || summary.felt != record.summary.felt)
            continue;
        if (!summary.operatorName.empty())
            scripted.push_back({summary, GhostRole::scripted});
        else if (summary.person == record.summary.person)
            own.push_back({summary, GhostRole::other});
        else
            others.push_back({summary, GhostRole::other});
    }
    if (!own.empty()) {
        if (GhostCandidate* best = bestOf(own, connection, actor, mainMetric, lowerIsBetter))
            best->role = GhostRole::ownBest;
        own.front().role = GhostRole::ownFirst; // sessions are in the order of their numbers
    }
    std::stable_sort(own.begin(), own.end(),
                     [](const GhostCandidate& a, const GhostCandidate& b) { return a.role < b.role; });
    std::reverse(others.begin(), others.end());
    own.insert(own.end(), scripted.begin(), scripted.end());
    own.insert(own.end(), others.begin(), others.end());
    if (own.size() > kMostGhosts)
        own.resize(kMostGhosts);
    return own;
}

std::map<database::PersonId, std::string> shownNames(database::Connection& connection) {
    std::map<database::PersonId, std::string> names;
    if (auto people = database::AccountRepository(connection, database::Actor::anonymous()).listLoginNames())
        for (const database::LoginName& person : *people)
            names[person.id] = person.displayName.empty() ? person.name : person.displayName;
    return names;
}

core::Result<std::vector<NamedComment>>
loadComments(database::Connection& connection, const database::Actor& actor, database::SessionId session) {
    auto comments = database::SessionReader(connection, actor).comments(session);
    CHIRON_TRY(comments);
    std::map<database::PersonId, std::string> names = shownNames(connection);
    std::vector<NamedComment> named;
    for (const database::SessionComment& comment : *comments)
        named.push_back({comment, names.count(comment.author) ? names[comment.author] : std::string()});
    return named;
}

} // namespace chiron::desktop
