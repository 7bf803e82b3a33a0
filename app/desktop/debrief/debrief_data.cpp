// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/debrief_data.h"

#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "session/playback_builder.h"
#include "session_report/insertion_profile.h"
#include "session_report/session_report.h"
#include "session_report/track_series.h"

#include <algorithm>

namespace chiron::desktop {

core::Result<DebriefHead> loadDebriefHead(database::Connection& connection, const database::Actor& actor,
                                          database::SessionId session, const std::string& language) {
    database::SessionReader sessions(connection, actor);
    DebriefHead head;
    auto record = sessions.session(session);
    if (!record)
        return tl::unexpected(record.error());
    head.record = std::move(*record);
    auto setup = session::setupFromStored(head.record.setup);
    if (!setup)
        return tl::unexpected(setup.error());
    head.setup = std::move(*setup);
    auto report = session_report::reportHeadOf(head.record, head.setup, connection, actor, language);
    if (!report)
        return tl::unexpected(report.error());
    head.report = std::move(*report);
    auto trials = sessions.trials(session);
    if (!trials)
        return tl::unexpected(trials.error());
    head.trialsDone = static_cast<int>(std::count_if(trials->begin(), trials->end(), [](const database::TrialRecord& trial) {
        return trial.marked || trial.timedOut;
    }));
    return head;
}

core::Result<DebriefDetails> loadDebriefDetails(database::Connection& connection, const database::Actor& actor,
                                                database::SessionId session, const std::atomic<bool>& cancelled) {
    auto stored = session::StoredSession::open(connection, actor, session);
    if (!stored)
        return tl::unexpected(stored.error());
    auto track = session::buildPlaybackTrack(**stored, [&cancelled](double) { return !cancelled.load(); });
    if (!track)
        return tl::unexpected(track.error());
    DebriefDetails details;
    details.answers = session_report::apexErrorsOf(*track);
    details.insertion = session_report::insertionProfileOf(*track);
    if (std::holds_alternative<simulation::PalpationParameters>((*stored)->setup().level.parameters)) {
        if (auto records = session::palpationRecord(**stored))
            details.palpation = std::move(*records);
        else
            details.palpationLost = std::move(records.error());
    }
    details.duration_s = track->duration_s;
    auto card = database::ScoreRepository(connection, actor).scores(session);
    if (!card && card.error().code != core::ErrorCode::notFound)
        return tl::unexpected(card.error());
    details.worst = session::worstMoment(*track, card ? *card : scoring::ScoreCard{}, (*stored)->setup().level.gates);
    return details;
}

core::Result<report::ReportData> loadReport(database::Connection& connection, const database::Actor& actor,
                                            database::SessionId session, const std::string& language) {
    auto stored = session::StoredSession::open(connection, actor, session);
    if (!stored)
        return tl::unexpected(stored.error());
    return session_report::reportDataOf(**stored, connection, actor, language);
}

} // namespace chiron::desktop
