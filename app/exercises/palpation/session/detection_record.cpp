// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/session/detection_record.h"

#include "curriculum/exercises/palpation/scoring/palpation_answer.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "session/level_cues.h"
#include "session/session_view.h"

#include <variant>

namespace chiron::session {

namespace {

bool isWanted(const database::SessionSummary& summary, const DetectionQuery& query) {
    return summary.felt == query.felt && summary.operatorName == query.operatorName &&
           !summary.familiarisation && !summary.recordingErased && summary.chunks > 0;
}

} // namespace

bool tellsDetection(const catalogue::ExerciseLevel& level, const DetectionQuery& query) {
    const auto* p = level.parameters.find<simulation::PalpationParameters>();
    if (p == nullptr || p->control.forceOff || p->control.moveAfter_s > 0.0)
        return false;
    return query.level > 0 || !cuesOf(level, query.felt).object;
}

void addDetection(PooledDetection& pooled, const scoring::SessionTrace& trace) {
    ++pooled.sessions;
    for (const scoring::TrialTrace& trial : trace.trials) {
        const scoring::JudgedTrial judged = scoring::judgePalpation(trial);
        if (!judged.answer) {
            ++pooled.unjudged;
            continue;
        }
        if (judged.answer->truth.introduction)
            continue;
        ++pooled.trials;
        pooled.ratings.add(judged.answer->regions);
    }
}

core::Result<PooledDetection> detectionOf(database::Connection& connection, const database::Actor& actor,
                                          const DetectionQuery& query, const ReadProgress& progress) {
    database::SessionFilter filter;
    filter.person = query.person;
    filter.exercise = "palpation";
    filter.state = database::SessionState::completed;
    if (query.level > 0)
        filter.level = query.level;
    auto sessions = database::SessionReader(connection, actor).listSessions(filter);
    CHIRON_TRY(sessions);
    PooledDetection pooled;
    std::size_t done = 0;
    for (const database::SessionSummary& summary : *sessions) {
        if (progress && !progress(static_cast<double>(done++) / static_cast<double>(sessions->size())))
            return core::fail(core::ErrorCode::cancelled, "detection: stopped by the person");
        if (!isWanted(summary, query))
            continue;
        auto stored = SessionView::open(connection, actor, summary.id);
        CHIRON_TRY(stored);
        if (!tellsDetection((*stored)->setup().level, query))
            continue;
        auto trace = (*stored)->trace();
        CHIRON_TRY(trace);
        addDetection(pooled, **trace);
    }
    return pooled;
}

} // namespace chiron::session
