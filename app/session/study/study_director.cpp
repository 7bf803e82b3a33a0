// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_director.h"

#include "core/presentation_word.h"
#include "core/units.h"
#include "simulation/comparison/comparison_parameters.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

using core::CommandKind;
using core::TrialPhase;
using psychophysics::Task;

bool StudyDirector::tryPush(const core::HapticFrame& frame) noexcept {
    ++m_ticks;
    if (m_inputs && !m_over)
        direct(fidelitySampleOf(frame));
    return true;
}

void StudyDirector::direct(const FidelitySample& sample) {
    constexpr std::uint32_t kEnds =
        core::event_bits::kCompleted | core::event_bits::kTimedOut | core::event_bits::kFailed;
    if (sample.events & core::event_bits::kTrialStarted) {
        m_clock.begin(sample.tick);
        m_looked = sample.tick;
    }
    m_clock.take(sample, sample.place != 0);
    m_parts.meter.add(sample);
    if (m_presented && (sample.events & kEnds)) {
        endTrial(sample);
        return;
    }
    if (!m_presented && (sample.phase == TrialPhase::idle || sample.phase == TrialPhase::between)) {
        present();
        return;
    }
    if (sample.phase != TrialPhase::running || m_answered || !m_presented)
        return;
    const bool tooLong = static_cast<double>(sample.tick - m_looked) * core::kTickSeconds > kPatience_s;
    if (!m_parts.mind.explored() && !tooLong)
        return;
    const auto felt = tooLong ? std::nullopt : feel();
    if (felt && turned(*felt, sample))
        return;
    const std::optional<int> said = felt ? think(*felt) : std::nullopt;
    m_answered = true;
    m_answer = said.value_or(-1);
    if (!said)
        m_spoiled = tooLong ? "time" : "untouched";
    m_inputs->postOwn(
        {CommandKind::answer, said ? static_cast<std::uint16_t>(*said) : simulation::kAnswerSpoiled});
}

/// The felt value at each place, log10 relative to the reference; empty if a place could not be felt.
std::optional<std::vector<double>> StudyDirector::feel() const {
    std::vector<double> felt;
    for (std::size_t place = 0; place < m_shown.values.size(); ++place) {
        const double estimate = m_parts.mind.estimate(static_cast<int>(place));
        if (!(estimate > 0.0))
            return std::nullopt;
        felt.push_back(std::log10(estimate / m_parts.condition.stimulus.reference));
    }
    return felt;
}

/// Adjustment: turns the dial by the felt difference and explores again. Returns false if the dial does not
/// move, or there is no time for another exploration.
bool StudyDirector::turned(const std::vector<double>& felt, const FidelitySample& sample) {
    const auto& table = m_parts.condition.stimulus.differences;
    if (m_parts.condition.task != Task::adjustment || table.empty())
        return false;
    if (!m_equal)
        m_equal = m_parts.observer.adjust(table.front(), table.back());
    const double limit_s = m_parts.exploreLimit_s;
    // The duration with one more exploration.
    const auto ticks = static_cast<double>((sample.tick - m_clock.first()) + (sample.tick - m_looked));
    if (m_steps >= kSteps || (limit_s > 0.0 && ticks * core::kTickSeconds > limit_s))
        return false;
    const double wanted = table[static_cast<std::size_t>(m_dial)] - (felt.back() - felt.front() - *m_equal);
    const int next = m_parts.progress.presentable(wanted);
    if (next == m_dial)
        return false;
    m_dial = next;
    ++m_steps;
    m_looked = sample.tick;
    m_parts.mind.again();
    m_inputs->postOwn({CommandKind::present, core::encode({m_dial, m_shown.arrangement})});
    return true;
}

/// The observer's answer to the felt values.
std::optional<int> StudyDirector::think(const std::vector<double>& felt) {
    const psychophysics::StimulusDesign& stimulus = m_parts.condition.stimulus;
    const Task task = m_parts.condition.task;
    if (task == Task::magnitude)
        m_value = m_parts.observer.magnitude(felt.front());
    if (task == Task::adjustment)
        m_value = stimulus.reference * std::pow(10.0, stimulus.differences[static_cast<std::size_t>(m_dial)]);
    return m_parts.observer.answer(task, felt);
}

void StudyDirector::present() {
    StudyProgress& progress = m_parts.progress;
    if (progress.breakDue())
        progress.breakTaken();
    if (progress.needsExperimenter())
        // Nobody is present to help, so the run stops.
        progress.experimenterSays(false);
    if (progress.done()) {
        finish();
        return;
    }
    m_shown = progress.next();
    m_parts.meter.begin(m_shown.values);
    m_presented = true;
    m_answered = false;
    m_answer = -1;
    m_value.reset();
    m_equal.reset();
    m_dial = m_shown.candidate;
    m_steps = 0;
    m_spoiled.clear();
    m_inputs->postOwn({CommandKind::present, core::encode({m_shown.candidate, m_shown.arrangement})});
}

void StudyDirector::endTrial(const FidelitySample& sample) {
    m_presented = false;
    StudyAnswer answer;
    answer.answer = m_answer;
    answer.value = m_value;
    answer.session = m_session;
    answer.firstTick = m_clock.first();
    answer.lastTick = sample.tick;
    answer.exploration_s = m_clock.exploration_s();
    answer.answer_s = m_clock.sinceContact_s();
    answer.fidelity = m_parts.meter.finish();
    answer.spoiled = m_spoiled;
    auto trial = m_parts.progress.record(answer);
    if (!trial)
        m_recorded = tl::unexpected(trial.error());
    if (!trial || !m_parts.store(std::move(*trial)) || (m_parts.interrupted && m_parts.interrupted()))
        finish();
}

void StudyDirector::finish() {
    m_over = true;
    m_inputs->postOwn({CommandKind::answer, simulation::kAnswerFinish});
}

} // namespace chiron::session
