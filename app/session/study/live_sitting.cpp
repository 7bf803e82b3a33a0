// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/live_sitting.h"

#include "app/exercises/sphere_apex/session/apex_sitting.h"
#include "session/study/begun_run.h"
#include "app/exercises/sphere_apex/session/live_apex.h"
#include "session/study/live_study.h"

namespace chiron::session {

SittingResult<std::unique_ptr<LiveSitting>> LiveSitting::start(database::Database& database, const database::Actor& actor,
                                                               LiveStudyRequest request) {
    const auto sitting = conductSitting(database, actor, request);
    if (!sitting)
        return tl::unexpected(sitting.error());
    if (looksForApex(*sitting->condition()))
        return LiveApex::start(database, actor, *sitting, std::move(request));
    return LiveStudy::start(database, actor, *sitting, std::move(request));
}

} // namespace chiron::session
