// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/debrief_data.h"

#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "desktop/sessions/people_names.h"
#include "session/level_standing.h"
#include "session/session_view.h"
#include "session_report/session_report.h"

#include <algorithm>

namespace chiron::desktop {

namespace {

/// Values of the latest earlier attempt that is comparable with this one.
core::Result<std::map<std::string, double>> valuesBefore(database::Connection& connection,
                                                         const database::Actor& actor,
                                                         const database::SessionSummary& now) {
    std::map<std::string, double> values;
    if (now.person == database::Actor::kSimulatedPerson ||
        !session::countsAsAttempt(now)) // a demonstration is nobody's attempt
        return values;
    database::SessionFilter filter;
    filter.person = now.person;
    filter.exercise = now.exercise;
    filter.level = now.level;
    auto listed = database::SessionReader(connection, actor).listSessions(filter);
    CHIRON_TRY(listed);
    std::optional<database::SessionId> latest;
    for (const database::SessionSummary& other : *listed)
        if (other.id < now.id && other.felt == now.felt && other.state == database::SessionState::completed &&
            session::countsAsAttempt(other))
            latest = std::max(latest.value_or(0), other.id);
    if (!latest)
        return values;
    const auto card = database::ScoreRepository(connection, actor).scores(*latest);
    if (core::failedAs(card, core::ErrorCode::notFound))
        return values;
    CHIRON_TRY(card);
    for (const scoring::MetricValue& metric : card->metrics)
        if (metric.value)
            values.emplace(metric.id, *metric.value);
    return values;
}

} // namespace

QString commentsSeenKey(database::SessionId session) {
    return QStringLiteral("comments_seen_%1").arg(session);
}

core::Result<DebriefHead> loadDebriefHead(database::Connection& connection, const database::Actor& actor,
                                          database::SessionId session, const std::string& language) {
    database::SessionReader sessions(connection, actor);
    DebriefHead head;
    auto record = sessions.session(session);
    CHIRON_TRY(record);
    head.record = std::move(*record);
    const auto names = PeopleNames::read(connection, actor);
    CHIRON_TRY(names);
    head.record.summary.personName = names->of(head.record.summary);
    auto setup = session::setupFromStored(head.record.setup);
    CHIRON_TRY(setup);
    head.setup = std::move(*setup);
    const auto face = exerciseFace(head.setup.level.exercise);
    CHIRON_TRY(face);
    head.face = *face;
    auto report = session_report::reportHeadOf(head.record, head.setup, connection, actor, language);
    CHIRON_TRY(report);
    head.report = std::move(*report);
    if (!head.report.metrics.empty()) {
        auto before = valuesBefore(connection, actor, head.record.summary);
        CHIRON_TRY(before);
        head.before = std::move(*before);
    }
    auto comments = loadComments(connection, actor, session);
    CHIRON_TRY(comments);
    head.comments = std::move(*comments);
    if (!head.record.decisions.empty())
        head.deciders = shownNames(connection);
    return head;
}

core::Result<DebriefDetails> loadDebriefDetails(database::Connection& connection,
                                                const database::Actor& actor, database::SessionId session,
                                                const std::atomic<bool>& cancelled) {
    auto stored = session::SessionView::open(connection, actor, session);
    CHIRON_TRY(stored);
    return debriefDetailsOf(**stored, connection, actor, cancelled);
}

core::Result<DebriefDetails> debriefDetailsOf(session::SessionView& session, database::Connection& connection,
                                              const database::Actor& actor,
                                              const std::atomic<bool>& cancelled) {
    CHIRON_TRY(session.decode([&cancelled](double) { return !cancelled.load(); }));
    const session::PlaybackTrack& track = **session.track();
    const scoring::SessionTrace& trace = **session.trace();
    DebriefDetails details;
    const catalogue::ExerciseLevel& level = session.setup().level;
    const auto face = exerciseFace(level.exercise);
    CHIRON_TRY(face);
    details.part = (*face)->readDebrief(level, trace);
    details.force = session_report::feltFactsOf(trace);
    details.duration_s = track.duration_s;
    const database::SessionId id = session.record().summary.id;
    auto comments = loadComments(connection, actor, id);
    CHIRON_TRY(comments);
    for (NamedComment& named : *comments) {
        const auto tick = named.comment.tick;
        details.comments.push_back(
            {std::move(named), tick ? std::optional(track.timeOfTick(*tick)) : std::nullopt});
    }
    details.trials = track.trials;
    std::stable_sort(details.comments.begin(), details.comments.end(),
                     [](const auto& a, const auto& b) { return a.t_s < b.t_s; });
    auto card = database::ScoreRepository(connection, actor).scores(id);
    if (!core::failedAs(card, core::ErrorCode::notFound))
        CHIRON_TRY(card);
    const bool judged = session.record().summary.state == database::SessionState::completed;
    const scoring::ScoreCard judgedBy = card && judged ? *card : scoring::ScoreCard{};
    details.worst = session::worstMoment(track, judgedBy, level.gates);
    details.missed = session::momentsOfFailedGates(track, judgedBy, level.gates);
    return details;
}

core::Result<report::ReportData> loadReport(database::Connection& connection, const database::Actor& actor,
                                            database::SessionId session, const std::string& language) {
    auto stored = session::SessionView::open(connection, actor, session);
    CHIRON_TRY(stored);
    return session_report::reportDataOf(**stored, connection, actor, language);
}

} // namespace chiron::desktop
