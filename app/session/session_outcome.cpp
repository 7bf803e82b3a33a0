// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_outcome.h"

#include "database/repositories/score_repository.h"
#include "database/repositories/session_repository.h"
#include "session/exercise_kind.h"
#include "session/session_view.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <memory>

namespace chiron::session {

namespace {

using database::SessionState;

SessionState stateOf(const SessionEvents& seen, const RunEnding& ending) {
    if (ending.interrupted)
        return SessionState::interrupted;
    if (ending.dropped > 0)
        return SessionState::incomplete;
    if (seen.finished)
        return SessionState::completed;
    return seen.faulted ? SessionState::faulted : SessionState::stopped;
}

/// A trial without an end gets its state from the session's.
database::TrialRecord withFate(database::TrialRecord trial, SessionState session) {
    if (trial.state == SessionState::running)
        trial.state = session == SessionState::completed ? SessionState::stopped : session;
    return trial;
}

std::string truthJson(const ExerciseKind& kind, const scoring::TrialTrace& trial) {
    QJsonObject truth;
    kind.storeTruth(trial, truth);
    if (!trial.truth.empty()) {
        truth.insert("completed", trial.completed);
        truth.insert("failed", trial.failed);
        for (const scoring::NamedValue& value : trial.truth)
            truth.insert(QString::fromStdString(value.id), value.value);
    }
    return QJsonDocument(truth).toJson(QJsonDocument::Compact).toStdString();
}

/// The data that the last transaction of a session stores.
struct Conclusion {
    SessionState state = SessionState::completed;
    const ExerciseKind* kind = nullptr;
    std::shared_ptr<const SessionEvents> seen;
    std::shared_ptr<const scoring::SessionTrace> trace; ///< the truth of each trial is stored with its row
    core::Result<scoring::ScoreCard> card;
};

core::Result<Conclusion> conclude(SessionView& stored, const RunEnding& ending) {
    const auto kind = exerciseKind(stored.setup().level.exercise);
    CHIRON_TRY(kind);
    auto seen = stored.events();
    CHIRON_TRY(seen);
    auto trace = stored.trace();
    CHIRON_TRY(trace);
    const SessionState state = stateOf(**seen, ending);
    auto card = stored.scoresOf(**trace, state == SessionState::completed);
    return Conclusion{state, *kind, std::move(*seen), std::move(*trace), std::move(card)};
}

core::Result<void> storeEnd(database::WriteContext& context, const database::Actor& actor,
                            database::SessionId id, const Conclusion& conclusion, const RunEnding& ending) {
    const SessionEvents& seen = *conclusion.seen;
    database::SessionRepository sessions(context.connection(), actor);
    for (std::size_t i = 0; i < seen.trials.size(); ++i) {
        database::TrialRecord trial = withFate(seen.trials[i], conclusion.state);
        if (i < conclusion.trace->trials.size())
            trial.sceneJson = truthJson(*conclusion.kind, conclusion.trace->trials[i]);
        CHIRON_TRY(sessions.storeTrial(id, trial));
    }
    CHIRON_TRY(sessions.storeEvents(id, seen.events));
    database::SessionEnd end;
    end.state = conclusion.state;
    end.frames = seen.frames;
    end.ticks = seen.frames > 0 ? seen.lastTick + 1 : 0;
    end.dropped = ending.dropped;
    end.loopJson = ending.loopJson;
    return sessions.finishSession(id, end);
}

} // namespace

core::Result<scoring::ScoreCard> concludeSession(database::Database& database, const database::Actor& actor,
                                                 database::SessionId session, const RunEnding& ending) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    // The program ends every session that it recorded, including one of a blinded study, which nobody may
    // open; hence the maintenance actor. The results are stored on behalf of the session's actor.
    auto stored = SessionView::open(**connection, database::Actor::maintenance(), session);
    CHIRON_TRY(stored);
    auto conclusion = conclude(**stored, ending);
    CHIRON_TRY(conclusion);
    // In one transaction, so that a program killed here leaves a session that either needs recovery or has
    // its scores.
    auto done = database.write([&](database::WriteContext& context) -> core::Result<void> {
        if (auto ended = storeEnd(context, actor, session, *conclusion, ending); !ended || !conclusion->card)
            return ended;
        auto kept =
            database::ScoreRepository(context.connection(), actor).storeScores(session, *conclusion->card);
        CHIRON_TRY(kept);
        return {};
    });
    CHIRON_TRY(done);
    return std::move(conclusion->card);
}

} // namespace chiron::session
