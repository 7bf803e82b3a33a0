// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/live_sitting.h"

#include "session/study/begun_run.h"
#include "session/study/live_study.h"
#include "session/study/mark_sessions.h"

namespace chiron::session {

SittingResult<std::unique_ptr<LiveSitting>>
LiveSitting::start(database::Database& database, const database::Actor& actor, LiveStudyRequest request) {
    const auto sitting = conductSitting(database, actor, request);
    CHIRON_TRY(sitting);
    if (const MarkSessions* marks = markSessionsOf(*sitting->condition()))
        return marks->begin(database, actor, *sitting, std::move(request));
    return LiveStudy::start(database, actor, *sitting, std::move(request));
}

} // namespace chiron::session
