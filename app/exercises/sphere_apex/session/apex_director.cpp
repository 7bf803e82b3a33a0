// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/session/apex_director.h"

namespace chiron::session {

core::Result<std::unique_ptr<ApexDirector>> ApexDirector::create(const catalogue::ExerciseLevel& level,
                                                                 std::uint64_t seed, const Station& station,
                                                                 Parts parts) {
    const auto kind = exerciseKind(level.exercise);
    CHIRON_TRY(kind);
    auto watch = ApexWatch::create(level, seed, station, parts.design);
    CHIRON_TRY(watch);
    std::unique_ptr<ApexDirector> director(new ApexDirector(std::move(parts), std::move(*watch)));
    director->m_tickLimit = (*kind)->tickLimit(level);
    return director;
}

bool ApexDirector::tryPush(const core::HapticFrame& frame) noexcept {
    ++m_ticks;
    if (m_inputs && !m_over)
        direct(frame);
    return true;
}

void ApexDirector::direct(const core::HapticFrame& frame) {
    if (const auto answer = m_watch.take(fidelitySampleOf(frame), frame.tool[0]))
        record(*answer);
    const bool cancelled = m_parts.cancel && m_parts.cancel->load(std::memory_order_relaxed);
    if (!m_over && (cancelled || m_ticks >= m_tickLimit)) // otherwise a hand that is stuck would run for ever
        finish();
}

void ApexDirector::record(const StudyAnswer& answer) {
    // If the trial has no mark, the time was up and its reason is "time".
    auto stored = m_parts.progress.record(answer);
    if (!stored)
        m_recorded = tl::unexpected(stored.error());
    const bool kept = stored && m_parts.store(std::move(*stored));
    if (m_parts.progress.needsExperimenter())
        // Nobody is present to help, so the run stops.
        m_parts.progress.experimenterSays(false);
    if (!kept || (m_parts.progress.done() && !m_watch.over()))
        finish();
}

void ApexDirector::finish() {
    m_over = true;
    m_inputs->postOwn({core::CommandKind::end});
}

} // namespace chiron::session
