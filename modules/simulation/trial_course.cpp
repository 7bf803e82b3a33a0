// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/trial_course.h"

#include "core/units.h"

#include <algorithm>

namespace chiron::simulation {

using core::TrialPhase;
namespace bits = core::event_bits;

TrialCourse::Turn TrialCourse::advance(const SceneInput& in, SceneOutput& out) noexcept {
    const bool next = m_phase != TrialPhase::idle || in.started;
    return advance(Signals{.paused = in.paused, .forceReady = in.forceReady, .next = next}, out);
}

TrialCourse::Turn TrialCourse::advance(const Signals& now, SceneOutput& out) noexcept {
    if (now.paused)
        return Turn::waits;
    switch (m_phase) {
    case TrialPhase::idle:
    case TrialPhase::between:
        if (now.stop)
            finish(out);
        else if (now.next && (m_phase == TrialPhase::idle || m_clock >= m_betweenTicks))
            return prepare(out);
        else
            ++m_clock;
        return Turn::waits;
    case TrialPhase::ready:
        if (now.forceReady) {
            m_phase = TrialPhase::running;
            out.events |= bits::kTrialStarted;
            break;
        }
        return now.stop ? leave(true, out) : Turn::waits;
    case TrialPhase::running:
        if (m_over)
            return leave(now.stop, out);
        break;
    case TrialPhase::finished:
        ++m_clock;
        return Turn::waits;
    }
    ++m_clock;
    return Turn::runs;
}

TrialCourse::Turn TrialCourse::prepare(SceneOutput& out) noexcept {
    m_trial += m_phase == TrialPhase::between ? 1 : 0;
    m_phase = TrialPhase::ready;
    m_clock = 0;
    m_over = false;
    out.events |= bits::kSceneChanged;
    return Turn::prepares;
}

TrialCourse::Turn TrialCourse::leave(bool stop, SceneOutput& out) noexcept {
    m_clock = 1; // this tick is the first of the interval
    if (stop || m_trial + 1 >= m_trials)
        finish(out);
    else
        m_phase = TrialPhase::between;
    return Turn::leaves;
}

void TrialCourse::finish(SceneOutput& out) noexcept {
    m_phase = TrialPhase::finished;
    out.events |= bits::kFinished;
}

void TrialCourse::end(std::uint32_t event, SceneOutput& out) noexcept {
    out.events |= event;
    m_over = true;
}

void TrialCourse::write(const SceneInput& in, SceneOutput& out) const noexcept {
    out.trial = out.cues.trial = static_cast<std::uint16_t>(m_trial);
    out.phase = out.cues.phase = m_phase;
    out.cues.force = in.force;
}

double TrialCourse::timeLeft_s() const noexcept {
    return static_cast<double>(m_limitTicks - std::min(m_limitTicks, m_clock)) * core::kTickSeconds;
}

} // namespace chiron::simulation
